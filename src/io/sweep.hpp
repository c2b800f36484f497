#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "io/settings.hpp"

/// The rows that lists and ranges on the command line span: every combination, the last option fastest.
namespace bioprint {

class Sweep {
  public:
    /// Adds an option in the order the user gave it; `text` is a value, a list or a range.
    /// @throws UsageError
    void add(Key key, std::string_view text, std::string_view origin);

    /// The options with several values, in order; empty for a single question.
    [[nodiscard]] const std::vector<Key>& swept() const { return swept_; }
    /// Number of rows; 1 for a single question.
    [[nodiscard]] std::size_t size() const;
    [[nodiscard]] Settings row(std::size_t index) const;
    /// The swept options alone, as they are in a row.
    [[nodiscard]] Settings swept_values(std::size_t index) const;
    /// The options with one value.
    [[nodiscard]] const Settings& fixed() const { return fixed_; }

  private:
    struct Axis {
        Key key;
        std::string origin;
        std::vector<double> numbers;
        std::vector<std::string> names;
        [[nodiscard]] std::size_t size() const { return numbers.empty() ? names.size() : numbers.size(); }
    };
    Settings fixed_;
    std::vector<Key> swept_;
    std::vector<Axis> axes_;
};

}  // namespace bioprint
