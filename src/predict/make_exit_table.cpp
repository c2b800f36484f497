#include <algorithm>
#include <cmath>
#include <cstdio>
#include <string>
#include <utility>
#include <vector>

#include "predict/exit_kind.hpp"
#include "predict/exit_series.hpp"
#include "predict/exit_simulated.hpp"

// Turns the simulated exit profiles into the table of exit_axis.hpp.
//
//   make_exit_table data/exit/axis_profiles.csv > src/predict/exit_axis_table.hpp
//
// The nodes of exit_series.hpp are fitted by least squares over the two numbers of exit_kind.hpp. To standard error:
// what the fit leaves at every ink, those held out of it included.

using namespace bioprint;

namespace {

using Line = std::vector<double>;

/// Least squares by the normal equations; the Chebyshev terms keep them well conditioned.
std::vector<Line> solve(std::vector<Line> a, std::vector<Line> b) {
    const std::size_t n = a.size();
    for (std::size_t i = 0; i < n; ++i) {
        std::size_t pivot = i;
        for (std::size_t r = i; r < n; ++r) {
            if (std::abs(a[r][i]) > std::abs(a[pivot][i])) pivot = r;
        }
        std::swap(a[i], a[pivot]);
        std::swap(b[i], b[pivot]);
        for (std::size_t r = 0; r < n; ++r) {
            if (r == i) continue;
            const double factor = a[r][i] / a[i][i];
            for (std::size_t c = i; c < n; ++c) a[r][c] -= factor * a[i][c];
            for (std::size_t c = 0; c < b[r].size(); ++c) b[r][c] -= factor * b[i][c];
        }
    }
    for (std::size_t i = 0; i < n; ++i) {
        for (double& v : b[i]) v /= a[i][i];
    }
    return b;
}

ExitTerms terms_of(const SimulatedExit& ink) {
    return exit_terms(exit_kind(ink.excess, ink.wall_index));
}

/// Fits the terms from `first` to `last` to what the others leave, at the chosen inks.
template <typename Chosen>
void fit(const std::vector<SimulatedExit>& inks, const Line& newtonian, std::size_t first, std::size_t last,
         const Chosen& chosen, std::vector<Line>& series) {
    const std::size_t n = last - first;
    std::vector<Line> a(n, Line(n, 0.0));
    std::vector<Line> b(n, Line(newtonian.size(), 0.0));
    for (const SimulatedExit& ink : inks) {
        if (!chosen(ink)) continue;
        const ExitTerms t = terms_of(ink);
        for (std::size_t i = 0; i < n; ++i) {
            for (std::size_t j = 0; j < n; ++j) a[i][j] += t[first + i] * t[first + j];
            for (std::size_t k = 0; k < newtonian.size(); ++k) {
                double rest = ink.nodes[k] - newtonian[k];
                for (std::size_t m = 0; m < first; ++m) rest -= t[m] * series[m][k];
                b[i][k] += t[first + i] * rest;
            }
        }
    }
    for (Line& line : solve(a, b)) series.push_back(line);
}

void report(const std::vector<SimulatedExit>& inks, const Line& x, const Line& newtonian,
            const std::vector<Line>& series) {
    for (const SimulatedExit& ink : inks) {
        const ExitTerms t = terms_of(ink);
        ExitNodes nodes{};
        for (std::size_t k = 0; k < nodes.size(); ++k) {
            nodes[k] = newtonian[k];
            for (std::size_t i = 0; i < exit_term_count; ++i) nodes[k] += t[i] * series[i][k];
        }
        const ExitSpline spline(nodes);
        Line f;
        std::size_t piece = 0;
        for (const double at : x) f.push_back(exit_share(spline.at(at, piece).logit).value);
        double error = 0.0;
        double steepest = 0.0;
        double slope_error = 0.0;
        for (std::size_t k = 1; k + 1 < x.size(); ++k) {
            error = std::max(error, std::abs(f[k] - ink.exact[k]));
            const double slope = (ink.exact[k + 1] - ink.exact[k - 1]) / (x[k + 1] - x[k - 1]);
            steepest = std::max(steepest, std::abs(slope));
            slope_error =
                std::max(slope_error, std::abs((f[k + 1] - f[k - 1]) / (x[k + 1] - x[k - 1]) - slope));
        }
        const ExitKind kind = exit_kind(ink.excess, ink.wall_index);
        std::fprintf(stderr, "%-18s %s n_e %.3f n_w %.3f  nodes %d  f %.5f  slope %.4f of its peak %.3f\n",
                     ink.name.c_str(), ink.held_out ? "held out" : "        ", kind.index, kind.wall_index,
                     ink.f.rbegin()->first, error, slope_error / steepest, steepest);
    }
}

void print(const char* open, const Line& line, const char* close) {
    std::printf("%s", open);
    for (std::size_t i = 0; i < line.size(); ++i)
        std::printf("%s%.6g", i == 0 ? "" : i % 14 == 0 ? ",\n " : ", ", line[i]);
    std::printf("%s\n", close);
}

}  // namespace

int main(int argc, char** argv) {
    if (argc < 2) return 2;
    const auto [x, inks] = read_simulated_exits(argv[1]);
    const auto base =
        std::find_if(inks.begin(), inks.end(), [](const SimulatedExit& ink) { return ink.alpha == 0.0; });
    if (base == inks.end()) {
        std::fprintf(stderr, "the Newtonian ink is missing\n");
        return 4;
    }
    const Line& newtonian = base->nodes;
    std::vector<Line> series;
    fit(
        inks, newtonian, 0, exit_cross_terms,
        [](const SimulatedExit& ink) { return !ink.held_out && ink.alpha > 0.0; }, series);
    fit(
        inks, newtonian, exit_cross_terms, exit_term_count,
        [](const SimulatedExit& ink) { return ink.remainder > 0.0; }, series);
    report(inks, x, newtonian, series);

    std::printf(
        "#pragma once\n\n#include <array>\n\n"
        "// Written by make_exit_table from data/exit/axis_profiles.csv; see exit_series.hpp.\n"
        "// clang-format off\nnamespace bioprint {\n\n");
    print(("inline constexpr std::array<double, " + std::to_string(newtonian.size()) + "> exit_newtonian{")
              .c_str(),
          newtonian, "};");
    std::printf("inline constexpr std::array<std::array<double, %zu>, %zu> exit_thinning{{\n",
                newtonian.size(), series.size());
    for (const Line& line : series) print("{{", line, "}},");
    std::printf("}};\n\n}  // namespace bioprint\n// clang-format on\n");
    return 0;
}
