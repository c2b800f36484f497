#pragma once

#include <string>
#include <vector>

#include "io/answer_object.hpp"
#include "io/picture.hpp"

/// `--report`: a question and its answer on one page that needs nothing but itself, to read, keep and print.
namespace bioprint {

struct ReportFigure {
    std::string caption;
    std::string svg;  ///< as gnuplot writes it
};

struct Report {
    std::vector<std::string> call;  ///< the words of the command line, the program first
    Json answer;                    ///< an object, or an array of a sweep's rows
    std::vector<ReportFigure> figures;
    std::string no_figures;  ///< why there are none; empty: there are
};

/// Rows a report shows and holds at most.
inline constexpr std::size_t most_report_rows = 1000;

std::string report_html(const Report& report);

}  // namespace bioprint
