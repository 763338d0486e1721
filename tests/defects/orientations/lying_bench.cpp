#include "tests/defects/orientations/lying_bench.h"

#include <algorithm>
#include <array>
#include <optional>
#include <set>

#include "model/base/clock.h"
#include "tests/defects/orientations/job_run.h"
#include "tests/defects/orientations/turned_oracle.h"

namespace limitgauge::tests::defects {
namespace {

using model::Vec3;

constexpr double kSpacing_mm = 0.12;
constexpr double kResolution_mm = 0.002;
/// What the gate leaves over the twin's own figures, besides the width asked for: the oracle
/// samples, so its figures are lower bounds, and the reach of a rim has a tolerance.
constexpr double kMargin_mm = 0.004;
/// Two implementations of the same distances; marches of the oracle are one-sided.
constexpr double kSame_mm = 1e-6;
/// Findings come from a field that is stored in single precision.
constexpr double kSameInField_mm = 2e-6;
/// The bottom of a gouge by one of the moves that end there.
constexpr double kBottom_mm = 1e-5;
constexpr int kMostTries = 8;

model::BoxStock block_about(const model::Box3& part) {
  constexpr double kAside_mm = 1.5, kBelow_mm = 2, kAbove_mm = 0.5;
  const Vec3 low = part.low - Vec3{kAside_mm, kAside_mm, kBelow_mm};
  return {low, part.high + Vec3{kAside_mm, kAside_mm, kAbove_mm} - low};
}

/// A move in the nominal frame, and where it stands in the text.
using Ends = std::array<double, 6>;
Ends ends(const Vec3& a, const Vec3& b) {
  return {a.x, a.y, a.z, b.x, b.y, b.z};
}
double distance_in_plan(const Ends& s, const Vec3& p) {
  const double dx = s[3] - s[0], dy = s[4] - s[1], l2 = dx * dx + dy * dy;
  const double t =
      l2 > 0 ? std::clamp(((p.x - s[0]) * dx + (p.y - s[1]) * dy) / l2, 0.0, 1.0) : 0.0;
  return std::hypot(p.x - s[0] - t * dx, p.y - s[1] - t * dy);
}
std::vector<Ends> ends_of(const NcText& program) {
  std::vector<Ends> out;
  for (std::size_t k = 1; k < program.blocks.size(); ++k)
    out.push_back(ends(program.blocks[k - 1].to, program.blocks[k].to));
  return out;
}
/// Moves that one program makes and the other does not, either way.
std::vector<Ends> changed(const NcText& a, const NcText& b) {
  std::vector<Ends> of_a = ends_of(a), of_b = ends_of(b), out;
  std::sort(of_a.begin(), of_a.end()), std::sort(of_b.begin(), of_b.end());
  std::set_symmetric_difference(of_a.begin(), of_a.end(), of_b.begin(), of_b.end(),
                                std::back_inserter(out));
  return out;
}

std::vector<Place> first_places(const std::vector<NamedPlace>& named) {
  std::vector<Place> out;
  for (std::size_t k = 0; k < std::min<std::size_t>(2, named.size()); ++k)
    out.push_back(named[k].place);
  return out;
}

/// A way to lie with a program, and what is true of it.
struct Case {
  Lying lying;
  NcText program;
  Posted posted;
};

class LyingBench {
 public:
  LyingBench(const LyingPlan& plan, const std::string& keep)
      : plan_(plan),
        keep_(keep),
        part_(plan.cage, kSpacing_mm),
        stock_(block_about(part_.surface.bounding_box())),
        random_(plan.seed) {}

