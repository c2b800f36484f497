#include "bench/extreme_runs.hpp"

#include <fcntl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <csignal>
#include <fstream>
#include <nlohmann/json.hpp>
#include <sstream>
#include <string_view>

namespace bioprint::extremes {
namespace {

using Json = nlohmann::json;

/// After these the values are what was reached, or rough; the user has been told.
constexpr std::array<std::string_view, 6> telling = {"channel_not_steady", "shear_not_steady",
                                                     "strong_deformation", "distorted_elements",
                                                     "volume_drift",       "flow_not_steady"};

class ScratchFile {
  public:
    ScratchFile() {
        descriptor_ = mkstemp(name_.data());
        if (descriptor_ < 0) throw std::runtime_error("no scratch file can be made in /tmp");
    }
    ~ScratchFile() {
        close(descriptor_);
        unlink(name_.c_str());
    }
    ScratchFile(const ScratchFile&) = delete;
    ScratchFile& operator=(const ScratchFile&) = delete;
    [[nodiscard]] int descriptor() const { return descriptor_; }
    [[nodiscard]] std::string text() const {
        std::ostringstream content;
        content << std::ifstream(name_, std::ios::binary).rdbuf();
        return content.str();
    }

  private:
    std::string name_ = "/tmp/bioprint-extremes-XXXXXX";
    int descriptor_ = -1;
};

void limit(int what, double value) {
    const auto most = static_cast<rlim_t>(value);
    const rlimit both{.rlim_cur = most, .rlim_max = most};
    setrlimit(what, &both);
}

[[noreturn]] void become_program(std::vector<std::string> words, const Limits& limits, int out, int err) {
    limit(RLIMIT_CPU, std::ceil(limits.seconds));
    limit(RLIMIT_AS, limits.memory);
    limit(RLIMIT_CORE, 0.0);
    dup2(out, STDOUT_FILENO);
    dup2(err, STDERR_FILENO);
    words.insert(words.begin(), "bioprint-predict");
    std::vector<char*> pointers;
    pointers.reserve(words.size() + 1);
    for (std::string& word : words) pointers.push_back(word.data());
    pointers.push_back(nullptr);
    execv(limits.program.c_str(), pointers.data());
    _exit(127);
}

std::string first_line(const std::string& text) {
    std::string line = text.substr(0, text.find('\n'));
    const std::string_view program = "bioprint-predict: ";
    return line.starts_with(program) ? line.substr(program.size()) : line;
}

std::string last_line(const std::string& text) {
    const std::size_t end = text.find_last_not_of('\n');
    if (end == std::string::npos) return {};
    const std::size_t begin = text.find_last_of('\n', end);
    return first_line(text.substr(begin == std::string::npos ? 0 : begin + 1, end));
}

/// The numbers of `simulation.<part>`, one name each.
using Numbers = std::vector<std::pair<std::string, std::optional<double>>>;
Numbers numbers_of(const Json& part) {
    Numbers numbers;
    const auto number = [](const Json& n) {
        return n.is_number() ? std::optional(n.get<double>()) : std::nullopt;
    };
    for (const auto& [name, value] : part.items()) {
        if (!value.is_array()) {
            numbers.emplace_back(name, number(value));
            continue;
        }
        for (std::size_t i = 0; i < value.size(); ++i)
            numbers.emplace_back(name + "." + std::to_string(i), number(value[i]));
    }
    return numbers;
}

std::optional<double> find(const Numbers& numbers, const std::string& name) {
    const auto found =
        std::find_if(numbers.begin(), numbers.end(), [&](const auto& n) { return n.first == name; });
    return found == numbers.end() ? std::nullopt : found->second;
}

struct Reference {
    std::string quantity;
    double value;
    double error;  ///< of its own, in its unit
    std::string source;
};

/// Where theory is exact, up to the size of the cell against nozzle or box.
std::vector<Reference> exact_references(const ExtremeScene& scene, const Json& answer) {
    std::vector<Reference> list;
    const Json& simulation = answer.at("simulation");
    if (scene.kind == "exit-flow") {
        for (const char* const name : {"pressure_gradient", "velocity_max"})
            list.push_back({name, simulation.at("predicted").at(name), 0.0, "theory of the nozzle"});
        if (scene.alpha == 0.0) {
            // Finite elements for η0 10 Pa s, half of which is the viscosity at α 0, R 50 µm and 5 mm/s.
            const double scale = scene.velocity / 5e-3;
            list.push_back({"elongational_stress_peak", 754.61 * scale, 0.1 * scale, "finite elements"});
            list.push_back({"elongational_stress_average", 410.37 * scale, 0.1 * scale, "finite elements"});
        }
    } else if (scene.kind == "shear") {
        for (const auto& [name, value] : numbers_of(simulation.at("predicted")))
            if (value) list.push_back({name, *value, 0.0, "Roscoe's theory"});
    } else if (scene.kind == "channel" && scene.offset == 0.0 && scene.load() < 0.02 && scene.alpha == 0.0 &&
               scene.confinement < 0.2) {
        // To first order in the load; what the wall adds grows with the fifth power of the confinement.
        const double value = simulation.at("predicted").at("von_mises");
        list.push_back({"von_mises", value, value * (scene.load() + std::pow(scene.confinement, 3.0)),
                        "sphere of small strain"});
    }
    return list;
}

/// @param nodes  a cell radius in the run to be judged, which in a narrow nozzle has more than it was asked for
std::vector<Reference> finer_references(const ExtremeScene& scene, double nodes, const Limits& limits) {
    nodes = scene.offset > 0.0 ? 1.5 * nodes : 2.0 * draft_nodes;
    const Ended ended = run_program(scene.arguments(nodes), limits);
    if (ended.status != 0) return {};
    const Json simulation = Json::parse(ended.out).at("simulation");
    const Numbers errors = numbers_of(simulation.at("error"));
    std::vector<Reference> list;
    for (const auto& [name, value] : numbers_of(simulation.at("simulated"))) {
        const auto error = find(errors, name);
        if (value && error) list.push_back({name, *value, *error, "finer run"});
    }
    return list;
}

/// Velocities across and places are measured against the nozzle's, not against themselves.
double scale_of(const ExtremeScene& scene, const std::string& quantity, double value) {
    if (quantity == "migration_velocity") return scene.velocity;
    if (quantity == "peak_position") return nozzle_radius;
    return std::abs(value);
}

/// The value farthest from its reference, in terms of both errors. Returns that ratio.
double judge(const ExtremeScene& scene, const Json& simulation, const std::vector<Reference>& references,
             Outcome& outcome) {
    const Numbers values = numbers_of(simulation.at("simulated"));
    const Numbers errors = numbers_of(simulation.at("error"));
    double worst = -1.0;
    for (const Reference& reference : references) {
        const auto value = find(values, reference.quantity);
        const double error = find(errors, reference.quantity).value_or(0.0);
        if (!value || error <= 0.0) continue;
        const double off = std::abs(*value - reference.value);
        const double ratio = off / (error + reference.error);
        if (ratio <= worst) continue;
        worst = ratio;
        const double scale = scale_of(scene, reference.quantity, *value);
        outcome.quantity = reference.quantity;
        outcome.value = *value;
        outcome.stated_error = error / scale;
        outcome.deviation = off / scale;
        outcome.reference_error = reference.error / scale;
        outcome.reference = reference.source;
    }
    return worst;
}

bool warns(const Json& answer, std::string& codes) {
    bool told = false;
    for (const Json& warning : answer.at("warnings")) {
        const std::string code = warning.at("code");
        if (std::find(telling.begin(), telling.end(), code) == telling.end()) continue;
        codes += (codes.empty() ? "" : " ") + code;
        told = true;
    }
    return told;
}

Verdict verdict_of_answer(const ExtremeScene& scene, bool finer, const Limits& limits, Outcome& outcome) {
    const Json answer = Json::parse(outcome.ended.out, nullptr, false);
    if (answer.is_discarded()) return Verdict::not_a_number;
    const Json& simulation = answer.at("simulation");
    for (const auto& [name, value] : numbers_of(simulation.at("simulated"))) {
        if (!value) {
            outcome.remark = name;
            return Verdict::not_a_number;
        }
    }
    const bool told = warns(answer, outcome.remark);
    std::vector<Reference> references = exact_references(scene, answer);
    if (references.empty() && finer && !told)
        references = finer_references(scene, simulation.at("lattice").at("nodes_per_cell_radius"), limits);
    const double ratio = judge(scene, simulation, references, outcome);
    if (told) return Verdict::warned;
    if (ratio < 0.0) return Verdict::unjudged;
    return ratio <= 1.0 ? Verdict::within : Verdict::beyond;
}

}  // namespace

Ended run_program(const std::vector<std::string>& arguments, const Limits& limits) {
    const ScratchFile out;
    const ScratchFile err;
    const pid_t child = fork();
    if (child == 0) become_program(arguments, limits, out.descriptor(), err.descriptor());
    if (child < 0) throw std::runtime_error("no process can be started");
    int status = 0;
    rusage usage{};
    wait4(child, &status, 0, &usage);
    return {.status = WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status),
            .seconds = static_cast<double>(usage.ru_utime.tv_sec + usage.ru_stime.tv_sec) +
                       1e-6 * static_cast<double>(usage.ru_utime.tv_usec + usage.ru_stime.tv_usec),
            .memory = 1024.0 * static_cast<double>(usage.ru_maxrss),
            .out = out.text(),
            .err = err.text()};
}

