#pragma once

#include <stdexcept>
#include <string>

namespace limitgauge::model {

/// Where in a text something is; line and column count from 1, 0 means "the file as a whole".
struct SourcePlace {
  std::string file;
  int line = 0;
  int column = 0;
};

/// Input that cannot be used: unreadable, malformed or meaningless. Exit code 3.
/// what() is `file:line:column: error: what is wrong; what was expected`, on one line and without
/// control characters: much of it was written by others, and all of it goes to a terminal.
class InputError : public std::runtime_error {
 public:
  InputError(SourcePlace place, const std::string& wrong, const std::string& expected = {});
  const SourcePlace& place() const { return place_; }
  /// The same error with `more` behind what was expected.
  InputError with(const std::string& more) const;

 private:
  SourcePlace place_;
  std::string wrong_, expected_;
};

/// The machine cannot carry the work: memory, disk. Exit code 4.
/// what() holds no control characters but line feeds.
class ResourceError : public std::runtime_error {
 public:
  explicit ResourceError(const std::string& what);
};

/// The user asked to stop; raised from RunControl::check(). Exit code 4.
class Interrupted : public std::runtime_error {
 public:
  Interrupted() : std::runtime_error("interrupted") {}
};

}  // namespace limitgauge::model
