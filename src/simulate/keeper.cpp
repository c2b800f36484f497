#include "simulate/keeper.hpp"

namespace bioprint {
namespace {

/// What a checkpoint must agree in to be resumed: the same scene on the same lattice.
std::vector<double> fingerprint(const Scene& s, const SimulationOptions& o) {
    return {static_cast<double>(s.kind),
            s.ink.eta0,
            s.ink.eta_inf,
            s.ink.time_constant,
            s.ink.alpha,
            s.nozzle_radius,
            s.velocity_average,
            s.cell.radius,
            s.cell.shear_modulus,
            static_cast<double>(s.drive),
            s.offset,
            s.fluid_stress,
            o.resolution,
            o.estimate_error ? 1.0 : 0.0,
            o.accuracy,
            o.settle_tolerance,
            o.channel_time,
            static_cast<double>(o.coupling),
            o.bulk_modulus_ratio,
            o.mesh_spacing};
}

}  // namespace

double Record::next() {
    if (at_ >= values_.size()) {
        throw DataError("the checkpoint is cut short");
    }
    return values_[at_++];
}

std::span<const double> Record::next_list() {
    const double size = next();
    if (!(size >= 0.0) || size > static_cast<double>(values_.size() - at_)) {
        throw DataError("the checkpoint is cut short");
    }
    const std::span<const double> list(values_.data() + at_, static_cast<std::size_t>(size));
    at_ += list.size();
    return list;
}

std::array<double, 3> Record::next_three() {
    const std::span<const double> list = next_list();
    if (list.size() != 3) {
        throw DataError("the checkpoint is cut short");
    }
    return {list[0], list[1], list[2]};
}

Keeper::Keeper(const Scene& scene, const SimulationOptions& options) : options_(options) {
    const std::vector<double> own = fingerprint(scene, options);
    if (options.resume != nullptr) {
        const auto other = options.resume->parts.find("scene");
        if (other == options.resume->parts.end() || other->second != own) {
            throw UsageError("--resume: the checkpoint is of another scene or resolution", "--resume");
        }
        state_ = *options.resume;
        if (const auto* spent = found("elapsed"); spent != nullptr && !spent->empty()) {
            before_ = spent->front();
        }
    }
    state_.parts["scene"] = own;
}

double Keeper::elapsed() const {
    return before_ + std::chrono::duration<double>(std::chrono::steady_clock::now() - begin_).count();
}

void Keeper::hand_out() {
    state_.parts["elapsed"] = {elapsed()};
    options_.checkpoint(state_);
}

void Keeper::put(const std::string& stage, const Record& record, bool due) {
    const std::lock_guard lock(mutex_);
    state_.parts[stage] = record.values();
    if (due) {
        hand_out();
    }
}

void Keeper::close() {
    if (options_.checkpoint) {
        const std::lock_guard lock(mutex_);
        hand_out();
    }
}

const std::vector<double>* Keeper::found(const std::string& stage) const {
    if (options_.resume == nullptr) {
        return nullptr;
    }
    const auto part = options_.resume->parts.find(stage);
    return part == options_.resume->parts.end() ? nullptr : &part->second;
}

}  // namespace bioprint
