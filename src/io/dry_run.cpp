#include "io/dry_run.hpp"

#include <fstream>

#include "bioprint/errors.hpp"
#include "bioprint/io/number_format.hpp"

namespace bioprint {
namespace {

// Measured by tools/bench command and tools/bench predict on one core: a row with its text, and the program's start.
constexpr double steady_row = 4e-5;         ///< [s]
constexpr double ellipsoid_row = 2e-3;      ///< [s]; four positions carried in time
constexpr double population_row = 25e-3;    ///< [s]
constexpr double program_start = 3.5e-3;    ///< [s]
constexpr double prediction_memory = 10e6;  ///< [B]; does not grow with the rows

/// Rows of a batch: its lines that are not empty, less the header of a CSV.
std::size_t count_rows(const std::string& file) {
    std::ifstream input(file);
    if (!input) throw DataError("--batch: '" + file + "' cannot be read");
    std::size_t rows = 0;
    bool json = false;
    for (std::string line; std::getline(input, line);) {
        if (line.find_first_not_of(" \t\r") == std::string::npos) continue;
        if (rows == 0)
            json = line.find_first_not_of(" \t") != std::string::npos &&
                   line[line.find_first_not_of(" \t")] == '{';
        ++rows;
    }
    return json || rows == 0 ? rows : rows - 1;
}

double row_time(const Settings& settings) {
    const bool steady = settings.has(Key::model) && settings.at(Key::model).text == "steady";
    return (steady ? steady_row : ellipsoid_row) + (settings.has(Key::population) ? population_row : 0.0);
}

std::string megabytes(double bytes) {
    return format_lab(bytes / 1e6, Dimension::dimensionless, 2).number + " MB";
}

Rung rung_of(double resolution) {
    if (resolution <= 3.0) return Rung::draft;
    return resolution <= 6.0 ? Rung::standard : Rung::fine;
}

bool in_space(const SceneChoice& scene) {
    return scene.offset > 0.0 || scene.kind == SceneKind::shear;
}

/// Largest resident set of a simulation in a nozzle of 6.25 cell radii, as measured at 3 and 6 nodes a cell radius and, on
/// the axis, at 12; between, by the power of the dimension.
double simulation_memory(const SceneChoice& scene, double resolution) {
    const double ratio = resolution / 6.0;
    if (!in_space(scene)) return 8e6 + 2.7e6 * ratio * ratio;
    const double volume = ratio * ratio * ratio;
    if (scene.kind == SceneKind::exit) return 18e6 + 89e6 * volume;
    return scene.kind == SceneKind::shear ? 11.5e6 + 24.2e6 * volume : 9.8e6 + 20e6 * volume;
}

std::string simulation_plan(const PlannedWork& work) {
    const Prediction prediction = predict(work.sweep.fixed().make_case());
    const ChosenScene chosen = choose_scene(*work.simulation, prediction);
    const double resolution = resolution_of(*work.simulation);
    const LadderAnswer ladder = climb(prediction, {}, chosen.scene.kind);
    const RungRecord* record = measured(ladder.request.kind, rung_of(resolution), ladder.request.load);
    std::string text = "rows     1\nmodel    simulation of " + std::string(name_of(ladder.request.kind)) +
                       ", " + format_lab(resolution, Dimension::dimensionless, 3).number +
                       " nodes a cell radius\n";
    if (record != nullptr) {
        text += "time     " + lab_text(record->time, Dimension::time, 2) + ", at most " +
                lab_text(record->longest, Dimension::time, 2) +
                " of one core on questions like this one\nerror    " +
                format_lab(100.0 * record->error, Dimension::dimensionless, 2).number + " % at most there\n";
    } else {
        text += "time     not known: nothing like this question was measured\n";
    }
    return text + "memory   " + megabytes(simulation_memory(chosen.scene, resolution)) + "\n";
}

}  // namespace

std::string dry_run(const PlannedWork& work) {
    if (work.simulation) return simulation_plan(work);
    const Settings& settings = work.sweep.fixed();
    if (!work.batch) (void)work.sweep.row(0).make_case();  // what is wrong with the question is said now
    const bool piped = work.batch == "-";
    const std::size_t rows = piped ? 0 : work.batch ? count_rows(*work.batch) : work.sweep.size();
    const double time = program_start + row_time(settings) * static_cast<double>(rows) / work.jobs;
    const bool steady = settings.has(Key::model) && settings.at(Key::model).text == "steady";
    return "rows     " +
           (piped ? std::string("not known: standard input is not read") : std::to_string(rows)) +
           "\nmodel    " + (steady ? "steady" : "ellipsoid") +
           (settings.has(Key::population) ? ", population" : "") + "\ntime     " +
           (piped ? lab_text(row_time(settings) / work.jobs, Dimension::time, 2) + " a row"
                  : lab_text(time, Dimension::time, 2)) +
           " with " + std::to_string(work.jobs) + (work.jobs == 1 ? " thread" : " threads") + "\nmemory   " +
           megabytes(prediction_memory) + "\n";
}

}  // namespace bioprint
