#include <doctest/doctest.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <string>

#include "cli/command.hpp"
#include "support/text.hpp"

using bioprint::test::Outcome;
using bioprint::test::read_scratch;
using bioprint::test::run;
using bioprint::test::scratch_exists;
using bioprint::test::write_scratch;
using bioprint::testing::contains;
using nlohmann::json;

namespace {

const std::string draft = "-q --simulate=channel --fidelity draft ";

/// One line, and the program's name before it.
bool is_one_line(const std::string& text) {
    return text.starts_with("bioprint-predict: ") && std::count(text.begin(), text.end(), '\n') == 1;
}

/// What does not depend on how busy the machine is.
json timeless(const std::string& text) {
    json answer = json::parse(text);
    answer["simulation"].erase("wall_time");
    answer["simulation"].erase("updates_per_second");
    return answer;
}

}  // namespace

TEST_CASE("long run: the directory holds question and checkpoint and series and answer") {
    const Outcome plain = run(draft + "--json --alpha 0.5");
    const Outcome kept = run(draft + "--json --alpha 0.5 --out kept");
    CHECK(kept.status == 0);
    CHECK(kept.err.empty());
    CHECK(timeless(read_scratch("kept/answer.json")) == timeless(plain.out));
    CHECK(json::parse(read_scratch("kept/question.json"))["options"][3] == json({"--alpha", "0.5"}));
    const json checkpoint = json::from_cbor(read_scratch("kept/checkpoint.cbor"));
    CHECK(checkpoint["format"] == "bioprint-checkpoint/1");
    CHECK(checkpoint["content"].is_binary());
    const json series = json::parse(plain.out)["simulation"]["series"];
    const std::string csv = read_scratch("kept/series.csv");
    CHECK(csv.starts_with("time [s],x [m],von_mises [Pa]"));
    CHECK(static_cast<std::size_t>(std::count(csv.begin(), csv.end(), '\n')) ==
          series["time [s]"].size() + 1);
}

TEST_CASE("long run: a run that came to its end answers again from its directory alone") {
    const Outcome first = run(draft + "--alpha 0.25 --out finished");
    CHECK(first.status == 0);
    const Outcome again = run("--resume finished -q --json");
    CHECK(again.status == 0);
    CHECK(timeless(again.out) == timeless(read_scratch("finished/answer.json")));
    CHECK(timeless(run("--resume finished --json --jobs 1").out) == timeless(again.out));
}

TEST_CASE("long run: a directory that holds a run or other files is refused with its remedy") {
    CHECK(run(draft + "--out twice").status == 0);
    const std::string answer = read_scratch("twice/answer.json");
    const Outcome second = run(draft + "--alpha 0 --out twice");
    CHECK(second.status == 2);
    CHECK(is_one_line(second.err));
    CHECK(contains(second.err, "--resume twice"));
    CHECK(read_scratch("twice/answer.json") == answer);
    run("--version >/dev/null; mkdir -p mine; touch mine/answer.json; true");
    const Outcome mine = run(draft + "--out mine");
    CHECK(mine.status == 2);
    CHECK(contains(mine.err, "holds other files"));
    CHECK_FALSE(scratch_exists("mine/question.json"));
}

TEST_CASE("long run: beside resume an option of the question must be what it was") {
    CHECK(run(draft + "--radius 50um --out asked").status == 0);
    CHECK(run(draft + "--radius 50um --resume asked").status == 0);
    const Outcome other = run("--resume asked --radius 60um --alpha 0");
    CHECK(other.status == 2);
    CHECK(contains(other.err, "--radius: got '60um', but the run in asked was asked with '50um'"));
    CHECK(contains(other.err, "--alpha: got '0', but the run in asked was asked without it"));
    CHECK(run("--resume asked --out other").status == 2);
    CHECK(run("--resume nowhere").status == 2);
    CHECK(run("--resume ''").status == 2);
    CHECK(run("--out somewhere").status == 2);
    CHECK(run(draft + "--checkpoint-interval 1s").status == 2);
    CHECK(run(draft + "--out x --checkpoint-interval 1m").status == 2);
    CHECK_FALSE(scratch_exists("x"));
}

TEST_CASE("long run: a refused question leaves no directory behind") {
    CHECK(run(draft + "--radius 5um --out refused").status == 2);
    CHECK(run("--simulate --resolution 3 --shear-modulus 1e13 --out refused").status == 2);
    CHECK(run("--simulate --alpha 2 --velocity 1m/s --out refused").status == 3);
    CHECK(run(draft + "--ink ./missing.json --out refused").status == 4);
    CHECK_FALSE(scratch_exists("refused"));
    CHECK(run(draft + "--out no/such/place").status == 4);
}

