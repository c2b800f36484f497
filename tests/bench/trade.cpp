#include <CLI/CLI.hpp>
#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <fstream>
#include <functional>
#include <nlohmann/json.hpp>
#include <string>
#include <thread>
#include <vector>

#include "bench/processor_time.hpp"
#include "bench/trade_questions.hpp"
#include "bioprint/errors.hpp"
#include "bioprint/io/answer.hpp"
#include "bioprint/predict/comparison.hpp"

// The trade of speed for accuracy, measured: every rung of the ladder on every question, its time and its error
// against the finest run there is. Results are merged into one file, question by question, so that a long
// measurement can be stopped and taken up again.

namespace {

using namespace bioprint;
using namespace bioprint::trade;
using Json = nlohmann::ordered_json;

struct Options {
    std::string file = BIOPRINT_SOURCE_DIR "/data/trade.json";
    std::vector<std::string> kinds, rungs;
    bool missing = false;
    double longest = 1e9;
};

struct Rung {
    const char* name;
    double resolution;  ///< nodes a cell radius; 0: a prediction
};
constexpr Rung ladder[] = {
    {"steady", 0.0}, {"ellipsoid", 0.0}, {"draft", 3.0}, {"standard", 6.0}, {"fine", 12.0}};
constexpr double dearer = 6.0;  ///< a rung against the one below it, in time, at least

/// Wall and processor time of a call [s]; short ones are repeated until the clock can tell.
struct Timing {
    double wall, cpu;
};
Timing timed(const std::function<void()>& call) {
    int repeats = 0;
    const auto begin = std::chrono::steady_clock::now();
    const double cpu = bench::processor_seconds();
    double wall = 0.0;
    do {
        call();
        ++repeats;
        wall = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
    } while (wall < 0.05 && repeats < 4096);
    return {wall / repeats, (bench::processor_seconds() - cpu) / repeats};
}

Json run_prediction(const Question& question, bool transient) {
    Case asked = question.to_case();
    asked.transient = transient;
    std::optional<double> value;
    const Timing time = timed([&] { value = predicted(question, predict(asked), transient); });
    Json result{{"time", time.wall}, {"cpu", time.cpu}};
    result["value"] = value ? Json(*value) : Json(nullptr);
    if (!value) result["refused"] = "no stationary shape";
    return result;
}

Json run_simulation(const Question& question, double resolution) {
    Case asked = question.to_case();
    asked.transient = false;
    const Prediction prediction = predict(asked);
    Json result;
    try {
        Comparison comparison;
        const Timing time = timed([&] {
            comparison = compare_with_simulation(
                prediction,
                {.kind = question.kind->scene, .offset = prediction.question.positions.front().value},
                {.resolution = resolution, .threads = 2});
        });
        const SimulatedValue& judged = comparison.run.at(question.kind->quantity);
        result = {
            {"time", time.wall}, {"cpu", time.cpu}, {"value", judged.value}, {"own_error", judged.error}};
        bool broken = !std::isfinite(judged.value) || judged.value <= 0.0;
        for (const ComparedValue& value : comparison.values) {
            if (value.name == question.kind->quantity && value.predicted)
                result["predicted"] = *value.predicted;
        }
        for (const auto& warning : comparison.run.warnings) {
            result["warnings"].push_back(warning.code);
            broken =
                broken || warning.code == "distorted-elements";  // the command gives no such answer either
        }
        if (broken) {
            result["value"] = nullptr;
            result["refused"] = "broke down";
        }
    } catch (const Error& e) {
        result = {{"value", nullptr}, {"refused", e.what()}};
    }
    return result;
}

bool wanted(const std::vector<std::string>& names, const std::string& name) {
    return names.empty() || std::find(names.begin(), names.end(), name) != names.end();
}

Json& entry_of(Json& data, const Question& question) {
    for (Json& entry : data["questions"])
        if (entry["label"] == question.label()) return entry;
    data["questions"].push_back({{"label", question.label()},
                                 {"kind", question.kind->name},
                                 {"quantity", question.kind->quantity},
                                 {"alpha", question.alpha},
                                 {"shear_modulus", question.shear_modulus},
                                 {"velocity", question.velocity},
                                 {"rungs", Json::object()}});
    return data["questions"].back();
}

/// The finest run is the reference; its own error is the one it estimated, every other's is measured.
void judge(Json& entry) {
    Json rungs = entry["rungs"];
    Json reference;
    for (const Rung& rung : ladder) {
        if (rung.resolution == 0.0 || !rungs.contains(rung.name) || rungs[rung.name]["value"].is_null())
            continue;
        reference = {{"value", rungs[rung.name]["value"]},
                     {"error", rungs[rung.name]["own_error"]},
                     {"rung", rung.name}};
    }
    if (entry["kind"] == "shear" && rungs.contains("steady")) {  // where theory is exact but for the box
        reference = {{"value", rungs["steady"]["value"]}, {"error", 0.0}, {"rung", "steady"}};
    }
    for (auto& [name, result] : rungs.items()) {
        result.erase("error");
        if (reference.is_null() || result["value"].is_null()) continue;
        const double value = reference["value"];
        const bool own = reference["rung"] == name;
        double judged = result["value"];
        // A cell off the axis migrates: the theory is asked where the simulated cell has come to.
        if (entry["kind"] == "channel-off-axis" && (name == "steady" || name == "ellipsoid"))
            judged = rungs[reference["rung"].get<std::string>()].value("predicted", judged);
        result["error"] =
            (own ? reference["error"].get<double>() : std::abs(judged - value)) / std::abs(value);
    }
    entry["reference"] = reference;
    entry["rungs"] = rungs;
}

std::string processor() {
    std::ifstream info("/proc/cpuinfo");
    for (std::string line; std::getline(info, line);)
        if (line.starts_with("model name")) return line.substr(line.find(':') + 2);
    return "unknown";
}

std::string today() {
    char date[16];
    const std::time_t now = std::time(nullptr);
    std::strftime(date, sizeof date, "%Y-%m-%d", std::gmtime(&now));
    return date;
}

/// Of the last measurement; a result that was kept from an earlier one has its own.
void describe(Json& data) {
    double load[1] = {0.0};
    getloadavg(load, 1);
    data["date"] = today();
    data["version"] = program_version();
    data["machine"] = {{"processor", processor()}, {"cores", std::thread::hardware_concurrency()}};
    // Wall times taken while others used the cores are too long; the processor time tells.
    data["load_at_start"] = load[0];
}

void save(const Json& data, const std::string& file) {
    std::ofstream(file + ".part") << data.dump(1) << '\n';
    if (std::rename((file + ".part").c_str(), file.c_str()) != 0)
        throw DataError(file + ": cannot be written");
}

void measure(const Options& options, Json& data) {
    for (const Question& question : questions()) {
        if (!wanted(options.kinds, question.kind->name)) continue;
        Json& entry = entry_of(data, question);
        entry["load"] = load_of(question, predict(question.to_case()));
        double before = 0.0;  // time of the cheaper rung
        for (const Rung& rung : ladder) {
            const bool known = options.missing && entry["rungs"].contains(rung.name);
            if (!known && wanted(options.rungs, rung.name) && before * dearer < options.longest) {
                Json result = rung.resolution > 0.0
                                  ? run_simulation(question, rung.resolution)
                                  : run_prediction(question, std::string_view(rung.name) == "ellipsoid");
                result["date"] = today();
                result["version"] = program_version();
                entry["rungs"][rung.name] = result;
                judge(entry);
                save(data, options.file);
                std::printf("%-44s %-10s %s\n", question.label().c_str(), rung.name, result.dump().c_str());
                std::fflush(stdout);
            }
            if (entry["rungs"].contains(rung.name)) before = entry["rungs"][rung.name].value("cpu", before);
        }
    }
}

}  // namespace

int main(int count, char** arguments) {
    Options options;
    CLI::App app{"every rung of the ladder on every question, its time and its error", "bench_trade"};
    app.add_option("FILE", options.file, "what was measured; merged into it")->capture_default_str();
    app.add_option("--kind", options.kinds, "questions of these kinds")->allow_extra_args(false);
    app.add_option("--rung", options.rungs, "these rungs")->allow_extra_args(false);
    app.add_flag("--missing", options.missing, "keep what FILE already holds");
    app.add_option("--longest", options.longest, "leave out a rung that would take longer than this [s]")
        ->capture_default_str();
    CLI11_PARSE(app, count, arguments);
    try {
        Json data{{"schema", "bioprint-predict/trade/1"}, {"questions", Json::array()}};
        if (std::ifstream old(options.file); old) data = Json::parse(old);
        describe(data);
        measure(options, data);
    } catch (const Error& e) {
        std::fprintf(stderr, "%s\n", e.what());
        return 1;
    }
    return 0;
}
