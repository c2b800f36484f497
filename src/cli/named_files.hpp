#pragma once

#include <initializer_list>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "io/settings.hpp"

/// The files a call names, and what must not happen to them.
namespace bioprint {

struct NamedFile {
    std::string option;  ///< as typed: "--plot"
    std::optional<std::string> file;
    bool written = true;  ///< false: only read
};

/// A file that would be written by two options, or over one that is read, is a problem of the call.
void refuse_shared_files(std::span<const NamedFile> files, Problems& problems);

/// A file of another kind would be replaced by what was not meant for it: its name must end as one of `endings`.
/// Standard output and devices have no kind.
/// @param kind  "a preset"
void require_ending(const NamedFile& file, std::string_view kind,
                    std::initializer_list<std::string_view> endings, Problems& problems);

}  // namespace bioprint
