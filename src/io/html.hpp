#pragma once

#include <string>
#include <string_view>
#include <vector>

/// Pieces of a page.
namespace bioprint {

/// `text` as content or attribute of HTML: it can be read and cannot be markup. Control characters and bytes
/// that are no UTF-8 become U+FFFD.
std::string html_text(std::string_view text);

/// A table whose cells are texts; the first column names the row.
/// @param head  may be empty
std::string html_table(const std::vector<std::string>& head,
                       const std::vector<std::vector<std::string>>& rows, std::string_view kind = {});

}  // namespace bioprint
