#pragma once

#include <charconv>
#include <fstream>
#include <map>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

/// Reads the reference tables of the tests: a header line, then numbers.
namespace bioprint::test {

using Row = std::map<std::string, double>;

inline std::vector<std::string> split(const std::string& line) {
    std::vector<std::string> fields;
    std::stringstream stream(line);
    for (std::string field; std::getline(stream, field, ',');) fields.push_back(field);
    return fields;
}

inline std::vector<Row> read_reference(const std::string& name) {
    const std::string path = std::string(BIOPRINT_SOURCE_DIR) + "/tests/reference/" + name;
    std::ifstream file(path);
    std::string line;
    if (!std::getline(file, line)) throw std::runtime_error("cannot read " + path);
    const auto names = split(line);
    std::vector<Row> rows;
    while (std::getline(file, line)) {
        const auto fields = split(line);
        Row row;
        for (std::size_t i = 0; i < names.size(); ++i) {
            double value = 0.0;
            const auto& text = fields.at(i);
            if (std::from_chars(text.data(), text.data() + text.size(), value).ec != std::errc{}) {
                throw std::runtime_error("not a number in " + path + ": " + text);
            }
            row[names[i]] = value;
        }
        rows.push_back(row);
    }
    return rows;
}

}  // namespace bioprint::test
