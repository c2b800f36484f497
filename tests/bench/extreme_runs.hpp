#pragma once

#include <optional>
#include <string>
#include <vector>

#include "bench/extreme_scenes.hpp"

/// One question to the real program, in a process of its own with a limit on time and memory, and the verdict on what
/// came back.
namespace bioprint::extremes {

/// How a process ended.
struct Ended {
    int status;      ///< exit status; 128 + signal when killed
    double seconds;  ///< of processor
    double memory;   ///< largest resident set [B]
    std::string out, err;
};

/// The program, and what it may take.
struct Limits {
    std::string program = BIOPRINT_PROGRAM;
    double seconds = 40.0;  ///< of processor
    double memory = 4e9;    ///< [B] of address space
};

Ended run_program(const std::vector<std::string>& arguments, const Limits& limits);

/// What became of a scene. The first three are as they should be.
enum class Verdict {
    within,       ///< answered; every value that a reference exists for lies within the stated errors
    unjudged,     ///< answered; no reference was at hand
    warned,       ///< answered with a warning that the values are not those of a steady, well resolved cell
    refused,      ///< before the run, in one line that names an option
    out_of_time,  ///< still computing at the campaign's limit
    broke_down,   ///< status 5, after a run
    beyond,       ///< answered without a warning, off by more than the stated errors
    unclear,      ///< refused in a line that names no option
    not_a_number,
    crashed,  ///< a signal, or status 1
};
const char* name_of(Verdict verdict);
bool is_sound(Verdict verdict);

struct Outcome {
    Verdict verdict;
    Ended ended;
    std::string remark;    ///< the program's line, or the codes of its warnings
    std::string quantity;  ///< the value that lies farthest from its reference, in terms of the errors
    double value = 0.0;
    double stated_error = 0.0;     ///< relative
    double deviation = 0.0;        ///< of the value from the reference, relative
    double reference_error = 0.0;  ///< of the reference, relative
    std::string reference;         ///< where it is from; empty: none
};

/// Asks at draft resolution and judges. Where no theory is exact and `finer` is set, a run with twice the nodes
/// is the reference.
Outcome ask(const ExtremeScene& scene, bool finer, const Limits& limits);

}  // namespace bioprint::extremes
