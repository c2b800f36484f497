#include "bioprint/io/presets.hpp"

#include <doctest/doctest.h>
#include <unistd.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <set>
#include <string>

#include "bioprint/errors.hpp"
#include "io/preset_reader.hpp"
#include "io/text.hpp"

using namespace bioprint;

namespace {

template <typename Call>
std::string refusal(Call call) {
    try {
        call();
    } catch (const UsageError& error) {
        return error.what();
    }
    return "accepted";
}

constexpr std::string_view good_ink =
    R"({"name": "mine", "parameters": {"eta0": {"value": 2, "unit": "kPa.s", "sd": 0.5}, "time_constant": "50 ms", "alpha": 0.5}})";

std::string with(std::string_view from, std::string_view to) {
    std::string text(good_ink);
    const auto at = text.find(from);
    REQUIRE(at != std::string::npos);
    return text.replace(at, from.size(), to);
}

void check_physical(const CrossInk& law) {
    CHECK(law.eta0 > 0.0);
    CHECK(law.eta0 < 1e4);
    CHECK(law.eta_inf >= 0.0);
    CHECK(law.eta_inf < law.eta0);
    CHECK(law.time_constant > 1e-3);
    CHECK(law.time_constant < 100.0);
    CHECK(law.alpha > 0.0);
    CHECK(law.alpha < 1.0);
}

void check_physical(const PowerLawInk& law) {
    CHECK(law.consistency > 0.01);
    CHECK(law.consistency < 1e4);
    CHECK(law.flow_index > 0.0);
    CHECK(law.flow_index <= 1.0);
}

void check_physical(const CarreauYasudaInk& law) {
    CHECK(law.eta0 > 0.0);
    CHECK(law.eta0 < 1e5);
    CHECK(law.eta_inf < law.eta0);
    CHECK(law.time_constant > 1e-3);
    CHECK(law.transition > 0.0);
    CHECK(law.flow_index < 1.0);
}

void check_physical(const HerschelBulkleyInk& law) {
    check_physical(PowerLawInk{.consistency = law.consistency, .flow_index = law.flow_index});
    CHECK(law.yield_stress > 0.0);
    CHECK(law.yield_stress < 1e4);
}

std::string ink_refusal(const std::string& json) {
    return refusal([&] { read_single_ink(json, "my.json"); });
}

}  // namespace

TEST_CASE("presets: the reference ink and cell are those of the paper") {
    const InkPreset& ink = find_ink("alginate-2.5");
    CHECK(cross_law(ink.ink).eta0 == 10.0);
    CHECK(cross_law(ink.ink).eta_inf == 0.0);
    CHECK(cross_law(ink.ink).time_constant == 0.05);
    CHECK(cross_law(ink.ink).alpha == 0.75);
    const CellPreset& cell = find_cell("reference");
    CHECK(cell.radius == 8e-6);
    CHECK(cell.shear_modulus == 1000.0);
    CHECK(cell.poisson_ratio == 0.48);
    CHECK(cell.viscosity_ratio == 1.0);
}

TEST_CASE("presets: every ink is physical and has a source") {
    CHECK(ink_presets().size() >= 31);
    for (const auto& preset : ink_presets()) {
        CAPTURE(preset.name);
        std::visit([](const auto& law) { check_physical(law); }, preset.ink);
        if (preset.temperature) CHECK(std::abs(*preset.temperature - 30.0) <= 30.0);
        if (preset.shear_rate_range) CHECK(preset.shear_rate_range->min < preset.shear_rate_range->max);
        CHECK(preset.source.size() > 20);
        CHECK((preset.grade == "A" || preset.grade == "B" || preset.grade == "C"));
        CHECK(viscosity(preset.ink, 100.0) <= viscosity(preset.ink, 1.0));
    }
}

TEST_CASE("presets: every cell is physical and tells something and has a source") {
    for (const auto& preset : cell_presets()) {
        CAPTURE(preset.name);
        CHECK((preset.radius || preset.shear_modulus || !preset.viability_thresholds.empty()));
        if (preset.radius) CHECK((*preset.radius > 2e-6 && *preset.radius < 3e-5));
        if (preset.shear_modulus) CHECK((*preset.shear_modulus > 10.0 && *preset.shear_modulus < 1e5));
        if (preset.poisson_ratio) CHECK((*preset.poisson_ratio > 0.0 && *preset.poisson_ratio < 0.5));
        for (const auto& threshold : preset.viability_thresholds) {
            CHECK((threshold.exposure > 0.01 && threshold.exposure < 10.0));
            CHECK((threshold.wall_stress > 100.0 && threshold.wall_stress < 1e5));
            CHECK((threshold.viability > 0.0 && threshold.viability < 1.0));
        }
        CHECK(preset.source.size() > 20);
    }
    // A longer exposure bears less stress.
    const auto& hela = find_cell("HeLa").viability_thresholds;
    REQUIRE(hela.size() == 2);
    CHECK(hela[0].exposure == 0.1);
    CHECK(hela[0].wall_stress == 4240.0);
    CHECK(hela[1].wall_stress < hela[0].wall_stress);
}

