#pragma once

#include <map>
#include <string>
#include <vector>

/// Reference tables of the tests: CSV with a header line, then numbers.
namespace bioprint::test {

using ReferenceRow = std::map<std::string, double>;

/// @param file  below tests/reference
std::vector<ReferenceRow> read_reference(const std::string& file);

/// The same by columns.
using ReferenceColumns = std::map<std::string, std::vector<double>>;
ReferenceColumns read_reference_columns(const std::string& file);

}  // namespace bioprint::test
