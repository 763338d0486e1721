#pragma once

#include <string>

namespace limitgauge::e2e {

struct ShellOutcome {
  int exit_code = -1;
  std::string out;  ///< errors with it
};

/// Runs a script of bash.
ShellOutcome bash(const std::string& script);
/// Whether a program of this name is in PATH.
bool is_installed(const std::string& program);

}  // namespace limitgauge::e2e
