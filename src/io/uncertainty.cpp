#include "io/uncertainty.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "bioprint/errors.hpp"
#include "bioprint/io/number_format.hpp"
#include "numerics/parallel.hpp"
#include "numerics/quasi_random.hpp"
#include "numerics/sample_statistics.hpp"

namespace bioprint {
namespace {

constexpr std::array<const char*, 5> sections = {"nozzle", "exit", "cells", "passages", "population"};
constexpr std::size_t usual_samples = 1024;
constexpr std::size_t population_samples = 256;  // each takes some 8 ms

std::string_view kind_name(SpreadKind kind) {
    switch (kind) {
        case SpreadKind::log_normal:
            return "log-normal";
        case SpreadKind::normal:
            return "normal";
        case SpreadKind::uniform:
            return "uniform";
    }
    return "";
}

/// What is known of a model is no result of the inputs.
bool has_spread(const std::string& name) {
    return name != "error" && name != "strain_error";
}

/// The numbers of an answer where the one to the question as it stands has a number or null; NaN where not.
void collect(const Json& shape, const Json* value, std::vector<double>& numbers) {
    if (shape.is_object()) {
        for (const auto& item : shape.items()) {
            if (!has_spread(item.key())) continue;
            const bool has = value != nullptr && value->is_object() && value->contains(item.key());
            collect(item.value(), has ? &value->at(item.key()) : nullptr, numbers);
        }
    } else if (shape.is_array()) {
        for (std::size_t i = 0; i < shape.size(); ++i) {
            const bool has = value != nullptr && value->is_array() && i < value->size();
            collect(shape[i], has ? &value->at(i) : nullptr, numbers);
        }
    } else if (shape.is_number() || shape.is_null()) {
        const bool number = value != nullptr && value->is_number();
        numbers.push_back(number ? value->get<double>() : std::numeric_limits<double>::quiet_NaN());
    }
}

struct Sample {
    std::vector<double> numbers;  ///< as collect(); empty when it has no answer
    std::string failure;
};

class Sampling {
  public:
    Sampling(const Json& answer, const Settings& settings, UncertainInputs uncertain, std::size_t count)
        : answer_(answer),
          settings_(settings),
          uncertain_(std::move(uncertain)),
          inputs_(uncertain_.inputs),
          samples_(count) {
        const std::vector<double> points = sobol_points(inputs_.size(), count);
        normals_.resize(points.size());
        std::transform(points.begin(), points.end(), normals_.begin(), normal_quantile);
        if (!uncertain_.mixing.empty()) mix();
        const Case asked = settings.make_case();
        if (asked.positions.empty()) {
            for (const Json& offset : answer.at("input").at("offsets")) {
                radii_.push_back(offset.get<double>() / asked.cell.radius);
            }
        }
    }

    void run(unsigned jobs) {
        for_each_index(samples_.size(), jobs, [&](std::size_t i) { samples_[i] = sample(i); });
    }

    [[nodiscard]] std::size_t failed() const {
        return static_cast<std::size_t>(std::count_if(samples_.begin(), samples_.end(),
                                                      [](const Sample& s) { return !s.failure.empty(); }));
    }
    [[nodiscard]] const std::string& failure() const {
        static const std::string none;
        const auto first = std::find_if(samples_.begin(), samples_.end(),
                                        [](const Sample& s) { return !s.failure.empty(); });
        return first == samples_.end() ? none : first->failure;
    }

    /// What the sample says of every number, in the answer's own shape.
    [[nodiscard]] Json object() const {
        Json result;
        result["samples"] = samples_.size();
        result["failed"] = failed();
        result["failure"] = failure().empty() ? Json(nullptr) : Json(failure());
        result["inputs"] = Json::array();
        for (const UncertainInput& input : inputs_) result["inputs"].push_back(input_object(input));
        result["correlation"] = correlation_object();
        result["held"] = Json::array();
        for (const Key key : uncertain_.held) result["held"].push_back(info_of(key).option);
        std::size_t next = 0;
        for (const char* const section : sections) {
            if (answer_.contains(section)) result[section] = *mirrored(answer_[section], next);
        }
        return result;
    }

  private:
    /// Independent normals become those of the inputs.
    void mix() {
        const std::size_t n = inputs_.size();
        std::vector<double> own(n);
        for (std::size_t point = 0; point < normals_.size(); point += n) {
            for (std::size_t i = 0; i < n; ++i) {
                own[i] = 0.0;
                for (std::size_t j = 0; j <= i; ++j)
                    own[i] += uncertain_.mixing[i * n + j] * normals_[point + j];
            }
            std::copy(own.begin(), own.end(), normals_.begin() + static_cast<std::ptrdiff_t>(point));
        }
        mixed_.assign(n, false);
        for (std::size_t i = 0; i < n; ++i) {
            for (std::size_t j = 0; j < n; ++j)
                mixed_[i] = mixed_[i] || (i != j && uncertain_.correlation(i, j) != 0.0);
        }
    }

    /// Of the inputs that vary together; null where none do.
    [[nodiscard]] Json correlation_object() const {
        Json names = Json::array();
        Json matrix = Json::array();
        for (std::size_t i = 0; i < inputs_.size(); ++i) {
            if (mixed_.empty() || !mixed_[i]) continue;
            names.push_back(info_of(inputs_[i].key).option);
            Json row = Json::array();
            for (std::size_t j = 0; j < inputs_.size(); ++j) {
                if (mixed_[j]) row.push_back(i == j ? 1.0 : uncertain_.correlation(i, j));
            }
            matrix.push_back(std::move(row));
        }
        if (names.empty()) return nullptr;
        return {{"names", std::move(names)}, {"matrix", std::move(matrix)}};
    }

