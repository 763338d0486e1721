#include "tests/defects/orientations/lying_bench.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "model/base/clock.h"
#include "tests/defects/orientations/lying_judge.h"

namespace limitgauge::tests::defects {
namespace {

using model::Vec3;

/// What the gate leaves over the twin's own figures, besides the width asked for: the oracle
/// samples, so its figures are lower bounds, and the reach of a rim has a tolerance.
constexpr double kMargin_mm = 0.004;
/// How often a kind is tried, each time larger.
constexpr int kMostTries = 8;
constexpr double kGrowth = 1.6;

/// Sizes of the first try, spread over the logarithm, and the largest: degrees or mm.
struct Sizes {
  double from, to, largest;
};
Sizes sizes_of(LyingKind kind) {
  if (is_local(kind)) return {0.012, 0.6, 1.2};
  return kind == LyingKind::wrong_angle ? Sizes{0.05, 2, 2} : Sizes{0.05, 0.4, 0.6};
}
bool goes_by_size(LyingKind kind) {
  return kind != LyingKind::missing_pass && kind != LyingKind::wrong_sign &&
         kind != LyingKind::lost_word;
}

Kind planted_as(LyingKind kind) {
  return kind == LyingKind::sunk_pass      ? Kind::sunk_pass
         : kind == LyingKind::missing_pass ? Kind::missing_pass
                                           : Kind::rapid_through;
}

class LyingBench {
 public:
  LyingBench(const LyingPlan& plan, const std::string& keep)
      : plan_(plan), keep_(keep), ground_(plan), random_(plan.seed) {}

  std::vector<LyingResult> run() {
    lay_twin();
    out_.push_back(timed([&](LyingResult& r) { judge_twin(r); }));
    for (const LyingKind kind : plan_.kinds)
      out_.push_back(timed([&](LyingResult& r) { judge_harmed(kind, r); }));
    return std::move(out_);
  }

 private:
  void lay_twin() {
    twin_.lying = random_lying(plan_.holding, random_);
    const RasterRequest request{plan_.cutter, plan_.allowance_mm, plan_.step_mm, plan_.across};
    twin_.program =
        program_of(gouge_free_rows(ground_.part.samples, request), ground_.safe_z_mm(), false);
    twin_.posted = twin_.lying.posted(twin_.program);
    truth_.emplace(ground_.oracle(twin_, twin_.posted.stretches.size()));
    gate_ = {truth_->surely_gouged_mm({}) + kMargin_mm + kLyingResolution_mm,
             truth_->surely_uncut_mm({}) + kMargin_mm + kLyingResolution_mm};
  }

  template <class Judge>
  LyingResult timed(Judge&& judge) const {
    const model::Stopwatch watch;
    LyingResult result;
    result.label = plan_.surface_name + ", " + plan_.cutter.id + ", " + twin_.lying.label();
    result.holding = plan_.holding, result.seed = plan_.seed;
    try {
      judge(result);
    } catch (const std::exception& error) {
      result.broken = error.what();
    }
    result.seconds = watch.seconds();
    return result;
  }

  std::vector<Vec3> block_of(const model::Pose& file) const {
    std::vector<Vec3> corners;
    for (int corner = 0; corner < 8; ++corner) {
      Vec3 p = ground_.stock.corner_mm;
      for (int axis = 0; axis < 3; ++axis)
        if ((corner >> axis & 1) != 0) p[axis] += ground_.stock.size_mm[axis];
      corners.push_back(file.point(p));
    }
    return corners;
  }

  JobText job_of(const LyingCase& c) const {
    JobText job;
    job.cage = model::turned(plan_.cage, c.lying.file), job.block = block_of(c.lying.file);
    job.cutter = plan_.cutter, job.setup = c.lying.setup;
    if (c.lying.holding != Holding::still)
      job.machine = c.lying.machine, job.control = c.lying.posting.control;
    job.program = c.posted.text;
    job.gouge_mm = gate_.gouge_mm, job.uncut_mm = gate_.uncut_mm;
    job.allowance_mm = plan_.allowance_mm, job.resolution_mm = kLyingResolution_mm;
    return job;
  }

  JobSaid ask(const LyingCase& c, const std::string& what, LyingResult& result) const {
    const std::string folder =
        keep_.empty() ? "" : keep_ + "/" + std::to_string(plan_.seed) + "-" + what;
    JobSaid said = run_job(job_of(c), folder);
    result.verdict = said.verdict, result.process.clear();
    if (!said.stage) result.broken = "nothing was measured: " + said.errors;
    if (said.stage)
      for (const std::string& found : said.stage->process) result.process += found + "; ";
    return said;
  }