Outcome ask(const ExtremeScene& scene, bool finer, const Limits& limits) {
    Outcome outcome{.verdict{},
                    .ended = run_program(scene.arguments(draft_nodes), limits),
                    .remark = {},
                    .quantity = {},
                    .reference = {}};
    const int status = outcome.ended.status;
    if (status == 0) {
        outcome.verdict = verdict_of_answer(scene, finer, limits, outcome);
        return outcome;
    }
    outcome.remark = last_line(outcome.ended.err);
    if (status == 128 + SIGXCPU || status == 128 + SIGKILL) {
        outcome.verdict = Verdict::out_of_time;
    } else if (status == 2 || status == 3) {
        outcome.verdict =
            outcome.remark.find("--") == std::string::npos ? Verdict::unclear : Verdict::refused;
    } else {
        outcome.verdict = status == 5 ? Verdict::broke_down : Verdict::crashed;
    }
    return outcome;
}

const char* name_of(Verdict verdict) {
    switch (verdict) {
        case Verdict::within:
            return "within its error";
        case Verdict::unjudged:
            return "answered";
        case Verdict::warned:
            return "answered with a warning";
        case Verdict::refused:
            return "refused";
        case Verdict::out_of_time:
            return "out of time";
        case Verdict::broke_down:
            return "broke down";
        case Verdict::beyond:
            return "beyond its error";
        case Verdict::unclear:
            return "refused unclearly";
        case Verdict::not_a_number:
            return "not a number";
        case Verdict::crashed:
            return "crashed";
    }
    return "";
}

bool is_sound(Verdict verdict) {
    return verdict == Verdict::within || verdict == Verdict::unjudged || verdict == Verdict::warned ||
           verdict == Verdict::refused;
}

}  // namespace bioprint::extremes
