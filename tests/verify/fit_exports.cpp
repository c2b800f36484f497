#include <doctest/doctest.h>

#include <cmath>
#include <random>

#include "bioprint/io/presets.hpp"
#include "bioprint/rheology/cross.hpp"
#include "io/decoded_text.hpp"
#include "io/fit_answer.hpp"
#include "support/rheometer_export.hpp"

// From a file to an ink: known inks, measured with noise, exported in every form, read and fitted.

using namespace bioprint;
using namespace bioprint::test;

namespace {

std::vector<ExportPoint> measure(const CrossInk& ink, double low, double high, int count, double error,
                                 std::mt19937& random) {
    std::normal_distribution<double> noise(0.0, 1.0);
    std::vector<ExportPoint> points;
    for (int i = 0; i < count; ++i) {
        const double rate = low * std::pow(high / low, static_cast<double>(i) / (count - 1));
        points.push_back({rate, viscosity(ink, rate) * std::exp(error * noise(random))});
    }
    return points;
}

FitAnswer fit_bytes(const std::string& bytes, bool fit_eta_inf = false) {
    const DecodedText decoded = decode_text(bytes, "data.txt");
    return answer_fit({.file = "data.txt", .fit_eta_inf = fit_eta_inf, .intervals = {}, .name = {}},
                      read_rheometer_text(decoded.text, "data.txt"));
}

}  // namespace

TEST_CASE("fit of exports: 200 random inks in every form come back within their own error bars") {
    std::mt19937 random(7);
    std::uniform_real_distribution<double> uniform(0.0, 1.0);
    int inside = 0;
    int all = 0;
    for (int k = 0; k < 200; ++k) {
        const ExportKind kind = export_kinds.at(static_cast<std::size_t>(k) % export_kinds.size());
        const CrossInk ink{.eta0 = std::pow(10.0, -1.0 + 4.0 * uniform(random)),
                           .time_constant = std::pow(10.0, -2.0 + 2.0 * uniform(random)),
                           .alpha = 0.4 + 0.6 * uniform(random)};
        const double error = 0.005 + 0.03 * uniform(random);
        const FitAnswer answer =
            fit_bytes(rheometer_export(kind, measure(ink, 0.01, 1000.0, 31, error, random)));
        CAPTURE(kind_name(kind));
        const double truths[] = {ink.eta0, ink.time_constant, ink.alpha};
        for (std::size_t i = 0; i < 3; ++i) {
            const FittedParameter& p = answer.chosen.parameters[i];
            ++all;
            inside += std::abs(p.value - truths[i]) <= 2.0 * p.standard_error ? 1 : 0;
            // Five and a half standard errors happen once in 1e6 even with Student's tails here.
            CHECK(std::abs(std::log(p.value / truths[i])) <= 5.5 * p.standard_error / p.value);
        }
        CHECK(answer.chosen.scatter == doctest::Approx(error).epsilon(0.6));
    }
    const double share = static_cast<double>(inside) / all;
    MESSAGE(share << " of " << all << " parameters within two standard errors");
    CHECK(share > 0.90);
    CHECK(share < 0.99);
}

TEST_CASE("fit of exports: the curves of the published inks give back the presets") {
    std::mt19937 random(3);
    int fitted = 0;
    for (const InkPreset& preset : ink_presets()) {
        CAPTURE(preset.name);
        const auto* cross = std::get_if<CrossInk>(&preset.ink);
        if (cross == nullptr) continue;
        const CrossInk& ink = *cross;
        const FitAnswer answer =
            fit_bytes(rheometer_export(ExportKind::trios, measure(ink, 1e-3, 1e4, 36, 0.01, random)),
                      ink.eta_inf > 0.0);
        for (const auto& [name, truth] :
             {std::pair{"eta0", ink.eta0}, {"time_constant", ink.time_constant}, {"alpha", ink.alpha}}) {
            const FittedParameter& p = *answer.chosen.find(name);
            CAPTURE(name);
            CHECK(p.determined);
            CHECK(std::abs(p.value - truth) <= 4.5 * p.standard_error);
        }
        ++fitted;
    }
    CHECK(fitted >= 20);
}

TEST_CASE("fit of exports: a fitted preset is an ink for a prediction") {
    std::mt19937 random(11);
    const CrossInk ink{.eta0 = 10.0, .time_constant = 0.05, .alpha = 0.75};
    const FitAnswer answer = fit_bytes(
        rheometer_export(ExportKind::rheocompass_german, measure(ink, 0.01, 1000.0, 31, 0.01, random)));
    CHECK(answer.temperature == doctest::Approx(25.01));
    CHECK(answer.name == "data");
    CHECK(fit_options_line(answer).starts_with("--eta0 "));
    CHECK(fit_preset_text(answer).find("\"degC\"") != std::string::npos);
    // The points tell a residual plot all it needs.
    for (const FitPoint& p : answer.points) {
        CHECK(p.used);
        CHECK(std::abs(p.residual()) < 0.06);
        CHECK(p.line > 10);
    }
}

TEST_CASE("fit of exports: of very many points every one counts") {
    std::mt19937 random(13);
    const CrossInk ink{.eta0 = 10.0, .time_constant = 0.05, .alpha = 0.75};
    const FitAnswer answer =
        fit_bytes(rheometer_export(ExportKind::plain, measure(ink, 0.01, 1000.0, 20000, 0.05, random)));
    CHECK(answer.points.size() == 20000);
    CHECK(answer.data.points.size() == 20000);
    const FittedParameter& alpha = *answer.chosen.find("alpha");
    CHECK(std::abs(alpha.value - 0.75) < 4.0 * alpha.standard_error);
    CHECK(alpha.standard_error < 0.002);
    CHECK(answer.chosen.scatter == doctest::Approx(0.05).epsilon(0.02));
}
