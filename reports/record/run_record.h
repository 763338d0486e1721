#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "model/geometry/vec3.h"
#include "model/part/tolerances.h"
#include "reports/record/process_limits.h"
#include "verifier/gate/deviation.h"

/// Results as they are read back from result.json: the one way in which compare, history and study
/// know a run.
namespace limitgauge::reports::record {

/// A place that a stage's findings name.
struct Place {
  model::Vec3 at_mm;
  double depth_mm = 0, area_mm2 = 0;
  int patch = 0;
  double u = 0, v = 0;
  std::string stage;                  ///< whose program the line is of; empty: the stage's own
  std::optional<std::uint32_t> line;  ///< of the program
  std::string line_text;              ///< empty where the result does not have it
  std::string body;                   ///< of a gouge: "cutter", "shank"; or empty
  double extent_mm = 0;               ///< diagonal of the finding's box
};

/// A run of moves with the same fault, by its worst place.
struct ProcessFinding {
  std::string kind;           ///< "rapid_through_stock", as result.json names it
  bool fails = true;          ///< all but near misses
  std::string part, against;  ///< "holder", "stock"; empty where the result does not say
  std::size_t count = 1;      ///< moves
  model::Vec3 at_mm;
  double depth_mm = 0;  ///< of a near miss: what is left of the way
  std::optional<std::uint32_t> line;
  std::string line_text;
};

/// Moves with a fault of one kind: any count is one too many, but for near misses.
struct ProcessCount {
  std::string kind;
  std::size_t count = 0;
};

/// Figures over every value of the tolerances.
struct RobustMeasures {
  verifier::Interval gouge_mm, uncut_mm;  ///< certified
  bool reached_resolution = true;         ///< of both
  /// Where the lower ends are reached; empty for a figure of zero.
  std::optional<Place> gouge, uncut;
  /// By what factor all tolerances may grow together; none where no gate limits either figure, or
  /// where it was not looked for.
  std::optional<verifier::ToleranceMargin> margin;
};

/// What was measured of a stage against the design; units as in the names of result.json.
struct DeviationMeasures {
  verifier::Interval gouge_mm, uncut_mm;  ///< certified
  double resolution_mm = 0;               ///< widest certified interval that was asked for
  bool reached_resolution = true;
  double coverage = 0, mean_mm = 0, rms_mm = 0, p01_mm = 0, p50_mm = 0, p99_mm = 0;
  /// Least and greatest of the deviations sampled, negative for gouges; empty where the result does
  /// not say.
  std::optional<verifier::Interval> sampled_mm;
  double voxel_gouge_mm = 0, voxel_uncut_mm = 0;
  double unreachable_area_mm2 = 0, unavoidable_uncut_mm = 0;
  verifier::StageDeviation::ProvenReach reach;  ///< of schema 2
  double reachable_area_mm2 = 0;                ///< by samples; of schema 2
  /// Certified; both ends are `unavoidable_uncut_mm` where the result does not say.
  verifier::Interval unavoidable_mm;
  verifier::Interval missing_stock_mm;  ///< certified; of schema 2
  bool findings_complete = true;
  /// Depth from which a place is a finding: the gate's limit, or half of `low` without one.
  double gouge_threshold_mm = 0, uncut_threshold_mm = 0;
  std::vector<Place> gouges, uncuts, missing_stock;
  std::optional<RobustMeasures> robust;  ///< of a run with tolerances
};

/// What was found of a stage that was run; units as in the names of result.json.
struct StageMeasures {
  double machining_time_s = 0, cut_length_mm = 0, rapid_length_mm = 0, removed_volume_mm3 = 0;
  std::size_t moves = 0;
  double voxel_mm = 0;
  std::optional<DeviationMeasures> deviation;  ///< empty for a run without a design
  std::vector<ProcessFinding> process_findings;
  std::vector<ProcessCount> process;  ///< a count a kind, by name of the kind
  double seconds = 0;                 ///< of the whole stage, on whatever machine it was
  std::size_t peak_memory_bytes = 0;
};

/// What the gates of gouge and uncut judge: the figure over tolerances, where there is one.
const verifier::Interval& judged_gouge_mm(const DeviationMeasures& measures);
const verifier::Interval& judged_uncut_mm(const DeviationMeasures& measures);
/// The figure that the gate `unreachable` judges: a share of the surface or mm².
verifier::Interval unreachable_figure(const DeviationMeasures& measures, bool is_share);

struct StageRecord {
  std::string name, tool;
  std::string cutter;                  ///< all its figures, as `--tool` takes them; or empty
  std::string strategy, program;       ///< one of them
  std::optional<double> allowance_mm;  ///< empty for a run without a design
  double step_mm = 0, tolerance_mm = 0;
  verifier::GateLimits limits;
  verifier::Verdict verdict = verifier::Verdict::not_run;
  std::vector<std::string> reasons;
  std::optional<StageMeasures> measures;  ///< empty for a stage that was not run
};

struct InputRecord {
  std::string role, file, sha256;
};

/// Of a design as it was measured, its transform done.
struct DesignExtent {
  model::Box3 box_mm;
  double area_mm2 = 0;
};

struct RunRecord {
  /// Of result.json. In 1 gouge and uncut are distances to the nearest removed space or material,
  /// in 2 runs along the normal: figures of the two cannot be held against each other.
  int schema = 2;
  std::string job, version, created;
  std::string label;  ///< or empty
  unsigned threads = 1;
  verifier::Verdict verdict = verifier::Verdict::not_run;
  std::vector<InputRecord> inputs;
  std::vector<std::string> overrides;  ///< of the job's keys, by the command line
  std::optional<std::string> cage;     ///< as the job states it; empty for a run without a design
  std::optional<DesignExtent> design;  ///< likewise
  /// What a result says of the raw stock, of what programs were told, and of setups, on one line of
  /// JSON each; or empty.
  std::string stock, programs, setups;
  /// Of the limit surface's box; of the raw stock's for a run without a design.
  double diagonal_mm = 0;
  std::optional<model::Tolerances> tolerances;  ///< where the run states some
  std::optional<ProcessLimits> process_limits;  ///< where the result says them
  std::vector<StageRecord> stages;
};

}  // namespace limitgauge::reports::record
