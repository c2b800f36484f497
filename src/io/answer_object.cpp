#include "io/answer_object.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "bioprint/errors.hpp"
#include "bioprint/io/answer.hpp"
#include "io/published_limits.hpp"

namespace bioprint {
namespace {

/// Objects are built by appending: an initializer list would copy every value, and rows are many.
class ObjectBuilder {
  public:
    ObjectBuilder() { members_.reserve(12); }
    ObjectBuilder& add(const char* name, Json value) {
        members_.emplace_back(name, std::move(value));
        return *this;
    }
    Json take() {
        Json object = Json::object();
        object.get_ref<Json::object_t&>().swap(members_);
        return object;
    }

  private:
    Json::object_t members_;
};

Json number(double value) {
    return std::isfinite(value) ? Json(value) : Json(nullptr);
}

Json number(const std::optional<double>& value) {
    return value ? number(*value) : Json(nullptr);
}

/// A shape that does not exist keeps its three places, so that paths and CSV columns never move.
Json numbers(const std::optional<std::array<double, 3>>& values) {
    if (!values) return Json::array({nullptr, nullptr, nullptr});
    return Json::array({number((*values)[0]), number((*values)[1]), number((*values)[2])});
}

Json numbers(const std::vector<double>& values) {
    Json list = Json::array();
    for (const double value : values) list.push_back(number(value));
    return list;
}

Json program_object() {
    return {{"name", program_name}, {"version", program_version()}};
}

void add_law(ObjectBuilder& object, const CrossInk& law) {
    object.add("eta0", number(law.eta0))
        .add("eta_inf", number(law.eta_inf))
        .add("time_constant", number(law.time_constant))
        .add("alpha", number(law.alpha));
}

void add_law(ObjectBuilder& object, const PowerLawInk& law) {
    object.add("consistency", number(law.consistency)).add("flow_index", number(law.flow_index));
}

void add_law(ObjectBuilder& object, const CarreauYasudaInk& law) {
    object.add("eta0", number(law.eta0))
        .add("eta_inf", number(law.eta_inf))
        .add("time_constant", number(law.time_constant))
        .add("transition", number(law.transition))
        .add("flow_index", number(law.flow_index));
}

void add_law(ObjectBuilder& object, const HerschelBulkleyInk& law) {
    object.add("yield_stress", number(law.yield_stress))
        .add("consistency", number(law.consistency))
        .add("flow_index", number(law.flow_index));
}

Json ink_object(const InkChoice& ink) {
    ObjectBuilder object;
    object.add("name", ink.name).add("source", ink.source).add("law", law_name(ink.law));
    std::visit([&](const auto& law) { add_law(object, law); }, ink.law);
    return object.take();
}

Json cell_input_object(const CellChoice& cell) {
    return ObjectBuilder()
        .add("name", cell.name)
        .add("source", cell.source)
        .add("radius", number(cell.radius))
        .add("shear_modulus", number(cell.shear_modulus))
        .add("poisson_ratio", number(cell.poisson_ratio))
        .add("viscosity_ratio", number(cell.viscosity_ratio))
        .take();
}

Json input_object(const Prediction& prediction) {
    const Case& question = prediction.question;
    Json offsets = Json::array();
    for (const CellPosition& position : question.positions) offsets.push_back(number(position.value));
    ObjectBuilder input;
    input.add("radius", number(question.radius))
        .add("length", number(question.length))
        .add("flow_rate", number(prediction.nozzle.flow_rate))
        .add("ink", ink_object(question.ink))
        .add("cell", cell_input_object(question.cell))
        .add("offsets", std::move(offsets));
    if (question.needle) {
        input.add("needle", {{"name", question.needle->name}, {"source", question.needle->source}});
    }
    return input.take();
}

Json nozzle_object(const NozzleAnswer& nozzle) {
    ObjectBuilder object;
    object.add("flow_rate", number(nozzle.flow_rate))
        .add("pressure_gradient", number(nozzle.pressure_gradient))
        .add("velocity_average", number(nozzle.velocity_average))
        .add("velocity_max", number(nozzle.velocity_max))
        .add("shear_rate_max", number(nozzle.shear_rate_max))
        .add("shear_rate_average", number(nozzle.shear_rate_average))
        .add("stress_max", number(nozzle.stress_max))
        .add("stress_average", number(nozzle.stress_average))
        .add("viscosity_wall", number(nozzle.viscosity_wall))
        .add("pressure_drop", number(nozzle.pressure_drop))
        .add("residence_time", number(nozzle.residence_time));
    if (nozzle.plug_radius) object.add("plug_radius", number(nozzle.plug_radius));
    return object.add("error", number(nozzle.error)).take();
}

std::string_view model_name(Model model) {
    switch (model) {
        case Model::bullet:
            return "bullet";
        case Model::roscoe_shear:
            return "roscoe-shear";
        case Model::roscoe_elongation:
            return "roscoe-elongation";
        case Model::ellipsoid:
            return "ellipsoid";
    }
    return "";
}

Json cell_object(const CellAnswer& cell) {
    const auto part = [&](auto member) {
        return cell.stress ? std::optional((*cell.stress).*member) : std::nullopt;
    };
    ObjectBuilder object;
    object.add("place", cell.place == Place::nozzle ? "nozzle" : "exit")
        .add("model", model_name(cell.model))
        .add("offset", number(cell.offset))
        .add("offset_in_cell_radii", number(cell.offset_in_cell_radii))
        .add("fluid_stress", number(cell.fluid_stress))
        .add("stress_ratio", number(cell.stress_ratio))
        .add("stretch", numbers(cell.stretch))
        .add("angle", number(cell.angle))
        .add("frequency", number(cell.frequency))
        .add("stress", ObjectBuilder()
                           .add("von_mises", number(part(&CellStress::von_mises)))
                           .add("elastic", numbers(part(&CellStress::elastic)))
                           .add("viscous", number(part(&CellStress::viscous)))
                           .take());
    if (cell.place == Place::exit) object.add("relaxation_time", number(cell.relaxation_time));
    if (cell.applies) object.add("applies", *cell.applies);
    object.add("error", number(cell.error)).add("strain_error", number(cell.strain_error));
    return object.take();
}

Json passage_object(const PassageAnswer& passage) {
    const auto place = [](Place p) { return p == Place::nozzle ? "nozzle" : "exit"; };
    return ObjectBuilder()
        .add("offset", number(passage.offset))
        .add("offset_in_cell_radii", number(passage.offset_in_cell_radii))
        .add("peak", ObjectBuilder()
                         .add("von_mises", number(passage.von_mises))
                         .add("place", place(passage.place))
                         .add("position", number(passage.position))
                         .add("error", number(passage.error))
                         .take())
        .add("nozzle", ObjectBuilder()
                           .add("von_mises_peak", number(passage.nozzle_peak))
                           .add("von_mises_settled", number(passage.nozzle_steady))
                           .add("settles", passage.settles ? Json(*passage.settles) : Json(nullptr))
                           .add("settling_time", number(passage.settling_time))
                           .add("exposure", number(passage.nozzle_exposure))
                           .add("error", number(passage.nozzle_error))
                           .take())
        .add("exit", ObjectBuilder()
                         .add("von_mises_peak", number(passage.exit_peak))
                         .add("position", number(passage.exit_position))
                         .add("exposure", number(passage.exit_exposure))
                         .add("error", number(passage.exit_error))
                         .take())
        .add("strand_offset", number(passage.strand_offset))
        .take();
}

Json distribution_object(const Distribution& d) {
    return ObjectBuilder()
        .add("mean", number(d.mean))
        .add("median", number(d.median))
        .add("percentile_90", number(d.percentile_90))
        .add("percentile_95", number(d.percentile_95))
        .add("percentile_99", number(d.percentile_99))
        .add("largest", number(d.largest))
        .take();
}

Json population_object(const Population& population, const std::optional<double>& error,
                       const Case& question) {
    const std::vector<double>& thresholds = question.thresholds;
    Json shares = Json::array();
    for (std::size_t i = 0; i < thresholds.size(); ++i) {
        shares.push_back(ObjectBuilder()
                             .add("stress", number(thresholds[i]))
                             .add("share_above", number(population.share_above.at(i)))
                             .take());
    }
    return ObjectBuilder()
        .add("peak_stress", distribution_object(population.peak_stress))
        .add("share_peaking_at_exit", number(population.share_peaking_at_exit))
        .add("thresholds", std::move(shares))
        .add("exposure", population.exposure ? distribution_object(*population.exposure) : Json(nullptr))
        .add("published", published_object(published_limits(question.cell.name)))
        .add("error", number(error))
        .take();
}

Json profile_object(const RadialProfile& profile) {
    return ObjectBuilder()
        .add("r", numbers(profile.r))
        .add("velocity", numbers(profile.velocity))
        .add("shear_rate", numbers(profile.shear_rate))
        .add("viscosity", numbers(profile.viscosity))
        .add("stress", numbers(profile.stress))
        .take();
}

std::string offered_by(const Json& place) {
    if (place.is_array()) {
        return place.empty() ? "nothing" : "the numbers 0 to " + std::to_string(place.size() - 1);
    }
    std::string names;
    for (const auto& item : place.items()) names += (names.empty() ? "" : ", ") + item.key();
    return names.empty() ? "nothing" : names;
}

/// The entry of an object or array; null when there is none of that name.
const Json* step_into(const Json& place, const std::string& name) {
    if (place.is_object()) {
        const auto found = place.find(name);
        return found == place.end() ? nullptr : &*found;
    }
    const bool is_index = !name.empty() && name.size() < 9 &&
                          std::all_of(name.begin(), name.end(), [](char c) { return c >= '0' && c <= '9'; });
    if (!place.is_array() || !is_index) return nullptr;
    const std::size_t index = std::stoul(name);
    return index < place.size() ? &place[index] : nullptr;
}

/// "stress.von_mises" where a path says "von_mises" of what has a stress; empty when nothing below has it.
std::string entry_with(const Json& place, const std::string& rest) {
    const std::string name = rest.substr(0, rest.find('.'));
    if (!place.is_object()) return {};
    for (const auto& [key, value] : place.items()) {
        if (value.is_object() && value.contains(name)) return std::string(key).append(".").append(rest);
    }
    return {};
}

}  // namespace

Json answer_object(const Prediction& prediction) {
    Json cells = Json::array();
    for (const CellAnswer& cell : prediction.cells) cells.push_back(cell_object(cell));
    Json warnings = Json::array();
    for (const Warning& warning : prediction.warnings) {
        warnings.push_back(ObjectBuilder().add("code", warning.code).add("message", warning.message).take());
    }
    ObjectBuilder answer;
    answer.add("schema", schema_name)
        .add("program", program_object())
        .add("input", input_object(prediction))
        .add("nozzle", nozzle_object(prediction.nozzle))
        .add("exit", ObjectBuilder()
                         .add("elongation_rate", number(prediction.exit.elongation_rate))
                         .add("elongational_stress", number(prediction.exit.elongational_stress))
                         .add("error", number(prediction.exit.error))
                         .take())
        .add("cells", std::move(cells));
    if (!prediction.passages.empty()) {
        Json passages = Json::array();
        for (const PassageAnswer& passage : prediction.passages) passages.push_back(passage_object(passage));
        answer.add("passages", std::move(passages));
    }
    if (prediction.population) {
        answer.add("population", population_object(*prediction.population, prediction.population_error,
                                                   prediction.question));
    }
    if (prediction.profile) answer.add("profile", profile_object(*prediction.profile));
    return answer.add("warnings", std::move(warnings)).take();
}

std::string json_text(const Json& value, int indent) {
    return value.dump(indent, ' ', false, Json::error_handler_t::replace);
}

Json refusal_object(const Refusal& refusal) {
    Json answer;
    answer["schema"] = schema_name;
    answer["program"] = program_object();
    answer["error"] = {{"code", refusal.code},
                       {"message", refusal.message},
                       {"option", refusal.option.empty() ? Json(nullptr) : Json(refusal.option)}};
    return answer;
}

Refusal current_refusal() {
    try {
        throw;
    } catch (const UsageError& e) {
        return {"usage", e.what(), e.option()};
    } catch (const NoSteadyFlow& e) {
        return {"no_steady_flow", e.what(), {}};
    } catch (const DataError& e) {
        return {"data", e.what(), {}};
    } catch (const NotConverged& e) {
        return {"not_converged", e.what(), {}};
    } catch (const std::exception& e) {
        return {"internal", e.what(), {}};
    }
}

const Json& value_at(const Json& answer, std::string_view path, std::string_view option) {
    const Json* place = &answer;
    std::size_t begin = 0;
    while (begin <= path.size()) {
        const std::size_t end = std::min(path.find('.', begin), path.size());
        const Json* next = step_into(*place, std::string(path.substr(begin, end - begin)));
        if (next == nullptr) {
            const std::string known =
                begin == 0 ? "the answer" : "'" + std::string(path.substr(0, begin - 1)) + "'";
            const std::string deeper = entry_with(*place, std::string(path.substr(begin)));
            // The time in the nozzle is what it takes, and without a length there is none.
            if (known == "'population.exposure'" && place->is_null()) {
                throw UsageError(std::string(option) + ": no value at '" + std::string(path) +
                                     "'; it takes the length of the nozzle, add --length",
                                 std::string(option));
            }
            throw UsageError(
                std::string(option) + ": no value at '" + std::string(path) + "'; " +
                    (deeper.empty() ? known + " has " + offered_by(*place)
                                    : "did you mean '" + std::string(path.substr(0, begin)) + deeper + "'?"),
                std::string(option));
        }
        place = next;
        begin = end + 1;
    }
    return *place;
}

std::string_view unit_of(std::string_view path) {
    static constexpr std::array<std::pair<std::string_view, std::string_view>, 44> units = {{
        {"radius", "m"},
        {"length", "m"},
        {"offsets", "m"},
        {"offset", "m"},
        {"r", "m"},
        {"flow_rate", "m^3/s"},
        {"eta0", "Pa.s"},
        {"eta_inf", "Pa.s"},
        {"viscosity", "Pa.s"},
        {"viscosity_wall", "Pa.s"},
        {"time_constant", "s"},
        {"residence_time", "s"},
        {"relaxation_time", "s"},
        {"shear_modulus", "Pa"},
        {"consistency", "Pa.s^n"},
        {"yield_stress", "Pa"},
        {"plug_radius", "m"},
        {"pressure_drop", "Pa"},
        {"stress_max", "Pa"},
        {"stress_average", "Pa"},
        {"elongational_stress", "Pa"},
        {"fluid_stress", "Pa"},
        {"von_mises", "Pa"},
        {"elastic", "Pa"},
        {"viscous", "Pa"},
        {"stress", "Pa"},
        {"pressure_gradient", "Pa/m"},
        {"velocity", "m/s"},
        {"velocity_average", "m/s"},
        {"velocity_max", "m/s"},
        {"shear_rate", "1/s"},
        {"shear_rate_max", "1/s"},
        {"shear_rate_average", "1/s"},
        {"elongation_rate", "1/s"},
        {"frequency", "1/s"},
        {"angle", "rad"},
        {"position", "m"},
        {"strand_offset", "m"},
        {"von_mises_peak", "Pa"},
        {"von_mises_settled", "Pa"},
        {"settling_time", "s"},
        {"wall_stress", "Pa"},
        {"duration", "s"},
        {"exposure", "Pa.s"},
    }};
    // A spread has the unit of the number, the shares in it none.
    if (path.starts_with("uncertainty.")) {
        if (path.find(".first_order") != std::string_view::npos || path.ends_with(".missing")) return {};
        path.remove_prefix(12);
        path = path.substr(0, path.rfind('.'));
    }
    if (path.starts_with("population.peak_stress.")) return "Pa";
    if (path.starts_with("population.exposure.")) return "Pa.s";
    const auto is_index = [](std::string_view name) {
        return !name.empty() &&
               std::all_of(name.begin(), name.end(), [](char c) { return c >= '0' && c <= '9'; });
    };
    std::string_view leaf = path.substr(path.rfind('.') + 1);
    while (is_index(leaf) && leaf.size() < path.size()) {
        path.remove_suffix(leaf.size() + 1);
        leaf = path.substr(path.rfind('.') + 1);
    }
    const auto found =
        std::find_if(units.begin(), units.end(), [&](const auto& unit) { return unit.first == leaf; });
    return found == units.end() ? std::string_view{} : found->second;
}

}  // namespace bioprint