    [[nodiscard]] Sample sample(std::size_t index) const {
        Sample result;
        try {
            Settings own;
            for (std::size_t i = 0; i < inputs_.size(); ++i) {
                const double z = normals_[index * inputs_.size() + i];
                own.set_number(inputs_[i].key, spread_value(inputs_[i], z), "--uncertainty");
            }
            Case asked = own.over(settings_).make_case();
            asked.profile_points = 0;
            // The usual positions, moved inwards where they do not fit this sample.
            for (const double radii : radii_) {
                asked.positions.push_back(
                    {std::min(radii * asked.cell.radius, std::max(0.0, asked.radius - asked.cell.radius))});
            }
            const Json answer = answer_object(predict(asked));
            for (const char* const section : sections) {
                if (!answer_.contains(section)) continue;
                collect(answer_[section], answer.contains(section) ? &answer[section] : nullptr,
                        result.numbers);
            }
        } catch (const Error& e) {
            result.numbers.clear();
            result.failure = e.what();
        }
        return result;
    }

    [[nodiscard]] static Json input_object(const UncertainInput& input) {
        Json object;
        object["name"] = info_of(input.key).option;
        object["mean"] = input.value;
        object["standard_deviation"] = input.standard_deviation;
        object["distribution"] = kind_name(input.kind);
        object["source"] = input.source;
        return object;
    }

    /// None for texts, which have no spread.
    [[nodiscard]] std::optional<Json> mirrored(const Json& shape, std::size_t& next) const {
        if (shape.is_object()) {
            Json object = Json::object();
            for (const auto& item : shape.items()) {
                if (!has_spread(item.key())) continue;
                if (std::optional<Json> inner = mirrored(item.value(), next))
                    object[item.key()] = std::move(*inner);
            }
            return object;
        }
        if (shape.is_array()) {
            Json list = Json::array();
            for (const Json& entry : shape) list.push_back(mirrored(entry, next).value_or(Json(nullptr)));
            return list;
        }
        if (shape.is_number() || shape.is_null()) return statistics(next++);
        return std::nullopt;
    }

    [[nodiscard]] Json statistics(std::size_t number) const {
        std::vector<double> values;
        std::vector<double> normals;
        for (std::size_t i = 0; i < samples_.size(); ++i) {
            if (samples_[i].numbers.empty() || !std::isfinite(samples_[i].numbers[number])) continue;
            values.push_back(samples_[i].numbers[number]);
            const auto begin = normals_.begin() + static_cast<std::ptrdiff_t>(i * inputs_.size());
            normals.insert(normals.end(), begin, begin + static_cast<std::ptrdiff_t>(inputs_.size()));
        }
        if (values.empty()) return nullptr;
        const SampleStatistics s = sample_statistics(values, normals, inputs_.size(), mixed_);
        Json object;
        object["mean"] = s.mean;
        object["standard_deviation"] = s.standard_deviation;
        object["percentile_5"] = s.quantiles[0];
        object["percentile_50"] = s.quantiles[1];
        object["percentile_95"] = s.quantiles[2];
        object["missing"] = samples_.size() - failed() - values.size();
        Json shares = Json::object();
        for (std::size_t i = 0; i < inputs_.size(); ++i) {
            shares[std::string(info_of(inputs_[i].key).option)] = s.first_order[i];
        }
        object["first_order"] = std::move(shares);
        return object;
    }

    const Json& answer_;
    const Settings& settings_;
    UncertainInputs uncertain_;
    const std::vector<UncertainInput>& inputs_;
    std::vector<double> normals_;  ///< of the inputs, point by point
    std::vector<bool> mixed_;      ///< inputs that vary with others; empty: none do
    std::vector<double> radii_;    ///< the usual positions; empty when they were given
    std::vector<Sample> samples_;
};

}  // namespace

void add_uncertainty(Json& answer, const Settings& settings, const UncertaintyRequest& request,
                     unsigned jobs) {
    UncertainInputs inputs = uncertain_inputs(settings, answer, request.presets);
    if (inputs.inputs.empty()) {
        const std::string why = inputs.held_why.empty() ? "" : " (" + inputs.held_why + ")";
        throw UsageError(
            "--uncertainty: no input has a spread" + why + "; give one, such as --radius 50um±1um",
            "--uncertainty");
    }
    if (!inputs.held_why.empty()) {
        answer["warnings"].push_back({{"code", "undetermined_ink"}, {"message", inputs.held_why}});
    }
    const std::size_t usual = answer.contains("population") ? population_samples : usual_samples;
    Sampling sampling(answer, settings, std::move(inputs), request.samples.value_or(usual));
    sampling.run(jobs);
    answer["uncertainty"] = sampling.object();
    if (sampling.failed() == 0) return;
    answer["warnings"].push_back({{"code", "failed_samples"},
                                  {"message", std::to_string(sampling.failed()) +
                                                  " of the samples have no answer and are left out of the "
                                                  "spread; the first of them: " +
                                                  sampling.failure()}});
}

}  // namespace bioprint
