#pragma once

#include <atomic>
#include <cstddef>
#include <functional>
#include <iosfwd>

#include "app/cli/command_line.h"

namespace limitgauge::app {

/// Exit codes of the program.
enum class ExitCode { pass = 0, fail = 1, indeterminate = 2, bad_input = 3, resources = 4 };

/// Where a command prints, and how it is stopped.
struct Console {
  std::ostream& out;
  std::ostream& errors;
  bool colour = false;    ///< of what goes to `out`
  bool progress = false;  ///< a line that is drawn again and again on `errors`
  std::size_t out_columns = 100;
  std::function<std::size_t()> errors_columns = [] { return std::size_t{80}; };
  const std::atomic<bool>* stop = nullptr;
};

ExitCode execute(const RunCommand& command, const CommonOptions& common, const Console& console);
ExitCode execute(const PlanCommand& command, const CommonOptions& common, const Console& console);
ExitCode execute(const VerifyCommand& command, const CommonOptions& common, const Console& console);
ExitCode execute(const CutCommand& command, const CommonOptions& common, const Console& console);
ExitCode execute(const InspectCommand& command, const CommonOptions& common,
                 const Console& console);
ExitCode execute(const CompareCommand& command, const CommonOptions& common,
                 const Console& console);
ExitCode execute(const ProbeCommand& command, const CommonOptions& common, const Console& console);
ExitCode execute(const StudyCommand& command, const CommonOptions& common, const Console& console);
ExitCode execute(const HistoryCommand& command, const CommonOptions& common,
                 const Console& console);
ExitCode execute(const ViewCommand& command, const CommonOptions& common, const Console& console);

/// Says what the exception being handled means to the user and gives its exit code; to be called
/// from within a catch block.
ExitCode report_exception(const Console& console);

/// Parses the command line, executes it and turns every error into a message and an exit code.
ExitCode run_command_line(int argc, const char* const* argv, const Console& console);

}  // namespace limitgauge::app