TEST_CASE("presets: bores shrink as gauges grow and every nozzle has a source") {
    for (const Tip tip : {Tip::steel, Tip::tapered, Tip::hypodermic}) {
        double last = 1.0;
        int count = 0;
        for (const auto& nozzle : nozzle_presets()) {
            if (nozzle.tip != tip) continue;
            CAPTURE(nozzle.name);
            CHECK(nozzle.radius > 0.0);
            CHECK(nozzle.radius <= last);
            CHECK(nozzle.tapered == (tip == Tip::tapered));
            CHECK(nozzle.source.size() > 20);
            CHECK(nozzle.name == std::to_string(nozzle.gauge) + "G " + std::string(tip_name(tip)));
            last = nozzle.radius;
            ++count;
        }
        CHECK(count >= 7);
    }
}

TEST_CASE("presets: no name or alias means two things") {
    std::set<std::string> names;
    for (const auto& preset : ink_presets()) {
        CHECK(names.insert(lower_case(preset.name)).second);
        for (const auto& alias : preset.aliases) CHECK(names.insert(lower_case(alias)).second);
        CHECK(&find_ink(preset.name) == &preset);
    }
    names.clear();
    for (const auto& preset : cell_presets()) {
        CHECK(names.insert(lower_case(preset.name)).second);
        for (const auto& alias : preset.aliases) CHECK(names.insert(lower_case(alias)).second);
    }
}

TEST_CASE("presets: an unknown name gets the nearest known one") {
    CHECK(refusal([] { find_ink("alginat-2.5"); }) ==
          "--ink: got 'alginat-2.5', no known ink; did you mean 'alginate-2.5'? --list inks shows all");
    CHECK(refusal([] { find_cell("xyz"); }) == "--cell: got 'xyz', no known cell; --list cells shows all");
    CHECK(find_ink(" ALGINATE-2.5 ").name == "alginate-2.5");
    CHECK(find_cell("msc").name == "hmsc");
}

TEST_CASE("presets: a gauge without a tip takes steel and tells the others") {
    const auto choice = find_nozzle("25G", {});
    CHECK(choice.nozzle.radius == 125e-6);
    CHECK(choice.tip_assumed);
    CHECK(describe(choice) ==
          "25G steel: bore 250 µm; no tip was named, other tips of this gauge: tapered 250 µm, hypodermic "
          "260 µm");
    const auto named = find_nozzle("25", Tip::hypodermic);
    CHECK(named.nozzle.radius == 130e-6);
    CHECK_FALSE(named.tip_assumed);
    CHECK(named.others.empty());
    CHECK(describe(named) == "25G hypodermic: bore 260 µm");
    CHECK(find_nozzle("16g", {}).nozzle.tip == Tip::tapered);
    CHECK(find_nozzle("19 G", {}).nozzle.tip == Tip::hypodermic);
    CHECK(find_nozzle("27 ga", {}).nozzle.gauge == 27);
}

TEST_CASE("presets: an unknown gauge or tip is refused with what there is") {
    CHECK(refusal([] { find_nozzle("26G", Tip::steel); }) ==
          "--needle: got '26G', of which no steel tip is known; there are gauges 14 15 18 20 21 22 23 25 27 "
          "30 32");
    CHECK(refusal([] { find_nozzle("99", {}); }).find("there are gauges 14 15") != std::string::npos);
    for (const auto* text : {"", "G", "abc", "25.5", "0.25mm", "25GG"}) {
        CHECK(refusal([&] { find_nozzle(text, {}); }).find("not a gauge") != std::string::npos);
    }
    CHECK(refusal([] { parse_tip("plastic"); }) ==
          "--tip: got 'plastic'; it takes steel, tapered or hypodermic");
    CHECK(parse_tip("Steel") == Tip::steel);
}

TEST_CASE("presets: an ink of a file may be written in several ways") {
    const InkPreset preset = read_single_ink(good_ink, "my.json");
    CHECK(cross_law(preset.ink).eta0 == 2000.0);
    CHECK(preset.sd("eta0") == 500.0);
    CHECK(cross_law(preset.ink).time_constant == 0.05);
    CHECK(cross_law(preset.ink).alpha == 0.5);
    CHECK_FALSE(preset.temperature.has_value());
    const auto list = read_single_ink("{\"inks\": [" + std::string(good_ink) + "]}", "my.json");
    CHECK(list.name == "mine");
}

