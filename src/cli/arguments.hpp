#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "io/design.hpp"
#include "io/pictures.hpp"
#include "io/run.hpp"
#include "io/run_directory.hpp"
#include "io/settings.hpp"
#include "io/simulation_answer.hpp"

/// What was typed, checked but not yet computed.
namespace bioprint {

/// A run that is kept in a directory.
struct LongRun {
    std::string directory;
    bool resumed = false;
    double interval = 10.0;  ///< between checkpoints [s]
};

struct Arguments {
    Sweep sweep;
    std::vector<std::pair<Key, std::string>> given;  ///< the prediction's options, in the order typed
    std::optional<std::string> batch;
    std::optional<Format> format;
    std::vector<std::string> paths;
    std::vector<Check> checks;
    UncertaintyRequest uncertainty;
    std::optional<std::string> output;
    std::optional<std::string> list;
    std::optional<std::string> history;
    PicturesQuestion pictures;
    std::optional<Shard> shard;
    std::optional<unsigned> jobs;
    std::optional<SimulationQuestion> simulation;
    std::optional<DesignQuestion> design;  ///< of the subcommand
    std::optional<LongRun> long_run;
    std::optional<LadderQuestion> ladder;
    bool dry_run = false;
    TypedQuestion typed;  ///< every option of the question, as typed
    bool quiet = false;
    bool verbose = false;
    bool no_color = false;
};

/// Parses the command line. `--help` and `--version` are printed and give nothing.
/// @throws UsageError  every problem of the call, one a line
std::optional<Arguments> parse_arguments(int argc, const char* const* argv);

}  // namespace bioprint
