#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "bioprint/predict/prediction.hpp"
#include "io/settings.hpp"

/// The answer for a person at a shell: lab units, aligned, at most 80 columns (names of presets may be
/// longer).
namespace bioprint {

struct TableStyle {
    bool color = false;
    bool quiet = false;  ///< without the notes
};

/// A section's heading, and right-aligned columns whose first `left` are left-aligned.
std::string table_heading(std::string_view text, TableStyle style);
std::string table_grid(const std::vector<std::vector<std::string>>& rows, std::size_t left);
/// `text` broken at spaces into lines of at most 80 columns, all but the first indented.
std::string table_wrapped(std::string_view text, std::size_t indent);

/// The largest stress of a cell in the nozzle, on the way where the cells were carried [Pa].
double nozzle_stress(const Prediction& prediction);
/// The stress at the exit of the cell nearest to the axis by the better model: carried in time where that was
/// asked for, else steady [Pa]. Further out a cell's stress at the exit is mostly what the nozzle left in it.
std::optional<double> exit_stress(const Prediction& prediction);

std::string answer_table(const Prediction& prediction, TableStyle style);

/// One line a row of a sweep: what was swept, then the answers one compares.
class SweepTable {
  public:
    /// @param swept  the keys that change from row to row
    /// @param checks  a last column says whether the checks hold
    explicit SweepTable(std::vector<Key> swept, bool checks = false)
        : swept_(std::move(swept)), checks_(checks) {}
    void add(const Settings& row, const Prediction& prediction, const std::string& verdict = {});
    void add_refusal(const Settings& row, const std::string& message);
    [[nodiscard]] std::string text(TableStyle style) const;

  private:
    std::vector<std::string> label_cells(const Settings& row) const;
    std::vector<Key> swept_;
    bool checks_;
    std::vector<std::vector<std::string>> rows_;
    std::vector<std::string> notes_;
};

}  // namespace bioprint
