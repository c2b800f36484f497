#include "io/uncertainty.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <string>
#include <vector>

#include "bioprint/errors.hpp"
#include "bioprint/io/presets.hpp"
#include "io/spread_text.hpp"

using namespace bioprint;

namespace {

constexpr double mean_tolerance = 0.002;  // 1024 samples against closed forms
constexpr double quantile_tolerance = 0.015;
constexpr double spread_tolerance = 0.01;
constexpr double share_tolerance = 0.01;

Settings settings(std::initializer_list<std::pair<Key, const char*>> values) {
    Settings result;
    for (const auto& [key, text] : values) result.set(key, text, "--" + std::string(info_of(key).option));
    return result;
}

Json answered(const Settings& question, bool presets = false, unsigned jobs = 1,
              std::optional<std::size_t> samples = {}) {
    Json answer = answer_object(predict(question.make_case()));
    add_uncertainty(answer, question, {.presets = presets, .wanted = true, .samples = samples}, jobs);
    return answer;
}

std::string refusal(const char* text, Dimension dimension) {
    try {
        parse_spread(text, dimension, "--x");
    } catch (const UsageError& e) {
        return e.what();
    }
    return "";
}

}  // namespace

TEST_CASE("uncertainty: a spread is read in every spelling") {
    const auto read = [](const char* text, Dimension dimension) {
        return parse_spread(text, dimension, "--x").value();
    };
    CHECK(read("0.75±0.05", Dimension::dimensionless).deviation == 0.05);
    CHECK(read("0.75+-0.05", Dimension::dimensionless).value == 0.75);
    CHECK(read("0.75 +/- 0.05", Dimension::dimensionless).deviation == 0.05);
    CHECK(read("10Pa.s±15%", Dimension::viscosity).deviation == doctest::Approx(1.5));
    CHECK(read("0.75±4%", Dimension::dimensionless).deviation == doctest::Approx(0.03));
    CHECK(read("50±2um", Dimension::length).value == 50e-6);
    CHECK(read("50um±2", Dimension::length).deviation == 2e-6);
    CHECK(read("1mm ± 20um", Dimension::length).deviation == 20e-6);
    CHECK(read("1e-3±1e-4", Dimension::time).deviation == 1e-4);
    CHECK(read("50um±0", Dimension::length).deviation == 0.0);
    CHECK_FALSE(parse_spread("50um", Dimension::length, "--x"));
    CHECK_FALSE(parse_spread("1e+3", Dimension::length, "--x"));
}

TEST_CASE("uncertainty: what is no spread is refused with what it takes") {
    CHECK(refusal("50um±", Dimension::length).find("nothing behind the ±") != std::string::npos);
    CHECK(refusal("50um±-1um", Dimension::length).find("negative") != std::string::npos);
    CHECK(refusal("50um±1±1", Dimension::length).find("two ±") != std::string::npos);
    CHECK(refusal("50um±1s", Dimension::length).find("a time; it takes a length") != std::string::npos);
    CHECK_FALSE(refusal("±1um", Dimension::length).empty());
    CHECK_FALSE(refusal("50um±nan", Dimension::length).empty());
}

