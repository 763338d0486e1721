#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "app/job/machine_options.h"
#include "verifier/gate/deviation.h"

/// The commands with what is asked of each, as values.
namespace limitgauge::app {

/// Options that every command takes.
struct CommonOptions {
  unsigned threads = 0;  ///< never zero once parsed
  bool quiet = false, verbose = false, no_pictures = false, force = false;
  bool json = false;                   ///< the result's JSON alone goes to standard output
  std::vector<std::string> overrides;  ///< `key=value`
};

/// How a run enters a history.
struct HistoryOptions {
  std::filesystem::path file;  ///< empty: into none
  std::string label, commit;
};
/// Where work is done that others than this process may do.
struct EngineOptions {
  std::string engine = "local";
  unsigned jobs = 0;  ///< at a time; 0: as many as the engine takes by itself
  unsigned retries = 2;
  std::filesystem::path cache;  ///< empty: the user's own
  std::uint64_t cache_limit_bytes = std::uint64_t{4} << 30;
  std::vector<std::string> slurm_options;
  double slurm_patience_min = 8;  ///< with a task that does not come back
  /// Of a process that works for another one: where its tasks come from, `-` for standard input.
  /// Empty: this is no such process.
  std::string worker;
};
struct RunCommand {
  std::filesystem::path job;
  std::filesystem::path output;  ///< empty: limitgauge-out/NAME
  HistoryOptions history;
  EngineOptions engine;
};
struct PlanCommand {
  std::filesystem::path job;
  std::filesystem::path output;  ///< empty: limitgauge-out/NAME-plan
};
struct CutCommand {
  std::filesystem::path program;
  std::string stock;
  std::vector<std::string> tools;       ///< `SPEC`, or `N=SPEC` for each of several
  std::vector<std::string> tolerances;  ///< `zero=X,Y,Z`, `N:radius=R,length=L`, ...
  MachineOptions machine;
  std::string program_offset;  ///< `X,Y,Z` of the programs' zero in the stock's frame
  double program_rotation_deg = 0;
  double near_miss_mm = 0;         ///< 0: not looked for
  std::optional<double> voxel_mm;  ///< empty: chosen
  std::vector<std::filesystem::path> fixtures;
  std::filesystem::path output;  ///< empty: limitgauge-out/STEM of the program
  HistoryOptions history;
};
/// The same against a design.
struct VerifyCommand : CutCommand {
  std::filesystem::path cage, target;  ///< one of the two; the other is empty
  double allowance_mm = 0;
  verifier::GateLimits limits;
};
struct InspectCommand {
  std::filesystem::path file;
  int samples = 0;  ///< a face and direction; 0: no table
  std::filesystem::path csv;
  bool moves = false;
  MachineOptions machine;
};
struct CompareCommand {
  std::filesystem::path base, now;  ///< result.json, or the folder that has one
  std::filesystem::path output;     ///< empty: no files
  /// Machining time may grow by so much; empty: it is not judged.
  std::optional<double> time_limit_percent;
  std::vector<std::string> metrics, ignored;  ///< ids of what is judged
};
struct ProbeCommand {
  std::filesystem::path result;  ///< result.json, or the folder that has one
  std::filesystem::path points;
  std::filesystem::path output;       ///< empty: limitgauge-out/STEM-probe of the points' file
  std::string stage;                  ///< empty: the last that ran
  std::filesystem::path stock;        ///< raw stock's file; empty where the result says all of it
  std::optional<double> residual_mm;  ///< empty: measured, not gated
};
struct StudyCommand : EngineOptions {
  std::filesystem::path study;            ///< of a worker the job
  std::filesystem::path output;           ///< empty: limitgauge-out/NAME
  std::uint64_t worker_keeps_bytes = 0;   ///< of stages in memory
  std::uint64_t worker_memory_bytes = 0;  ///< that a case may take; 0: model::memory_limit_bytes()
};
struct HistoryCommand {
  std::filesystem::path file;
  std::filesystem::path output;              ///< empty: limitgauge-out/STEM of the file
  std::string job;                           ///< empty: all of them
  std::vector<std::string> stages, metrics;  ///< empty: all stages, the usual figures
  int last = 0;                              ///< runs at most, the newest; never zero once parsed
  std::string since;                         ///< ISO 8601, UTC, or its beginning; empty: ever
};
struct ViewCommand {
  std::filesystem::path folder;  ///< of a finished run, or its report.html
  int port = 0;                  ///< 0: a free one
  bool no_browser = false;
};
/// Help, the version, the man page or a shell's completions: print and leave.
struct PrintCommand {
  std::string text;
};

using Command =
    std::variant<RunCommand, PlanCommand, VerifyCommand, CutCommand, InspectCommand, CompareCommand,
                 ProbeCommand, StudyCommand, HistoryCommand, ViewCommand, PrintCommand>;

}  // namespace limitgauge::app
