#pragma once

#include <sys/types.h>

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "tests/e2e/program.h"

namespace limitgauge::e2e {

/// The built program while it runs; killed at the end of the test where it still does.
class RunningProgram {
 public:
  /// `in_child` is done in the new process, before it becomes the program.
  RunningProgram(const Scratch& folder, const std::vector<std::string>& arguments,
                 const std::function<void()>& in_child = {});
  ~RunningProgram();
  RunningProgram(const RunningProgram&) = delete;
  RunningProgram& operator=(const RunningProgram&) = delete;

  /// The next line of its standard output; waits for it.
  std::string line();
  pid_t id() const { return child_; }
  /// Waits until it has `file` open, for half a minute at most: whether it has.
  bool opens(const std::filesystem::path& file) const;
  /// Sends the signal and waits: the exit code, or minus the signal that ended it.
  int end(int signal);

 private:
  pid_t child_ = -1;
  int out_ = -1;
};

/// Sends `request` as it stands to 127.0.0.1:`port` and gives all that comes back.
std::string answer_of(int port, const std::string& request);

}  // namespace limitgauge::e2e
