#include "cli/design_options.hpp"

namespace bioprint {
namespace {

bool drives(Key key) {
    return key == Key::flow_rate || key == Key::velocity || key == Key::pressure ||
           key == Key::pressure_gradient;
}

bool sizes(Key key) {
    return key == Key::radius || key == Key::diameter || key == Key::needle;
}

/// A search asks for the prediction some twenty times, and for what is made of it afterwards not at all.
void refuse_beyond_prediction(const Check& limit) {
    const std::string_view first = std::string_view(limit.path).substr(0, limit.path.find('.'));
    if (first == "uncertainty") {
        throw UsageError(
            "--limit: " + limit.text +
                ": a design sets no limit on a spread, which takes 1024 predictions at every step; limit the "
                "value itself, and hold the spread there against its own limit by --check '" +
                limit.text + "'",
            "--limit");
    }
    if (first == "simulation" || first == "choice" || first == "checks") {
        throw UsageError("--limit: " + limit.text + ": a design searches among predictions, which have no '" +
                             std::string(first) +
                             "'; limit a value of the prediction, such as nozzle.stress_max<2kPa",
                         "--limit");
    }
}

/// What is sought cannot be given.
void refuse_given(Key sought, const Arguments& arguments, Problems& problems) {
    for (const auto& [key, text] : arguments.given) {
        if (key != sought && !(drives(key) && drives(sought)) && !(sizes(key) && sizes(sought))) continue;
        const std::string name = "--" + std::string(info_of(key).option);
        std::string message = name + ": cannot be given where ";
        message += info_of(sought).option;
        problems.add(message + " is sought; leave one of the two out", name);
    }
}

}  // namespace

CLI::App* add_design(CLI::App& app, RawDesign& raw) {
    CLI::App* design = app.add_subcommand("design", "the printing parameter that keeps limits");
    design->fallthrough();
    design->footer(
        "\nEvery option of a prediction sets the rest of the question: bioprint-predict --help.\n"
        "Example:\n"
        "  bioprint-predict design --solve flowrate --limit 'nozzle.stress_max<500Pa' --radius 100um\n"
        "Exit status 7: no value keeps the limits; the answer is at the closest.");
    design
        ->add_option("--solve", raw.sought,
                     "what is sought: radius, flowrate, velocity, pressure, pressure-gradient or alpha")
        ->type_name("WORD");
    design->add_option("--limit", raw.limits, "what to keep, such as 'population.p95<2kPa'; may be repeated")
        ->type_name("EXPR")
        ->expected(1)
        ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll);
    design->add_option("--range", raw.range, "where to look for it, such as 1uL/h:1mL/h")
        ->type_name("LOW:HIGH");
    return design;
}

void collect_design(const RawDesign& raw, Arguments& arguments, Problems& problems) {
    if (!raw.sought) {
        problems.add(
            "--solve: is missing; it takes radius, flowrate, velocity, pressure, pressure-gradient or alpha",
            "--solve");
    }
    if (raw.limits.empty()) {
        problems.add("--limit: is missing; it takes what to keep, such as 'nozzle.stress_max<2kPa'",
                     "--limit");
    }
    if (arguments.batch || arguments.simulation || arguments.history || !arguments.sweep.swept().empty()) {
        problems.add("design: one question at a time; leave out --batch, --simulate, --history and lists");
    }
    std::vector<Check> limits;
    for (const std::string& text : raw.limits) {
        problems.collect([&] {
            limits.push_back(parse_check(text, "--limit"));
            refuse_beyond_prediction(limits.back());
        });
    }
    problems.collect([&] {
        if (!raw.sought) return;
        const Key sought = sought_key(*raw.sought);
        refuse_given(sought, arguments, problems);
        arguments.design = DesignQuestion{.sought = sought, .limits = limits};
        if (raw.range) arguments.design->range = parse_range(*raw.range, sought);
    });
}

}  // namespace bioprint