  void judge_twin(LyingResult& result) {
    JobSaid said = ask(twin_, "twin", result);
    for (const bool again : {false, true}) {
      if (!said.stage || said.verdict == "pass" || !raise_gate(*said.stage, again)) break;
      result.gate_raised = true;
      said = ask(twin_, again ? "twin-third" : "twin-again", result);
    }
    if (said.stage) judge(twin_, *said.stage, result);
  }

  /// Where contact within the stated tolerance counts as reach, more may be uncut than what the
  /// oracle is sure of. The gate of such a plan is set above what the oracle holds possible at the
  /// places named, nothing else being wrong; where that grows from place to place (a wall that the
  /// tool can just touch and the rows do not go to) or stays undecided, above the certified figure,
  /// as the gates of three axes are.
  bool raise_gate(const StageSaid& stage, bool again) {
    double most = 0;
    for (const NamedPlace& n : stage.uncuts)
      most = std::max(most, truth_->possibly_uncut_mm(n.place));
    // Of what is certified to be there the oracle must hold as much possible.
    const bool confirmed = most >= stage.uncut.low || stage.uncut.low <= gate_.uncut_mm;
    if (!stage.process.empty() || !confirmed || stage.gouge.high > gate_.gouge_mm) return false;
    const double above = again ? std::max(most, stage.uncut.high) : most;
    if (above <= gate_.uncut_mm && !again) return false;
    gate_.uncut_mm = above + kMargin_mm + kLyingResolution_mm;
    return true;
  }

  void judge_harmed(LyingKind kind, LyingResult& result) {
    result.harmed = true;
    const LyingCase harmed = plant_due(kind, result);
    const std::string what = std::to_string(out_.size()) + "-" + name(result.kind);
    const JobSaid said = ask(harmed, what, result);
    if (said.stage) judge(harmed, *said.stage, result);
  }

  void judge(const LyingCase& c, const StageSaid& stage, LyingResult& result) const {
    LyingJudge(ground_, twin_, *truth_, gate_).judge(c, stage, result);
  }

  /// Larger and larger until the oracle is sure that there is something to be found; another kind
  /// where this one does the part no harm, such as a place that is wrong along an axis.
  LyingCase plant_due(LyingKind kind, LyingResult& result) {
    if (kind == LyingKind::lost_word && twin_.lying.posting.places == Places::plane)
      kind = LyingKind::wrong_angle;
    for (int attempt = 0;; ++attempt) {
      if (attempt == kMostTries) kind = LyingKind::sunk_pass;
      result.kind = kind;
      LyingCase harmed = plant_one(kind, attempt % kMostTries, result.size);
      if (is_due(harmed) || attempt > 2 * kMostTries) return harmed;
    }
  }
  bool is_due(const LyingCase& harmed) const {
    const TurnedOracle truth = ground_.oracle(harmed, harmed.posted.stretches.size());
    return truth.surely_gouged_mm({}) > gate_.gouge_mm + kLyingResolution_mm ||
           truth.surely_uncut_mm({}) > gate_.uncut_mm + kLyingResolution_mm;
  }

  LyingCase plant_one(LyingKind kind, int attempt, double& size) {
    const Sizes sizes = sizes_of(kind);
    const double first = sizes.from * std::pow(sizes.to / sizes.from, between(random_, 0, 1));
    const double wanted = std::min(first * std::pow(kGrowth, attempt), sizes.largest);
    LyingCase out = twin_;
    if (is_local(kind))
      out.program = mishap(kind, wanted);
    else
      harm(out.lying, kind, wanted, random_);
    size = goes_by_size(kind) ? wanted : 0;
    out.posted = out.lying.posted(out.program);
    return out;
  }

  NcText mishap(LyingKind kind, double size_mm) {
    const Sound sound{ground_.part.samples, twin_.program, plan_.cutter,       plan_.allowance_mm,
                      plan_.step_mm,        plan_.across,  ground_.safe_z_mm()};
    return plant(sound, {planted_as(kind), size_mm, static_cast<unsigned>(random_())}).program;
  }

  const LyingPlan& plan_;
  std::string keep_;
  LyingGround ground_;
  std::mt19937 random_;
  LyingCase twin_;
  std::optional<TurnedOracle> truth_;  ///< of the twin
  LyingGate gate_;
  std::vector<LyingResult> out_;
};

}  // namespace

std::vector<LyingResult> run_lying(const LyingPlan& plan, const std::string& keep) {
  return LyingBench(plan, keep).run();
}

}  // namespace limitgauge::tests::defects
