#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "io/checkpoint_file.hpp"

/// The directory of a long run (`--out`, `--resume`): the question it was asked, how far it is, and what it found.
///
///   question.json    the options as typed, and the files they name: enough to go on by itself
///   checkpoint.cbor  io/checkpoint_file.hpp
///   lock             held while a process works here
///
/// Every file appears whole or not at all.
namespace bioprint {

struct TypedOption {
    std::string name;  ///< "--radius"
    std::string text;
};

/// What a run was asked, in the order typed.
using TypedQuestion = std::vector<TypedOption>;

class RunDirectory {
  public:
    /// A new run in a directory that is new or empty. Files the question names are copied (`--ink`) or remembered with
    /// their checksum (`--batch`).
    /// @throws UsageError  it holds a run already, or other files
    /// @throws DataError   it cannot be made, or another process is at work there
    static RunDirectory begin(const std::string& path, const TypedQuestion& question);
    /// A run that is there, to go on.
    /// @throws UsageError, DataError  no run is there, another process is at work, or an input has changed
    static RunDirectory take_up(const std::string& path);

    RunDirectory(RunDirectory&& other) noexcept;
    RunDirectory& operator=(RunDirectory&&) = delete;
    RunDirectory(const RunDirectory&) = delete;
    RunDirectory& operator=(const RunDirectory&) = delete;
    ~RunDirectory();

    [[nodiscard]] const std::string& path() const { return path_; }
    [[nodiscard]] std::string file(std::string_view name) const { return path_ + "/" + std::string(name); }

    /// The last checkpoint; none where the run was killed before its first.
    [[nodiscard]] std::optional<CheckpointParts> checkpoint() const;
    void keep(const CheckpointParts& parts);
    /// A refused question leaves nothing behind: undoes begin() unless something was kept.
    void abandon();

  private:
    RunDirectory(std::string path, bool made);
    void lock();

    std::string path_;
    bool made_;        ///< by this run
    bool new_ = true;  ///< nothing was kept yet
    int lock_ = -1;
};

/// The question a directory holds, as typed.
/// @throws UsageError  no run is there
TypedQuestion question_in(const std::string& directory);

/// The same for going on from anywhere: files are named by their copies or by their full path.
/// @throws DataError  a file the run reads has changed since
TypedQuestion lasting_question_in(const std::string& directory);

/// `path` as a word of a shell command.
std::string shell_word(std::string_view path);

}  // namespace bioprint
