#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <map>
#include <set>
#include <sstream>
#include <string>
#include <vector>

#include "bench/extreme_runs.hpp"
#include "bioprint/errors.hpp"
#include "bioprint/io/number_format.hpp"

// The simulation at the edges of what it can be asked: each scene goes to the real program, and what comes back is an
// answer within its stated error, a refusal that names what to change, or a fault.
//
// FILE gets one row a scene; with a choice of scenes the others keep their rows. The status is 1 when a row of FILE is a
// fault.

namespace {

using namespace bioprint;
using namespace bioprint::extremes;

struct Options {
    std::string file = BIOPRINT_SOURCE_DIR "/data/extremes.csv";
    std::set<std::string> only, groups, kinds, again;
    Limits limits;
};

constexpr const char* header =
    "number,group,scene,alpha,K rate,velocity [m/s],cell radius/nozzle radius,shear modulus "
    "[Pa],offset/nozzle "
    "radius,load,inner viscosity ratio,Poisson ratio,outcome,value,stated error,deviation,error of the "
    "reference,reference,seconds,memory [MB],remark";
constexpr std::size_t outcome_column = 12;
constexpr int sample = 2;  ///< one in so many is held against a finer run where no theory is exact

std::string number(double value, const char* form = "%.4g") {
    char text[32];
    std::snprintf(text, sizeof text, form, value);
    return text;
}

std::string quoted(const std::string& text) {
    if (text.find_first_of(",\"") == std::string::npos) return text;
    std::string word = "\"";
    for (const char c : text) word += c == '"' ? std::string("\"\"") : std::string(1, c);
    return word + "\"";
}

std::string row_of(const ExtremeScene& scene, const Outcome& outcome) {
    const bool judged = !outcome.reference.empty();
    const auto if_judged = [&](double value) { return judged ? number(value, "%.3g") : std::string(); };
    const std::vector<std::string> cells = {std::to_string(scene.number),
                                            scene.group,
                                            scene.kind,
                                            number(scene.alpha),
                                            number(scene.reduced_rate),
                                            number(scene.velocity),
                                            number(scene.confinement),
                                            number(scene.shear_modulus),
                                            number(scene.offset),
                                            number(scene.load()),
                                            number(scene.inner_ratio),
                                            number(scene.poisson),
                                            name_of(outcome.verdict),
                                            outcome.quantity,
                                            if_judged(outcome.stated_error),
                                            if_judged(outcome.deviation),
                                            if_judged(outcome.reference_error),
                                            outcome.reference,
                                            number(outcome.ended.seconds, "%.2f"),
                                            number(outcome.ended.memory * 1e-6, "%.0f"),
                                            quoted(outcome.remark)};
    std::string row;
    for (const std::string& cell : cells) row += (row.empty() ? "" : ",") + cell;
    return row;
}

std::string cell_of(const std::string& row, std::size_t column) {
    std::istringstream cells(row);
    std::string cell;
    for (std::size_t i = 0; i <= column; ++i) std::getline(cells, cell, ',');
    return cell;
}

std::map<int, std::string> rows_in(const std::string& file) {
    std::map<int, std::string> rows;
    std::ifstream input(file);
    std::string line;
    std::getline(input, line);
    while (std::getline(input, line)) rows[std::atoi(line.c_str())] = line;
    return rows;
}

void save(const std::map<int, std::string>& rows, const std::string& file) {
    std::ofstream output(file + ".part");
    output << header << '\n';
    for (const auto& [key, row] : rows) output << row << '\n';
    output.close();
    if (!output || std::rename((file + ".part").c_str(), file.c_str()) != 0)
        throw DataError(file + ": cannot be written");
}

bool wanted(const std::set<std::string>& names, const std::string& name) {
    return names.empty() || names.count(name) > 0;
}

bool is_wanted(const Options& options, const ExtremeScene& scene, const std::map<int, std::string>& rows) {
    const auto row = rows.find(scene.number);
    const std::string outcome = row == rows.end() ? "" : cell_of(row->second, outcome_column);
    return wanted(options.only, std::to_string(scene.number)) && wanted(options.groups, scene.group) &&
           wanted(options.kinds, scene.kind) && wanted(options.again, outcome);
}

int campaign(const Options& options) {
    std::map<int, std::string> rows = rows_in(options.file);
    for (const ExtremeScene& scene : extreme_scenes()) {
        if (!is_wanted(options, scene, rows)) continue;
        const Outcome outcome = ask(scene, scene.number % sample == 0, options.limits);
        rows[scene.number] = row_of(scene, outcome);
        save(rows, options.file);
        std::printf("%s\n", rows[scene.number].c_str());
        std::fflush(stdout);
    }
    std::map<std::string, int> counts;
    for (const auto& [key, row] : rows) ++counts[cell_of(row, outcome_column)];
    int faults = 0;
    for (const auto& [name, count] : counts) {
        std::printf("%4d %s\n", count, name.c_str());
        for (int v = 0; v <= static_cast<int>(Verdict::crashed); ++v)
            if (name == name_of(static_cast<Verdict>(v)) && !is_sound(static_cast<Verdict>(v)))
                faults += count;
    }
    return faults > 0 ? 1 : 0;
}

}  // namespace

int main(int count, char** arguments) {
    Options options;
    CLI::App app{"the simulation at the edges of what it can be asked", "bench_extremes"};
    app.add_option("FILE", options.file, "what was measured, a row a scene")->capture_default_str();
    app.add_option("--only", options.only, "these scenes, by number")->allow_extra_args(false);
    app.add_option("--group", options.groups, "scenes of these groups")->allow_extra_args(false);
    app.add_option("--kind", options.kinds, "scenes of these kinds")->allow_extra_args(false);
    app.add_option("--again", options.again, "those of which FILE says so")->allow_extra_args(false);
    app.add_option("--limit", options.limits.seconds, "for a scene [s]")->capture_default_str();
    app.add_option("--program", options.limits.program, "to be asked")->capture_default_str();
    CLI11_PARSE(app, count, arguments);
    try {
        return campaign(options);
    } catch (const std::exception& e) {
        std::fprintf(stderr, "%s\n", e.what());
        return 1;
    }
}
