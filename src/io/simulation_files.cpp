#include "io/simulation_files.hpp"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstdio>
#include <system_error>

#include "bioprint/errors.hpp"
#include "io/csv.hpp"
#include "io/row_answer.hpp"
#include "io/vtk.hpp"

namespace bioprint {
namespace {

constexpr const char* frames_folder = "frames";
constexpr const char* pictures_part = "pictures";

std::string frame(const char* what, std::size_t index, const char* ending) {
    std::array<char, 64> name{};
    std::snprintf(name.data(), name.size(), "%s/%s_%04zu.%s", frames_folder, what, index, ending);
    return name.data();
}

}  // namespace

SimulationFiles::SimulationFiles(RunDirectory& directory, double interval)
    : directory_(directory), interval_(interval) {
    if (auto parts = directory.checkpoint()) {
        if (const auto node = parts->extract(pictures_part)) times_ = node.mapped();
        state_.parts = std::move(*parts);
        resumes_ = true;
    }
}

void SimulationFiles::attach(SimulationOptions& options, int snapshots) {
    options.checkpoint = [this](const SimulationState& state) {
        const std::lock_guard guard(lock_);
        sync_pictures();
        directory_.keep(state.parts, {{pictures_part, times_}});
    };
    options.checkpoint_interval = interval_;
    if (resumes_) options.resume = &state_;
    options.snapshots = snapshots;
    if (snapshots > 0) {
        options.snapshot = [this](const SimulationSnapshot& snapshot) {
            const std::lock_guard guard(lock_);
            write_picture(snapshot);
        };
    }
}

void SimulationFiles::write_picture(const SimulationSnapshot& snapshot) {
    if (const std::string folder = directory_.file(frames_folder);
        ::mkdir(folder.c_str(), 0777) != 0 && errno != EEXIST) {
        throw DataError(folder + ": cannot be made: " + std::generic_category().message(errno));
    }
    const auto index = static_cast<std::size_t>(snapshot.index);
    if (snapshot.cell) write_frame(frame("cell", index, "vtu"), vtu_text(*snapshot.cell));
    if (snapshot.flow) write_frame(frame("flow", index, "vti"), vti_text(*snapshot.flow));
    // A run that goes on makes its last pictures again: the same ones in the same places.
    times_.resize(std::max(times_.size(), index + 1));
    times_[index] = snapshot.time;
    write_timelines(WholeFile::Sync::none);
}

void SimulationFiles::write_frame(const std::string& name, const std::string& text) {
    write(name, text, WholeFile::Sync::none);
    unsynced_.push_back(name);
}

/// What a checkpoint counts must be on the disk before it.
void SimulationFiles::sync_pictures() {
    for (const std::string& name : unsynced_) {
        const int file = ::open(directory_.file(name).c_str(), O_RDONLY | O_CLOEXEC);
        if (file < 0) continue;
        ::fsync(file);
        ::close(file);
    }
    unsynced_.clear();
}

void SimulationFiles::write_timelines(WholeFile::Sync sync) const {
    for (const auto& [what, ending] : {std::pair{"cell", "vtu"}, std::pair{"flow", "vti"}}) {
        std::vector<TimelineEntry> entries;
        for (std::size_t i = 0; i < times_.size(); ++i) {
            const std::string file = frame(what, i, ending);
            if (::access(directory_.file(file).c_str(), F_OK) == 0) entries.push_back({times_[i], file});
        }
        if (!entries.empty()) write(std::string(what) + ".pvd", pvd_text(entries), sync);
    }
}

void SimulationFiles::write_series(const SimulationSeries& series) const {
    CsvWriter writer(fresh_dialect());
    for (const std::string& name : series.columns) writer.add_text(name);
    writer.end_row();
    for (const std::vector<double>& row : series.rows) {
        for (const double value : row) writer.add_number(value);
        writer.end_row();
    }
    write("series.csv", writer.text());
}

void SimulationFiles::write_answer(const std::string& json) {
    sync_pictures();
    write_timelines(WholeFile::Sync::disk);
    write("answer.json", json);
}

void SimulationFiles::write(const std::string& name, const std::string& text, WholeFile::Sync sync) const {
    WholeFile file(directory_.file(name));
    file.write(text);
    file.commit(sync);
}

}  // namespace bioprint
