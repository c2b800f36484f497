#pragma once

#include <string>
#include <string_view>

/// The real program, called as a user calls it.
namespace bioprint::test {

struct Outcome {
    int status;  ///< exit status, 128 + signal when killed
    std::string out;
    std::string err;
};

/// Runs the program through a shell in a scratch directory that is this test program's own.
/// @param arguments  as typed in a shell, quotes and redirections included
Outcome run(const std::string& arguments, std::string_view input = {});

/// A file in the scratch directory.
void write_scratch(const std::string& name, std::string_view content);
std::string read_scratch(const std::string& name);
bool scratch_exists(const std::string& name);

}  // namespace bioprint::test
