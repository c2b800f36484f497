#pragma once

#include <stdexcept>
#include <string>
#include <utility>

/// The errors a call can end in: one class for each thing a caller can do about it, one exit status each.
namespace bioprint {

/// Base of every error this library throws on purpose.
class Error : public std::runtime_error {
  public:
    using std::runtime_error::runtime_error;
};

/// The call is wrong: an option, a value, a unit or the format of a file. Exit status 2.
class UsageError : public Error {
  public:
    explicit UsageError(const std::string& message, std::string option = {})
        : Error(message), option_(std::move(option)) {}
    /// The option or column at fault, as the caller wrote it; empty when there is none.
    [[nodiscard]] const std::string& option() const { return option_; }

  private:
    std::string option_;
};

/// No steady flow exists for this ink and load. Exit status 3.
class NoSteadyFlow : public Error {
  public:
    using Error::Error;
};

/// A file could not be read or written. Exit status 4.
class DataError : public Error {
  public:
    using Error::Error;
};

/// An iteration or a simulation ended before it reached its goal. Exit status 5.
class NotConverged : public Error {
  public:
    using Error::Error;
};

}  // namespace bioprint
