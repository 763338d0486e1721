#pragma once

#include <cstdint>
#include <iosfwd>
#include <optional>
#include <string>
#include <vector>

#include "engine/model/vec3.h"
#include "verifier/deviation.h"

/// Results as they are read back from result.json: the one way in which compare, history and study
/// know a run.
namespace limitgauge::reports::record {

/// A place that a stage's findings name.
struct Place {
  model::Vec3 at_mm;
  double depth_mm = 0, area_mm2 = 0;
  int patch = 0;
  double u = 0, v = 0;
  std::optional<std::uint32_t> line;  ///< of the program
  std::string line_text;              ///< empty where the result does not have it
};

/// Collisions, travel and the like: figures of the process that any count of is one too many.
struct ProcessCount {
  std::string kind;  ///< "rapid_collision", as result.json names it
  std::size_t count = 0;
};

/// What was measured of a stage that was run; units as in the names of result.json.
struct StageMeasures {
  double machining_time_s = 0, cut_length_mm = 0, rapid_length_mm = 0, removed_volume_mm3 = 0;
  std::size_t moves = 0;
  verifier::Interval gouge_mm, uncut_mm;  ///< certified
  double resolution_mm = 0;               ///< widest certified interval that was asked for
  bool reached_resolution = true;
  double coverage = 0, mean_mm = 0, rms_mm = 0, p01_mm = 0, p50_mm = 0, p99_mm = 0;
  double voxel_mm = 0, voxel_gouge_mm = 0, voxel_uncut_mm = 0;
  double unreachable_area_mm2 = 0, unavoidable_uncut_mm = 0;
  bool findings_complete = true;
  std::vector<Place> gouges, uncuts;
  std::vector<ProcessCount> process;
  double seconds = 0;  ///< of the whole stage, on whatever machine it was
  std::size_t peak_memory_bytes = 0;
};

struct StageRecord {
  std::string name, tool;
  std::string strategy, program;  ///< one of them
  double allowance_mm = 0, step_mm = 0, tolerance_mm = 0;
  verifier::GateLimits limits;
  verifier::Verdict verdict = verifier::Verdict::not_run;
  std::vector<std::string> reasons;
  std::optional<StageMeasures> measures;  ///< empty for a stage that was not run
};

struct InputRecord {
  std::string role, file, sha256;
};

struct RunRecord {
  std::string job, version, created;
  unsigned threads = 1;
  verifier::Verdict verdict = verifier::Verdict::not_run;
  std::vector<InputRecord> inputs;
  std::vector<StageRecord> stages;
};

/// Reads result.json, schema limitgauge.result/1; `shown` names it in errors. Throws
/// model::InputError with line and column for text that is no JSON, and naming the key for one that
/// is missing, of another type, not finite, or out of its range.
RunRecord read_result_json(std::istream& in, const std::string& shown);

}  // namespace limitgauge::reports::record