  std::vector<LyingResult> run() {
    twin_.lying = random_lying(plan_.holding, random_);
    const RasterRequest request{plan_.cutter, plan_.allowance_mm, plan_.step_mm, plan_.across};
    twin_.program = program_of(gouge_free_rows(part_.samples, request), safe_z_mm(), false);
    twin_.posted = twin_.lying.posted(twin_.program);
    twin_oracle_.emplace(oracle(twin_, twin_.posted.stretches.size()));
    gouge_gate_ = twin_oracle_->surely_gouged_mm({}) + kMargin_mm + kResolution_mm;
    uncut_gate_ = twin_oracle_->surely_uncut_mm({}) + kMargin_mm + kResolution_mm;
    out_.push_back(timed([&](LyingResult& r) { judge_twin(r); }));
    for (const LyingKind kind : plan_.kinds)
      out_.push_back(timed([&](LyingResult& r) { judge_harmed(kind, r); }));
    return std::move(out_);
  }

 private:
  double safe_z_mm() const { return stock_.corner_mm.z + stock_.size_mm.z + 1; }

  template <class Judge>
  LyingResult timed(Judge&& judge) {
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

  TurnedOracle oracle(const Case& c, std::size_t stretches) const {
    return {part_,
            plan_.cage,
            stock_,
            plan_.cutter,
            std::span(c.posted.stretches).first(stretches),
            plan_.allowance_mm};
  }

  JobText job_of(const Case& c) const {
    const Lying& lying = c.lying;
    JobText job;
    job.cage = model::turned(plan_.cage, lying.file);
    job.cutter = plan_.cutter, job.setup = lying.setup;
    for (int corner = 0; corner < 8; ++corner) {
      Vec3 p = stock_.corner_mm;
      for (int axis = 0; axis < 3; ++axis)
        if ((corner >> axis & 1) != 0) p[axis] += stock_.size_mm[axis];
      job.block.push_back(lying.file.point(p));
    }
    if (lying.holding != Holding::still)
      job.machine = lying.machine, job.control = lying.posting.control;
    job.program = c.posted.text;
    job.gouge_mm = gouge_gate_, job.uncut_mm = uncut_gate_, job.allowance_mm = plan_.allowance_mm;
    job.resolution_mm = kResolution_mm;
    return job;
  }

  JobSaid ask(const Case& c, const std::string& what, LyingResult& result) const {
    const std::string folder =
        keep_.empty() ? "" : keep_ + "/" + std::to_string(plan_.seed) + "-" + what;
    JobSaid said = run_job(job_of(c), folder);
    result.verdict = said.verdict;
    if (!said.stage) result.broken = "nothing was measured: " + said.errors;
    if (said.stage)
      for (const std::string& found : said.stage->process)
        if (result.process.find(found) == std::string::npos) result.process += found + "; ";
    return said;
  }

  /// Of a stage the stretches so far: the first of a program that turns stands at 0 and cuts
  /// nothing.
  std::size_t stretches_at(const Case& c, const StageSaid& stage) const {
    const std::size_t all = c.posted.stretches.size();
    return stage.stretch > 1 ? std::min(all, stage.stretch - 1) : all;
  }

  void judge_twin(LyingResult& result) {
    JobSaid said = ask(twin_, "twin", result);
    // Where contact within the stated tolerance counts as reach, more may be uncut than what the
    // oracle is sure of: the gate of these cases is set above that.
    if (said.stage && said.verdict == "fail" && raise_gate(*said.stage)) {
      result.process.clear();
      said = ask(twin_, "twin-again", result);
    }
    if (said.stage) judge_sides(twin_, *said.stage, result);
  }

  bool raise_gate(const StageSaid& stage) {
    double most = 0;
    for (const NamedPlace& n : stage.uncuts)
      most = std::max(most, twin_oracle_->possibly_uncut_mm(n.place));
    if (!stage.process.empty() || most <= uncut_gate_ || stage.gouge.low > gouge_gate_)
      return false;
    uncut_gate_ = most + kMargin_mm + kResolution_mm;
    return true;
  }

  void judge_harmed(LyingKind kind, LyingResult& result) {
    result.harmed = true;
    const Case harmed = plant_due(kind, result);
    const JobSaid said =
        ask(harmed, std::to_string(out_.size()) + std::string("-") + name(result.kind), result);
    if (said.stage) judge_sides(harmed, *said.stage, result);
  }

  /// Larger and larger until the oracle is sure that there is something to be found; another kind
  /// where this one does the part no harm, such as a place that is wrong along an axis.
  Case plant_due(LyingKind kind, LyingResult& result) {
    if (kind == LyingKind::lost_word && twin_.lying.posting.places == Places::plane)
      kind = LyingKind::wrong_angle;
    for (int attempt = 0;; ++attempt) {
      if (attempt == kMostTries) kind = LyingKind::sunk_pass;
      result.kind = kind;
      Case harmed = plant_one(kind, attempt % kMostTries, result.size);
      const TurnedOracle truth = oracle(harmed, harmed.posted.stretches.size());
      if (is_due(truth) || attempt > 2 * kMostTries) return harmed;
    }
  }
  bool is_due(const TurnedOracle& truth) const {
    return truth.surely_gouged_mm({}) > gouge_gate_ + kResolution_mm ||
           truth.surely_uncut_mm({}) > uncut_gate_ + kResolution_mm;
  }

  Case plant_one(LyingKind kind, int attempt, double& size) {
    const double grown = std::pow(1.6, attempt), t = between(random_, 0, 1);
    const auto spread = [&](double a, double b) { return a * std::pow(b / a, t) * grown; };
    Case out = twin_;
    if (is_local(kind)) {
      size = std::min(spread(0.012, 0.6), 1.2);
      out.program = mishap(kind, size);
    } else {
      size = kind == LyingKind::wrong_angle ? std::min(spread(0.05, 2), 2.0)
                                            : std::min(spread(0.05, 0.4), 0.6);
      harm(out.lying, kind, size, random_);
    }
    out.posted = out.lying.posted(out.program);
    return out;
  }

  NcText mishap(LyingKind kind, double size_mm) {
    const Kind planted = kind == LyingKind::sunk_pass      ? Kind::sunk_pass
                         : kind == LyingKind::missing_pass ? Kind::missing_pass
                                                           : Kind::rapid_through;
    const Sound sound{part_.samples, twin_.program, plan_.cutter, plan_.allowance_mm,
                      plan_.step_mm, plan_.across,  safe_z_mm()};
    return plant(sound, {planted, size_mm, static_cast<unsigned>(random_())}).program;
  }

  void judge_sides(const Case& c, const StageSaid& stage, LyingResult& result) const {
    const std::size_t stretches = stretches_at(c, stage);
    const TurnedOracle truth = oracle(c, stretches);
    judge_gouge(truth, stage, result.gouge);
    judge_uncut(truth, stage, result.uncut);
    // What is left is asked of the last stretch alone.
    if (stretches < c.posted.stretches.size()) result.uncut.due = false;
    if (!result.harmed) return;
    const std::vector<Ends> touched =
        is_local(result.kind) ? changed(c.program, twin_.program) : std::vector<Ends>{};
    find_gouge(c, truth, stage, touched, result);
    find_uncut(stage, touched, result.uncut);
  }

  static bool holds(const verifier::Interval& certified, double sure_mm, double possible_mm) {
    return sure_mm <= certified.high + kSame_mm && possible_mm >= certified.low - kSame_mm;
  }

  void judge_gouge(const TurnedOracle& truth, const StageSaid& stage, SideResult& side) const {
    side.certified = stage.gouge, side.gate_mm = gouge_gate_;
    side.truth_mm = truth.surely_gouged_mm(first_places(stage.gouges));
    double most = side.truth_mm;
    for (const Place& p : first_places(stage.gouges))
      most = std::max(most, truth.possibly_gouged_mm(p));
    finish(side, most);
  }
  void judge_uncut(const TurnedOracle& truth, const StageSaid& stage, SideResult& side) const {
    side.certified = stage.uncut, side.gate_mm = uncut_gate_;
    side.truth_mm = truth.surely_uncut_mm(first_places(stage.uncuts));
    double most = side.truth_mm;
    for (const Place& p : first_places(stage.uncuts))
      most = std::max(most, truth.possibly_uncut_mm(p));
    finish(side, most);
  }
  static void finish(SideResult& side, double most_mm) {
    side.contained = holds(side.certified, side.truth_mm, most_mm);
    side.due = side.truth_mm > side.gate_mm + kResolution_mm;
    side.failed = side.certified.low > side.gate_mm;
  }

  /// Where the mishap was: beside a move that it changed, anywhere where it changed all.
  bool beside(const Vec3& p, const std::vector<Ends>& touched) const {
    const double wide = simulator::CutterProfile(plan_.cutter).largest_radius() + 2 * plan_.step_mm;
    return touched.empty() || std::any_of(touched.begin(), touched.end(), [&](const Ends& e) {
             return distance_in_plan(e, p) <= wide;
           });
  }

  void find_gouge(const Case& c, const TurnedOracle& truth, const StageSaid& stage,
                  const std::vector<Ends>& touched, LyingResult& result) const {
    for (const NamedPlace& f : stage.gouges) {
      const verifier::SurfaceSample s = part_.samples.at(f.place);
      if (distance(c.lying.file.point(s.position), f.point) > kSame_mm)
        result.broken = "a place is not where the part's file has it";
      if (truth.possibly_gouged_mm(f.place) < f.depth_mm - kSameInField_mm)
        result.broken = "a gouge is not as deep as is said there";
      if (f.depth_mm <= gouge_gate_ || !beside(s.position, touched)) continue;
      if (twin_oracle_->possibly_gouged_mm(f.place) > f.depth_mm - kResolution_mm) continue;
      result.gouge.located = true;
      result.gouge.named =
          cuts_there(c, f, s.position + s.normal * (plan_.allowance_mm - f.depth_mm), touched);
      return;
    }
  }

  /// The line named has a move that swept the bottom of the run, and one that the mishap made.
  bool cuts_there(const Case& c, const NamedPlace& f, const Vec3& bottom,
                  const std::vector<Ends>& touched) const {
    for (const Stretch& stretch : c.posted.stretches)
      for (std::size_t i = 0; i < stretch.moves.size(); ++i) {
        if (static_cast<long>(stretch.moves[i].line) != f.line) continue;
        const Vec3 from = i == 0 ? stretch.start : stretch.moves[i - 1].to;
        const simulator::SweptMove swept(from, stretch.moves[i].to, 0);
        const double off = swept_distance(simulator::CutterProfile(plan_.cutter), swept,
                                          stretch.lying.point(bottom))
                               .distance;
        const std::size_t block = stretch.moves[i].block;
        const Ends made =
            ends(c.program.blocks[block > 0 ? block - 1 : 0].to, c.program.blocks[block].to);
        const bool harmed =
            touched.empty() || std::find(touched.begin(), touched.end(), made) != touched.end();
        return off <= kBottom_mm && harmed;
      }
    return false;
  }

  void find_uncut(const StageSaid& stage, const std::vector<Ends>& touched,
                  SideResult& side) const {
    for (const NamedPlace& f : stage.uncuts) {
      if (f.depth_mm <= uncut_gate_ || !beside(part_.samples.at(f.place).position, touched))
        continue;
      if (twin_oracle_->standing_mm(f.place) > f.depth_mm - kResolution_mm) continue;
      side.located = true;
      return;
    }
  }

  const LyingPlan& plan_;
  std::string keep_;
  Target part_;
  model::BoxStock stock_;
  std::mt19937 random_;
  Case twin_;
  std::optional<TurnedOracle> twin_oracle_;
  double gouge_gate_ = 0, uncut_gate_ = 0;
  std::vector<LyingResult> out_;
};

}  // namespace

std::vector<LyingResult> run_lying(const LyingPlan& plan, const std::string& keep) {
  return LyingBench(plan, keep).run();
}

}  // namespace limitgauge::tests::defects