TEST_CASE("presets: an ink of a file may say how its parameters hang together and what is not determined") {
    const auto ink = [](const std::string& correlation) {
        return R"({"name": "mine", "law": "power-law", "parameters": {"consistency": {"value": 3, "unit": "Pa.s^n", "sd": 0.1},
            "flow_index": {"value": 0.4, "unit": "1", "determined": false}}, "correlation": )" +
               correlation + "}";
    };
    const InkPreset preset = read_single_ink(
        ink(R"({"parameters": ["flow_index", "consistency"], "matrix": [[1, -0.5], [-0.5, 1]]})"), "my.json");
    CHECK(preset.undetermined == std::vector<std::string>{"flow_index"});
    REQUIRE(preset.correlation.has_value());
    CHECK(preset.correlation->parameters.front() == "flow_index");
    CHECK(preset.correlation->matrix == std::vector<double>{1.0, -0.5, -0.5, 1.0});
    const auto problem = [&](const std::string& correlation) {
        return refusal([&] { read_single_ink(ink(correlation), "my.json"); });
    };
    CHECK(problem(R"({"parameters": ["eta0", "consistency"], "matrix": [[1, 0], [0, 1]]})") ==
          "my.json: correlation.parameters: 'eta0' is none of this ink");
    CHECK(problem(R"({"parameters": ["consistency", "consistency"], "matrix": [[1, 0], [0, 1]]})") ==
          "my.json: correlation.parameters: 'consistency' stands there twice");
    CHECK(problem(R"({"parameters": ["consistency", "flow_index"], "matrix": [[1, 0]]})") ==
          "my.json: correlation.matrix: is not a list of 2 rows of 2 numbers");
    CHECK(problem(R"({"parameters": ["consistency", "flow_index"], "matrix": [[1, 2], [2, 1]]})")
              .find("is no correlation") != std::string::npos);
    CHECK(problem(R"({"parameters": ["consistency", "flow_index"]})").find("matrix: is not a list") !=
          std::string::npos);
}

TEST_CASE("presets: an ink of a file may follow any law") {
    const auto law = [](const std::string& text) {
        return read_single_ink(R"({"name": "mine", "law": )" + text + "}", "my.json").ink;
    };
    const Ink power = law(R"("power-law", "parameters": {"consistency": "3 Pa.s^n", "flow_index": 0.4})");
    CHECK(stress(power, 1.0) == 3.0);
    const Ink yielding = law(
        R"("herschel-bulkley", "parameters": {"yield_stress": "0.2kPa", "consistency": 3, "flow_index": 0.4})");
    CHECK(yield_stress(yielding) == 200.0);
    const Ink carreau =
        law(R"("carreau-yasuda", "parameters": {"eta0": 3, "time_constant": 1, "flow_index": 0.4})");
    CHECK(std::get<CarreauYasudaInk>(carreau).transition == 2.0);
    CHECK(refusal([&] { law(R"("maxwell", "parameters": {})"); }) ==
          "my.json: law: must be cross, power-law, carreau-yasuda or herschel-bulkley");
    CHECK(refusal([&] { law(R"("power-law", "parameters": {"consistency": 3})"); }) ==
          "my.json: parameters.flow_index: is missing");
    CHECK(refusal([&] {
              law(R"("power-law", "parameters": {"eta0": 3})");
          }).find("parameters.eta0: is not known here") != std::string::npos);
}

TEST_CASE("presets: a malformed file is refused with the field at fault") {
    CHECK(ink_refusal(with("kPa.s", "mm")).find("my.json: parameters.eta0.value: got '2 mm', a length") == 0);
    CHECK(ink_refusal(with("\"alpha\"", "\"apha\"")) ==
          "my.json: parameters.apha: is not known here (did you mean 'alpha'?)");
    CHECK(ink_refusal(with(", \"alpha\": 0.5", "")) == "my.json: parameters.alpha: is missing");
    CHECK(ink_refusal(with("0.5}", "-0.5}")) == "my.json: parameters.eta0.sd: is negative");
    CHECK(ink_refusal(with("\"alpha\": 0.5", "\"alpha\": -1")) ==
          "my.json: parameters.alpha: must not be negative");
    CHECK(ink_refusal(with("\"value\": 2", "\"value\": 0")) ==
          "my.json: parameters.eta0: must be greater than 0");
    CHECK(ink_refusal(with("\"value\": 2", "\"value\": \"2\"")) ==
          "my.json: parameters.eta0.value: is not a number");
    CHECK(ink_refusal(with("\"mine\"", "3")) == "my.json: name: is not a text");
    CHECK(ink_refusal("[]") == "my.json: is not an object");
    CHECK(ink_refusal("{}") == "my.json: parameters: is missing");
    CHECK(ink_refusal("{\"inks\": []}") == "my.json: inks: must hold one ink, holds 0");
    CHECK(ink_refusal("{").find("my.json: not JSON") == 0);
}

TEST_CASE("presets: an ink file is read from disk and a missing one is a data error") {
    const auto path =
        std::filesystem::temp_directory_path() / ("bioprint-ink-" + std::to_string(::getpid()) + ".json");
    std::ofstream(path) << "\xEF\xBB\xBF" << good_ink;
    CHECK(cross_law(load_ink_file(path.string()).ink).eta0 == 2000.0);
    std::filesystem::remove(path);
    CHECK_THROWS_AS(load_ink_file(path.string()), DataError);
    CHECK_THROWS_AS(load_ink_file("/"), DataError);
}
