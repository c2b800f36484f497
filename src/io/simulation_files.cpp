#include "io/simulation_files.hpp"

#include "io/csv.hpp"
#include "io/row_answer.hpp"
#include "io/whole_file.hpp"

namespace bioprint {

SimulationFiles::SimulationFiles(RunDirectory& directory, double interval)
    : directory_(directory), interval_(interval) {
    if (auto parts = directory.checkpoint()) {
        state_.parts = std::move(*parts);
        resumes_ = true;
    }
}

void SimulationFiles::attach(SimulationOptions& options) {
    options.checkpoint = [this](const SimulationState& state) { directory_.keep(state.parts); };
    options.checkpoint_interval = interval_;
    if (resumes_) options.resume = &state_;
}

void SimulationFiles::write_series(const SimulationSeries& series) const {
    CsvWriter writer(fresh_dialect());
    for (const std::string& name : series.columns) writer.add_text(name);
    writer.end_row();
    for (const std::vector<double>& row : series.rows) {
        for (const double value : row) writer.add_number(value);
        writer.end_row();
    }
    write("series.csv", writer.text());
}

void SimulationFiles::write_answer(const std::string& json) const {
    write("answer.json", json);
}

void SimulationFiles::write(const char* name, const std::string& text) const {
    WholeFile file(directory_.file(name));
    file.write(text);
    file.commit();
}

}  // namespace bioprint