TEST_CASE("uncertainty: each distribution has the mean and the spread stated and keeps its bounds") {
    const auto moments = [](const UncertainInput& input) {
        double mean = 0.0;
        double square = 0.0;
        constexpr int count = 4000;
        for (int i = 0; i < count; ++i) {
            // Midpoints of equal shares, the normal's quantile by bisection of its own distribution function.
            const double p = (i + 0.5) / count;
            double low = -10.0;
            double high = 10.0;
            for (int k = 0; k < 60; ++k) {
                const double middle = 0.5 * (low + high);
                (0.5 * std::erfc(-middle / std::sqrt(2.0)) < p ? low : high) = middle;
            }
            const double value = spread_value(input, low);
            CHECK(value >= input.low);
            CHECK(value <= input.high);
            mean += value / count;
            square += value * value / count;
        }
        return std::pair{mean, std::sqrt(square - mean * mean)};
    };
    for (const UncertainInput& input :
         {UncertainInput{Key::eta0, 10.0, 1.5, SpreadKind::log_normal, 0.0, 1e9, ""},
          UncertainInput{Key::shear_modulus, 295.0, 289.0, SpreadKind::log_normal, 0.0, 1e9, ""},
          UncertainInput{Key::alpha, 0.75, 0.05, SpreadKind::normal, 0.0, 1.0, ""},
          UncertainInput{Key::radius, 50e-6, 1e-6 / std::sqrt(3.0), SpreadKind::uniform, 49e-6, 51e-6, ""}}) {
        const auto [mean, deviation] = moments(input);
        CHECK(mean == doctest::Approx(input.value).epsilon(2e-3));
        CHECK(deviation == doctest::Approx(input.standard_deviation).epsilon(0.02));
    }
    // Cut at its bounds, alpha stays inside however wide it is.
    moments({Key::alpha, 0.95, 0.3, SpreadKind::normal, 0.0, 1.0, ""});
}

TEST_CASE(
    "uncertainty: of a Newtonian ink the gradient is a product of log-normals with known spread and shares") {
    // G = 8 (eta0/2) u / R^2 with all three log-normal: ln G is normal, with the sum of their variances.
    const Json answer = answered(settings({{Key::alpha, "0"},
                                           {Key::eta0, "10Pa.s±20%"},
                                           {Key::velocity, "5mm/s±10%"},
                                           {Key::radius, "50um±4%"},
                                           {Key::model, "steady"}}));
    const Json& g = answer["uncertainty"]["nozzle"]["pressure_gradient"];
    const auto of_log = [](double variation) { return std::log1p(variation * variation); };
    const double s_eta = of_log(0.2);
    const double s_u = of_log(0.1);
    const double s_r = 4.0 * of_log(0.04);  // the square of the radius
    const double sigma2 = s_eta + s_u + s_r;
    // Means: E[eta] E[u] E[R^-2]; a log-normal's inverse square has the mean R^-2 exp(3 s), s of R itself.
    const double mean = 8.0 * 5.0 * 5e-3 / (50e-6 * 50e-6) * std::exp(3.0 * of_log(0.04));
    CHECK(g["mean"].get<double>() == doctest::Approx(mean).epsilon(mean_tolerance));
    CHECK(g["standard_deviation"].get<double>() ==
          doctest::Approx(mean * std::sqrt(std::expm1(sigma2))).epsilon(spread_tolerance));
    const double median = mean * std::exp(-0.5 * sigma2);
    CHECK(g["percentile_50"].get<double>() == doctest::Approx(median).epsilon(quantile_tolerance));
    CHECK(g["percentile_5"].get<double>() ==
          doctest::Approx(median * std::exp(-1.64485 * std::sqrt(sigma2))).epsilon(quantile_tolerance));
    CHECK(g["percentile_95"].get<double>() ==
          doctest::Approx(median * std::exp(1.64485 * std::sqrt(sigma2))).epsilon(quantile_tolerance));
    const Json& shares = g["first_order"];
    CHECK(std::abs(shares["eta0"].get<double>() - std::expm1(s_eta) / std::expm1(sigma2)) < share_tolerance);
    CHECK(std::abs(shares["velocity"].get<double>() - std::expm1(s_u) / std::expm1(sigma2)) <
          share_tolerance);
    CHECK(std::abs(shares["radius"].get<double>() - std::expm1(s_r) / std::expm1(sigma2)) < share_tolerance);
    // The rate does not know the viscosity.
    CHECK(answer["uncertainty"]["nozzle"]["shear_rate_max"]["first_order"]["eta0"].get<double>() <
          share_tolerance);
}

