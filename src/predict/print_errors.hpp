#pragma once

#include <algorithm>
#include <array>
#include <limits>

/// How far the models are off for centred cells at the exit, from the simulated prints of
/// tests/reference/exit_cell_simulated.csv: the largest of those with such a cell.
namespace bioprint {

struct PrintErrors {
    bool ellipsoid;    ///< else the steady theory
    double load_from;  ///< σ_elong/μ from (inclusive) …
    double load_to;    ///< … to (exclusive)
    double pull_to;    ///< G R_c/μ up to (inclusive), from that of the line before
    double stress;     ///< relative error of the von Mises stress
    double strain;     ///< of α − 1, the larger of both
    int prints;
};

// clang-format off
// made by tools/make-comparison
inline constexpr std::array<PrintErrors, 4> print_error_table{{
    {false, 0.0, 0.1, 0.7, 0.756, 0.81, 6},
    {true, 0.0, 0.1, 0.7, 0.103, 0.155, 6},
    {true, 0.1, 1.0, 0.7, 0.0479, 0.131, 19},
    {true, 0.1, 1.0, 1.3, 0.107, 0.2, 5},
}};
// end
// clang-format on

/// What is known of a model for such a cell; null when there is no such print.
inline const PrintErrors* print_errors(bool ellipsoid, double load, double pull) {
    const auto* const found =
        std::find_if(print_error_table.begin(), print_error_table.end(), [&](const PrintErrors& p) {
            return p.ellipsoid == ellipsoid && load >= p.load_from && load < p.load_to && pull <= p.pull_to;
        });
    return found == print_error_table.end() ? nullptr : &*found;
}

}  // namespace bioprint
