#include "io/fit_answer.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "bioprint/errors.hpp"
#include "bioprint/io/answer.hpp"
#include "bioprint/io/number_format.hpp"
#include "bioprint/predict/case.hpp"
#include "io/csv.hpp"

namespace bioprint {
namespace {

std::vector<FitPoint> points_of(const RheometerData& data) {
    std::vector<FitPoint> points;
    for (const MeasuredPoint& p : data.points) {
        points.push_back({.rate = p.rate,
                          .measured = p.viscosity,
                          .fitted = 0.0,
                          .used = true,
                          .line = p.line,
                          .interval = p.interval});
    }
    return points;
}

/// The file's name without folders and ending.
std::string stem(const std::string& path) {
    if (path == "-") return "fitted ink";
    const std::size_t slash = path.rfind('/');
    std::string name = slash == std::string::npos ? path : path.substr(slash + 1);
    const std::size_t dot = name.rfind('.');
    if (dot != std::string::npos && dot > 0) name.resize(dot);
    return name.empty() ? "fitted ink" : name;
}

const LawFit& choose(const FitAnswer& answer) {
    const FitQuestion& question = answer.question;
    if (answer.fit.laws.empty()) throw UsageError(answer.data.file + ": too few points for any law");
    const LawFit* const cross = answer.fit.find({FittedLaw::cross, false});
    if (!question.law && cross != nullptr) return cross->aicc ? answer.fit.laws.front() : *cross;
    if (!question.law) {
        throw UsageError(
            answer.data.file + ": " + std::to_string(answer.fit.points_used) +
            " points are too few to choose a law; measure more shear rates, or name a law of few "
            "parameters, such as --law newtonian");
    }
    const bool has_eta_inf = question.law == FittedLaw::cross || question.law == FittedLaw::carreau_yasuda;
    const LawFit* const found = answer.fit.find({*question.law, question.fit_eta_inf && has_eta_inf});
    if (found != nullptr) return *found;
    throw UsageError(answer.data.file + ": " + std::to_string(answer.fit.points_used) +
                     " points are too few for the " + std::string(law_name(*question.law)) +
                     " law; measure more shear rates, or fit a law of fewer parameters with --law");
}

std::string source_of(const FitAnswer& answer) {
    const auto outliers = static_cast<std::size_t>(
        std::count_if(answer.points.begin(), answer.points.end(), [](const FitPoint& p) { return !p.used; }));
    std::string text = std::string(law_name(answer.chosen.choice.law)) + " law fitted to " + answer.data.file;
    std::string numbers;
    std::size_t count = 0;
    for (std::size_t i = 0; i < answer.data.intervals.size(); ++i) {
        if (!answer.data.intervals[i].skipped.empty()) continue;
        numbers += (numbers.empty() ? "" : ", ") + std::to_string(i + 1);
        ++count;
    }
    if (answer.data.intervals.size() > 1) text += (count == 1 ? ", interval " : ", intervals ") + numbers;
    text += ": " + std::to_string(answer.fit.points_used) + " points";
    if (outliers > 0)
        text += ", " + std::to_string(outliers) + (outliers == 1 ? " outlier" : " outliers") + " left out";
    return text + " (" + std::string(program_name) + " " + std::string(program_version()) + ")";
}

/// The viscosity at infinite rate is the least of a law that thins.
void require_below_points(double eta_inf, const std::vector<FlowPoint>& points) {
    double highest = 0.0;
    for (const FlowPoint& p : points) highest = std::max(highest, p.viscosity);
    if (points.empty() || eta_inf < highest) return;
    throw UsageError("--eta-inf: got " + lab_text(eta_inf, Dimension::viscosity) +
                         ", which no point reaches: the highest viscosity measured is " +
                         lab_text(highest, Dimension::viscosity, 4) +
                         "; it must lie below them all, or leave it out",
                     "--eta-inf");
}

}  // namespace

double FitPoint::residual() const {
    return std::log(measured / fitted);
}

FitAnswer answer_fit(const FitQuestion& question) {
    return answer_fit(question, read_rheometer_file(question.file, {.intervals = question.intervals}));
}

FitAnswer answer_fit(const FitQuestion& question, RheometerData data) {
    FitAnswer answer{};
    answer.question = question;
    answer.data = std::move(data);
    answer.points = points_of(answer.data);
    std::vector<FlowPoint> points;
    for (const FitPoint& p : answer.points) {
        points.push_back({.rate = p.rate, .viscosity = p.measured});
    }
    require_below_points(question.eta_inf, points);
    try {
        answer.fit = fit_flow_curve(points, {.eta_inf = question.eta_inf});
    } catch (const UsageError& e) {
        throw UsageError(answer.data.file + ": " + e.what(), answer.data.file);
    }
    answer.chosen = choose(answer);
    answer.rate_low = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < answer.points.size(); ++i) {
        FitPoint& p = answer.points[i];
        p.fitted = answer.chosen.fitted[i];
        p.used = answer.fit.used[i];
        if (!p.used) continue;
        answer.rate_low = std::min(answer.rate_low, p.rate);
        answer.rate_high = std::max(answer.rate_high, p.rate);
    }
    double sum = 0.0;
    std::size_t count = 0;
    for (const MeasuredPoint& p : answer.data.points) {
        if (!p.temperature) continue;
        sum += *p.temperature;
        ++count;
    }
    if (count > 0) answer.temperature = sum / static_cast<double>(count);
    answer.name = question.name.empty() ? stem(question.file) : question.name;
    answer.source = source_of(answer);
    answer.warnings = fit_warnings(answer);
    return answer;
}

std::string not_predicted(const LawFit& fit) {
    std::string text;
    for (const std::string& problem : problems_of(fitted_ink(fit)))
        text += (text.empty() ? "" : "; ") + problem;
    return text;
}

std::string_view fit_unit(std::string_view parameter) {
    if (parameter == "eta0" || parameter == "eta_inf") return "Pa.s";
    if (parameter == "time_constant") return "s";
    if (parameter == "yield_stress") return "Pa";
    if (parameter == "consistency") return "Pa.s^n";
    return "1";
}

double fit_rounded(double value, int digits) {
    if (value == 0.0 || !std::isfinite(value)) return value;
    // The power by which the decimals move; applied so that only representable powers of ten multiply.
    const int shift = digits - 1 - static_cast<int>(std::floor(std::log10(std::abs(value))));
    const double scale = std::pow(10.0, std::abs(shift));
    return shift >= 0 ? std::round(value * scale) / scale : std::round(value / scale) * scale;
}

std::string fit_csv(const FitAnswer& answer) {
    CsvWriter writer(CsvDialect{.line_end = "\r\n"});
    for (const char* const head :
         {"shear_rate [1/s]", "viscosity [Pa.s]", "fitted [Pa.s]", "residual", "used", "line", "interval"}) {
        writer.add_text(head);
    }
    writer.end_row();
    for (const FitPoint& p : answer.points) {
        for (const double value : {p.rate, p.measured, p.fitted, p.residual(), p.used ? 1.0 : 0.0,
                                   static_cast<double>(p.line), static_cast<double>(p.interval)}) {
            writer.add_number(value);
        }
        writer.end_row();
    }
    return writer.text();
}

}  // namespace bioprint