TEST_CASE("uncertainty: the gradient of a Newtonian ink is linear in its viscosity and has its spread") {
    const Json answer =
        answered(settings({{Key::alpha, "0"}, {Key::eta0, "10±1.5Pa.s"}, {Key::model, "steady"}}));
    const Json& g = answer["uncertainty"]["nozzle"]["pressure_gradient"];
    const double nominal = answer["nozzle"]["pressure_gradient"].get<double>();
    CHECK(g["mean"].get<double>() == doctest::Approx(nominal).epsilon(1e-3));
    CHECK(g["standard_deviation"].get<double>() == doctest::Approx(0.15 * nominal).epsilon(spread_tolerance));
    CHECK(g["first_order"]["eta0"].get<double>() > 0.99);
    // The velocity is given and has none.
    CHECK(answer["uncertainty"]["nozzle"]["velocity_average"]["standard_deviation"] == 0.0);
}

TEST_CASE("uncertainty: the same bytes for any number of threads") {
    const Settings question = settings({{Key::radius, "50±2um"}});
    CHECK(json_text(answered(question, true, 1)) == json_text(answered(question, true, 4)));
}

TEST_CASE("uncertainty: presets bring their scatter and what is given exactly has none") {
    const auto names = [](const Settings& question) {
        std::string all;
        const Json answer = answer_object(predict(question.make_case()));
        for (const UncertainInput& input : uncertain_inputs(question, answer, true).inputs) {
            all += std::string(info_of(input.key).option) + " ";
        }
        return all;
    };
    CHECK(names({}) == "eta0 time-constant alpha ");
    CHECK(names(settings({{Key::alpha, "0.7±0"}, {Key::eta0, "12±1"}})) == "eta0 time-constant ");
    CHECK(names(settings({{Key::needle, "25G"}, {Key::tip, "hypodermic"}})) ==
          "radius eta0 time-constant alpha ");
    const Json answer = answer_object(predict(Case(Settings{}.make_case())));
    const std::vector<UncertainInput> inputs = uncertain_inputs({}, answer, true).inputs;
    CHECK(inputs.at(0).standard_deviation == doctest::Approx(1.5));
    CHECK(inputs.at(1).standard_deviation == doctest::Approx(0.013));
    CHECK(inputs.at(2).standard_deviation == doctest::Approx(0.045));
    CHECK(inputs.at(0).source.find("eLife") != std::string::npos);
    // A preset that states its own.
    const InkPreset* own = nullptr;
    for (const InkPreset& preset : ink_presets()) {
        if (preset.sd("eta0")) own = &preset;
    }
    REQUIRE(own != nullptr);
    const Settings measured = settings({{Key::ink, own->name.c_str()}});
    const Json with = answer_object(predict(measured.make_case()));
    CHECK(uncertain_inputs(measured, with, true).inputs.at(0).standard_deviation == own->sd("eta0"));
}

TEST_CASE("uncertainty: samples without an answer are counted and said and left out") {
    // Past a wall stress of 200 Pa an ink of alpha 1 has no steady flow; some samples are.
    const Settings question =
        settings({{Key::alpha, "1"}, {Key::pressure_gradient, "7MPa/m±20%"}, {Key::model, "steady"}});
    const Json answer = answered(question);
    const std::size_t failed = answer["uncertainty"]["failed"].get<std::size_t>();
    CHECK(failed > 100);  // a quarter of 1024
    CHECK(failed < 500);
    CHECK(answer["uncertainty"]["failure"].get<std::string>().find("no steady flow") != std::string::npos);
    CHECK(answer["warnings"].back()["code"] == "failed_samples");
    CHECK(answer["uncertainty"]["nozzle"]["stress_max"]["percentile_95"].get<double>() < 200.0);
}

TEST_CASE("uncertainty: nothing uncertain is a mistake of the call") {
    const Settings question = settings({{Key::alpha, "0.75"}});
    Json answer = answer_object(predict(question.make_case()));
    CHECK_THROWS_AS(add_uncertainty(answer, question, {}, 1), UsageError);
}
