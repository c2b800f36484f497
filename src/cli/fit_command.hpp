#pragma once

/// `bioprint-predict fit FILE [OPTIONS]`: rheometer data to the parameters of an ink.
namespace bioprint {

/// @param argv  from the word `fit` on
/// @return the exit status
int run_fit_command(int argc, const char* const* argv);

}  // namespace bioprint
