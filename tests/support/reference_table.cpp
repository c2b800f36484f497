#include "support/reference_table.hpp"

#include <cstdlib>
#include <fstream>
#include <limits>
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

ReferenceTable read_reference(const std::string& file) {
    const std::string path = std::string(BIOPRINT_SOURCE_DIR) + "/tests/reference/" + file;
    std::ifstream in(path);
    std::string line;
    if (!std::getline(in, line)) throw std::runtime_error("cannot read " + path);
    const std::vector<std::string> header = split(line);
    ReferenceTable table;
    while (std::getline(in, line)) {
        const std::vector<std::string> fields = split(line);
        for (std::size_t i = 0; i < header.size(); ++i) {
            char* end = nullptr;
            const double value = i < fields.size() ? std::strtod(fields[i].c_str(), &end)
                                                   : std::numeric_limits<double>::quiet_NaN();
            table[header[i]].push_back(value);
        }
    }
    return table;
}

}  // namespace bioprint::test
