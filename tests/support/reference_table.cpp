#include "support/reference_table.hpp"

#include <charconv>
#include <fstream>
#include <sstream>
#include <stdexcept>

namespace bioprint::test {
namespace {

std::vector<std::string> split(const std::string& line) {
    std::vector<std::string> fields;
    std::istringstream in(line.substr(0, line.find('\r')));
    for (std::string field; std::getline(in, field, ',');) fields.push_back(field);
    return fields;
}

}  // namespace

std::vector<ReferenceRow> read_reference(const std::string& file) {
    const std::string path = std::string(BIOPRINT_SOURCE_DIR) + "/tests/reference/" + file;
    std::ifstream in(path);
    std::string line;
    if (!std::getline(in, line)) throw std::runtime_error("cannot read " + path);
    const std::vector<std::string> names = split(line);
    std::vector<ReferenceRow> rows;
    while (std::getline(in, line)) {
        const std::vector<std::string> fields = split(line);
        ReferenceRow row;
        for (std::size_t i = 0; i < names.size(); ++i) {
            double value = 0.0;
            const std::string& text = fields.at(i);
            if (std::from_chars(text.data(), text.data() + text.size(), value).ec != std::errc{}) {
                throw std::runtime_error("not a number in " + path + ": " + text);
            }
            row[names[i]] = value;
        }
        rows.push_back(std::move(row));
    }
    return rows;
}

ReferenceColumns read_reference_columns(const std::string& file) {
    ReferenceColumns columns;
    for (const ReferenceRow& row : read_reference(file)) {
        for (const auto& [name, value] : row) columns[name].push_back(value);
    }
    return columns;
}

}  // namespace bioprint::test
