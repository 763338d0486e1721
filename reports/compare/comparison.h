#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "model/geometry/vec3.h"
#include "reports/record/metrics.h"
#include "reports/record/run_record.h"

/// Two results of one job held against each other. docs/compare.md has the rules with their
/// reasons.
namespace limitgauge::reports::compare {

enum class Judgement { better, same, worse, not_judged };

struct Options {
  /// Percent that the machining time of a stage may grow by; empty: time is shown and not judged.
  std::optional<double> time_limit_percent;
  /// Ids of what is judged, see `judged_ids`; empty: all but `ignored`.
  std::vector<std::string> only, ignored;
};

/// What can be chosen: the metrics, "gate" and "process". Verdicts and missing stages are always
/// judged.
std::vector<std::string_view> judged_ids();

/// A place that a finding names.
struct FoundPlace {
  model::Vec3 at_mm;
  double depth_mm = 0;
  std::string stage;                  ///< whose program the line is of
  std::optional<std::uint32_t> line;  ///< of the program
  std::string line_text;              ///< or empty
  std::string by;                     ///< the body and what it met: "shank", "holder, clamp"
};

/// One figure of a stage in both runs.
struct FigureChange {
  const record::Metric* metric = nullptr;
  verifier::Interval base, now;  ///< of no width where it is no certified one
  /// What the gates of both runs held it against; empty where they did not.
  std::optional<double> base_limit, now_limit;
  std::optional<double> floor;  ///< a change up to it says nothing; empty: not judged
  Judgement judgement = Judgement::not_judged;
  std::string why;                  ///< the rule that decided, in words
  std::optional<FoundPlace> where;  ///< of a certified figure: the deepest place of the worse run
};

/// Anything else that differs: verdicts, gates, settings, inputs.
struct Remark {
  std::string id;  ///< "verdict", "gate", "process", "stage", "resolution", "input", ...
  Judgement judgement = Judgement::not_judged;
  std::string text;  ///< a sentence without its full stop
};

enum class FindingStatus { fresh, gone, deeper, shallower, moved };

/// A finding that only one run has, or that differs.
struct FindingChange {
  /// "gouge", "uncut", "missing_stock", "robust_gouge", "robust_uncut" (over tolerances), or a kind
  /// of process finding.
  std::string kind;
  FindingStatus status = FindingStatus::fresh;
  Judgement judgement = Judgement::not_judged;
  std::optional<FoundPlace> base, now;  ///< one of them, or both
  double moved_mm = 0;
};

struct StageComparison {
  std::string name;
  std::optional<verifier::Verdict> base, now;  ///< empty in the run that has no such stage
  std::vector<FigureChange> figures;           ///< none where a run did not measure the stage
  std::vector<Remark> remarks;
  std::vector<FindingChange> findings;  ///< worse first, then by depth
  std::size_t same_findings = 0;
};

/// What identifies a run.
struct RunHead {
  std::string job, version, created;
  std::string name;  ///< the run's label, or the folder that tells it from the other; or empty
  verifier::Verdict verdict = verifier::Verdict::not_run;
  double machining_time_s = 0;
};

struct Comparison {
  RunHead base, now;
  Options options;
  std::vector<Remark> remarks;  ///< of the runs as a whole
  std::vector<StageComparison> stages;
  std::size_t worse = 0, better = 0;  ///< figures, remarks and findings with that judgement

  /// Worse where anything is; better where something is and nothing worse.
  Judgement judgement() const;
};

/// Whether `id` is judged with these options.
bool is_judged(const Options& options, std::string_view id);
/// `judgement` where `id` is judged.
Judgement if_judged(const Options& options, std::string_view id, Judgement judgement);

FoundPlace found_place(const record::Place& place);
FoundPlace found_place(const record::ProcessFinding& finding, const std::string& stage);
/// How deep the place of a change is: in the new run where it is there.
double depth_mm(const FindingChange& change);

}  // namespace limitgauge::reports::compare
