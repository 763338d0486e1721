#pragma once

#include <filesystem>
#include <string>
#include <variant>
#include <vector>

#include "app/job.h"

namespace limitgauge::app {

/// Options that every command takes.
struct CommonOptions {
  unsigned threads = 0;  ///< never zero once parsed
  bool quiet = false, verbose = false, no_pictures = false, force = false;
  std::vector<std::string> overrides;  ///< `key=value`
};

struct RunCommand {
  std::filesystem::path job;
  std::filesystem::path output;  ///< empty: limitgauge-out/NAME
};
struct PlanCommand {
  std::filesystem::path job;
  std::filesystem::path output;  ///< empty: limitgauge-out/NAME-plan
};
struct VerifyCommand {
  std::filesystem::path cage, program;
  std::string stock, tool;
  double allowance_mm = 0;
  double near_miss_mm = 0;  ///< 0: not looked for
  std::vector<std::filesystem::path> fixtures;
  verifier::GateLimits limits;
  std::filesystem::path output;  ///< empty: limitgauge-out/STEM of the program
};
struct InspectCommand {
  std::filesystem::path file;
  int samples = 0;  ///< a face and direction; 0: no table
  std::filesystem::path csv;
  bool moves = false;
};
/// Help or the version: print and leave.
struct PrintCommand {
  std::string text;
};

using Command = std::variant<RunCommand, PlanCommand, VerifyCommand, InspectCommand, PrintCommand>;

struct CommandLine {
  Command command;
  CommonOptions common;
};

/// A command line that cannot be obeyed. Exit code 3.
class UsageError : public std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// Throws UsageError.
CommandLine parse_command_line(int argc, const char* const* argv);

}  // namespace limitgauge::app
