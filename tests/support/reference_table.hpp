#pragma once

#include <map>
#include <string>
#include <vector>

/// Columns of a plain CSV of numbers from tests/reference, by header name.
namespace bioprint::test {

using ReferenceTable = std::map<std::string, std::vector<double>>;

ReferenceTable read_reference(const std::string& file);

}  // namespace bioprint::test