TEST_CASE("long run: a damaged checkpoint is recognised and said with status 4") {
    CHECK(run(draft + "--out damaged").status == 0);
    const std::string whole = read_scratch("damaged/checkpoint.cbor");
    const auto refusal = [&](const std::string& bytes) {
        write_scratch("damaged/checkpoint.cbor", bytes);
        const Outcome outcome = run("--resume damaged --json");
        CHECK(outcome.status == 4);
        CHECK(outcome.out.empty());
        CHECK(is_one_line(outcome.err));
        return outcome.err;
    };
    for (const std::size_t size : {std::size_t{0}, std::size_t{1}, whole.size() / 2, whole.size() - 1}) {
        CHECK(
            contains(refusal(whole.substr(0, size)), "damaged/checkpoint.cbor: the checkpoint is cut short"));
    }
    std::string flipped = whole;
    flipped[whole.size() / 2] = static_cast<char>(flipped[whole.size() / 2] ^ 1);
    CHECK(contains(refusal(flipped), "the checkpoint is damaged"));
    CHECK(contains(refusal("\xA0"), "damaged"));
    // Without it the run begins anew and ends the same.
    const json answer = timeless(read_scratch("damaged/answer.json"));
    run("--version; rm damaged/checkpoint.cbor; true");
    CHECK(timeless(run("--resume damaged -q --json").out) == answer);
}

TEST_CASE("long run: an ink of a file is kept with the run") {
    write_scratch("own.json", R"({"name": "own", "source": "our rheometer", "parameters": {
        "eta0": {"value": 7, "unit": "Pa.s"}, "time_constant": {"value": 20, "unit": "ms"},
        "alpha": {"value": 0.6, "unit": "1"}}})");
    const Outcome first = run(draft + "--ink ./own.json --out inked --json");
    CAPTURE(first.err);
    REQUIRE(first.status == 0);
    run("--version; rm own.json; true");
    CHECK(timeless(run("--resume inked -q").out) == timeless(first.out));
}

TEST_CASE("long run: the files of a simulation do not depend on the number of threads") {
    CHECK(run("-q --simulate --fidelity draft --jobs 1 --out one").status == 0);
    CHECK(run("-q --simulate --fidelity draft --jobs 2 --out two").status == 0);
    CHECK(timeless(read_scratch("one/answer.json")) == timeless(read_scratch("two/answer.json")));
    for (const char* name : {"series.csv", "cell.pvd", "frames/cell_0005.vtu", "frames/flow_0005.vti"}) {
        CHECK(read_scratch("one/" + std::string(name)) == read_scratch("two/" + std::string(name)));
    }
    const std::string off =
        "-q --simulate=channel --offset 1.5Rc --channel-time 2ms --fidelity draft --json --jobs ";
    CHECK(timeless(run(off + "1").out) == timeless(run(off + "2").out));
}

TEST_CASE("long run: a kept batch and a kept sweep are those of the plain call") {
    write_scratch("kept.csv", "run,radius [um],alpha\r\nA,50,0.5\r\n\r\nB,60,2\r\n");
    const Outcome plain = run("-q --batch kept.csv");
    const Outcome kept = run("-q --batch kept.csv --out batch");
    CHECK(kept.status == 6);
    CHECK(kept.out.empty());
    CHECK(read_scratch("batch/answers.csv") == plain.out);
    CHECK_FALSE(scratch_exists("batch/answers.unfinished"));
    CHECK(run("--resume batch").status == 6);
    CHECK(run("-q --radius 40:60:1um --out sweep").status == 0);
    CHECK(read_scratch("sweep/answers.csv") == run("--radius 40:60:1um --format csv").out);
    CHECK(run("--batch - --out stream").status == 2);
    CHECK(run("--batch kept.csv --format table --out table").status == 2);
    CHECK(run("--resume batch --format json").status == 2);
}

TEST_CASE("long run: an input that has changed is not mixed with what was answered before") {
    write_scratch("changing.csv", "radius [um]\n50\n");
    CHECK(run("-q --batch changing.csv --out changing").status == 0);
    write_scratch("changing.csv", "radius [um]\n60\n");
    const Outcome outcome = run("--resume changing");
    CHECK(outcome.status == 4);
    CHECK(is_one_line(outcome.err));
    CHECK(contains(outcome.err, "has changed since the run in changing began"));
}

TEST_CASE("long run: a sweep of simulations is the single ones and its pieces and kept rows are the whole") {
    const std::string sweep = draft + "--offset 0 --alpha 0,0.5,1.5 ";
    const std::string values = "--get input.ink.alpha --get simulation.simulated.von_mises ";
    const Outcome whole = run(sweep + values);
    CHECK(whole.status == 6);  // no steady flow at 1.5
    CHECK(std::count(whole.out.begin(), whole.out.end(), '\n') == 3);
    CHECK(whole.out.ends_with("1.5\tnull\n"));
    const Outcome single =
        run(draft + "--offset 0 --alpha 0.5 --jobs 1 --get simulation.simulated.von_mises");
    CHECK(contains(whole.out, "0.5\t" + single.out));
    CHECK(run(sweep + values + "--shard 1/2").out + run(sweep + values + "--shard 2/2").out == whole.out);
    CHECK(run(sweep + values + "--jobs 1").out == whole.out);
    CHECK(run(sweep + values + "--out simulated-sweep").status == 6);
    CHECK(read_scratch("simulated-sweep/answers.txt") == whole.out);
    const Outcome lines = run(sweep);
    CHECK(json::parse(lines.out.substr(0, lines.out.find('\n')))["simulation"]["simulated"].contains(
        "von_mises"));
    CHECK(is_one_line(run(sweep + "--format csv").err));
    CHECK(is_one_line(run(sweep + "--plot x.svg").err));
}
