#pragma once

#include <filesystem>

#include "reports/compare/comparison.h"

/// How the records of two runs become a comparison: the whole, and part by part.
namespace limitgauge::reports::compare {

/// Throws model::InputError where the runs have nothing in common: other jobs, and no stage of one
/// name; and for results of two schemas, whose gouge and uncut mean different things.
Comparison compare_runs(const record::RunRecord& base, const record::RunRecord& now,
                        const Options& options);

/// Names the two runs by their labels, or by the shortest ends of the paths to their results that
/// tell them apart: "base" and "new" say nothing of where a result is from.
void name_runs(Comparison& comparison, const record::RunRecord& base,
               const std::filesystem::path& base_file, const record::RunRecord& now,
               const std::filesystem::path& now_file);

/// Every metric of a stage that both runs measured.
std::vector<FigureChange> compare_figures(const record::StageMeasures& base,
                                          const record::StageMeasures& now, const Options& options);

/// Metrics of a stage that one of the runs alone has.
std::vector<Remark> tell_lone_figures(const record::StageMeasures& base,
                                      const record::StageMeasures& now);

/// What stages are compared with, of the runs as a whole.
struct RunContext {
  double reach_mm = 0;
  bool same_tolerances = true;
  const Options& options;
};
/// Findings of gouges, of leftovers and of the process into `out`: matched by place within
/// `reach_mm`, or within half the diagonal of the larger one's box. Of both runs over the same
/// tolerances also the places that reach the figures over them.
void compare_findings(const record::StageRecord& base, const record::StageRecord& now,
                      const RunContext& run, StageComparison& out);

/// What explains a change and is not judged: `what` was `base`, is `now`; nothing where both are
/// alike.
void name_change(std::vector<Remark>& out, const std::string& id, const std::string& what,
                 const std::string& base, const std::string& now);

/// "fail" after "pass": what became worse comes later in the order pass, indeterminate, fail, not
/// run. Nothing where both are alike.
std::optional<Remark> compare_verdicts(const std::string& what, verifier::Verdict base,
                                       verifier::Verdict now);
/// Limits that were loosened or taken away count as worse: a gate that gives way hides what the
/// figures then do.
std::vector<Remark> compare_gates(const verifier::GateLimits& base, const verifier::GateLimits& now,
                                  const Options& options);
/// Limits of the process, the same for all stages, that were loosened or taken away: as of gates; a
/// fixture is one. Nothing of what one of the results does not say.
std::vector<Remark> compare_process_limits(const std::optional<record::ProcessLimits>& base,
                                           const std::optional<record::ProcessLimits>& now,
                                           const Options& options);
/// How steeply cutters, by their texts, may go down: as of gates. A text that cannot be read, as
/// one of another version, states no limit.
std::vector<Remark> compare_descents(const std::string& base, const std::string& now,
                                     const Options& options);
/// Tolerances taken away or narrowed count as worse, as limits that are loosened: what the gate
/// judges gives way. Nothing where both runs have the same, or none.
std::optional<Remark> compare_tolerances(const std::optional<model::Tolerances>& base,
                                         const std::optional<model::Tolerances>& now,
                                         const Options& options);
/// Figures over tolerances of two boxes, and margins of two limits, are answers to two questions:
/// they are shown and not judged.
void leave_other_questions(const record::StageRecord& base, const record::StageRecord& now,
                           bool same_tolerances, std::vector<FigureChange>& figures);
/// Tool, cutter, strategy, allowance and the like: named, for they explain. How steeply a cutter
/// may go down is a limit.
std::vector<Remark> compare_settings(const record::StageRecord& base,
                                     const record::StageRecord& now, const Options& options);
/// Resolutions asked for, reached or not, and findings that are not all listed.
std::vector<Remark> compare_certificates(const record::DeviationMeasures& base,
                                         const record::DeviationMeasures& now);
/// What no cutter used so far can reach, in both runs; nothing where all is in reach.
std::optional<Remark> tell_reach(const record::DeviationMeasures& base,
                                 const record::DeviationMeasures& now);
/// Moves with a fault, by kind.
std::vector<Remark> compare_process_counts(const record::StageMeasures& base,
                                           const record::StageMeasures& now,
                                           const Options& options);
/// Job, version, inputs by their checksums, and the order of the stages.
std::vector<Remark> compare_heads(const record::RunRecord& base, const record::RunRecord& now);

}  // namespace limitgauge::reports::compare
