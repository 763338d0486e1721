#include "tests/defects/bench.h"

#include <algorithm>
#include <array>
#include <memory>
#include <optional>
#include <set>

#include "app/run/stock_probe.h"
#include "model/base/clock.h"
#include "simulator/stock/stock_model.h"

namespace limitgauge::tests::defects {
namespace {

using model::Vec3;
using verifier::Finding;
using verifier::StageDeviation;

constexpr double kSpacing_mm = 0.12;
constexpr double kFieldSpacing_mm = 0.4;
constexpr double kVoxel_mm = 0.15;
constexpr double kAllowanceTwin_mm = 0.1;
/// Two implementations of the same distances; marches of the oracle are one-sided.
constexpr double kSame_mm = 1e-6;
/// Findings come from a field that is stored in single precision.
/// The bottom of a gouge by one of the moves that end there.
constexpr double kBottom_mm = 1e-5;
constexpr double kSameInField_mm = 2e-6;

/// Limits that nothing comes near: figures are narrowed to the width asked for wherever they lie,
/// and the only finding is the deepest.
constexpr verifier::GateLimits kFarLimits = {true, true, false, 1000, 1000, 0};

model::BoxStock block_around(const model::Box3& part) {
  constexpr double kAside_mm = 8, kBelow_mm = 6, kAbove_mm = 1;
  const Vec3 low = part.low - Vec3{kAside_mm, kAside_mm, kBelow_mm};
  return {low, part.high + Vec3{kAside_mm, kAside_mm, kAbove_mm} - low};
}

/// The moves of one path that another does not make.
using Segment = std::array<double, 6>;
Segment segment(const model::Toolpath& path, std::size_t i) {
  const Vec3 &a = model::move_from(path, i), &b = path.moves[i].to;
  return {a.x, a.y, a.z, b.x, b.y, b.z};
}
std::set<Segment> segments(const model::Toolpath& path) {
  std::set<Segment> out;
  for (std::size_t i = 0; i < path.moves.size(); ++i) out.insert(segment(path, i));
  return out;
}
std::vector<Segment> difference(const std::set<Segment>& a, const std::set<Segment>& b) {
  std::vector<Segment> out;
  std::set_difference(a.begin(), a.end(), b.begin(), b.end(), std::back_inserter(out));
  return out;
}
double distance_in_plan(const Segment& s, const Vec3& p) {
  const double dx = s[3] - s[0], dy = s[4] - s[1], l2 = dx * dx + dy * dy;
  const double t =
      l2 > 0 ? std::clamp(((p.x - s[0]) * dx + (p.y - s[1]) * dy) / l2, 0.0, 1.0) : 0.0;
  return std::hypot(p.x - s[0] - t * dx, p.y - s[1] - t * dy);
}

/// A program, the cutter and the allowance it is judged with, and the oracles about it.
struct Run {
  model::Toolpath path;
  model::Cutter cutter;
  double allowance_mm = 0;
  std::shared_ptr<const model::Toolpath> shared_path;
  simulator::Pass pass;
  RunOracle oracle;

  Run(const Target& target, const model::BoxStock& stock, const std::string& text,
      const model::Cutter& used, double allowance)
      : path(read_back(text)),
        cutter(used),
        allowance_mm(allowance),
        shared_path(std::make_shared<const model::Toolpath>(path)),
        pass{used, shared_path},
        oracle(target, stock, {&pass, 1}, allowance) {}
};

/// The unharmed program with what it is known to keep.
struct Twin {
  Sound sound;
  Run run;
  verifier::GateLimits limits;
  std::set<Segment> segments_of;
};

class PairBench {
 public:
  explicit PairBench(const PairPlan& plan)
      : plan_(plan),
        target_(plan.cage, kSpacing_mm),
        stock_(block_around(target_.surface.bounding_box())),
        name_(plan.surface_name + ", " + plan.cutter.id) {
    if (!plan.lying) return;
    lying_surface_.emplace(model::turned(plan.cage, *plan.lying));
    lying_stock_ = model::turned(stock_, *plan.lying);
  }

  PairResult run() {
    std::optional<Twin> plain, allowing;
    for (const Mishap& mishap : plan_.mishaps) {
      const bool allowance = mishap.kind == Kind::wrong_allowance;
      std::optional<Twin>& twin = allowance ? allowing : plain;
      if (!twin) make_twin(allowance ? kAllowanceTwin_mm : 0, twin);
      out_.cases.push_back(judge(*twin, mishap));
    }
    return std::move(out_);
  }

 private:
  void make_twin(double allowance_mm, std::optional<Twin>& twin) {
    const RasterRequest request{plan_.cutter, allowance_mm, plan_.step_mm, plan_.across};
    const double safe_z = stock_.corner_mm.z + stock_.size_mm.z + 2;
    Sound sound{
        target_.samples, program_of(gouge_free_rows(target_.samples, request), safe_z, plan_.modal),
        plan_.cutter,    allowance_mm,
        plan_.step_mm,   plan_.across,
        safe_z};
    Run run(target_, stock_, sound.program.text(), plan_.cutter, allowance_mm);
    twin.emplace(Twin{std::move(sound), std::move(run), {}, {}});
    twin->segments_of = segments(twin->run.path);
    judge_twin(*twin);
  }

  void judge_twin(Twin& twin) {
    const model::Stopwatch watch;
    TwinResult result;
    result.pair = name_;
    result.allowance_mm = twin.sound.allowance_mm;
    result.voxels = plan_.voxels_every > 0 && (plan_.turn + out_.twins.size()) % 3 == 0;
    try {
      const StageDeviation d = measure(twin.run, kFarLimits, result.voxels);
      twin.limits = {true, true, false, d.gouge_mm.high, d.uncut_mm.high, 0};
      judge_gouge(twin.run, d, result.gouge);
      judge_uncut(twin.run, d, result.uncut);
      const verifier::GateLimits gate = {true,
                                         true,
                                         false,
                                         result.gouge.truth_mm + plan_.resolution_mm,
                                         allowed_uncut_mm(twin, d) + plan_.resolution_mm,
                                         0};
      result.verdict = certified_verdict(d, gate);
      result.reached_resolution = d.reached_resolution;
    } catch (const std::exception& error) {
      result.broken = error.what();
    }
    result.seconds = watch.seconds();
    out_.twins.push_back(result);
  }

  CaseResult judge(Twin& twin, const Mishap& mishap) {
    const model::Stopwatch watch;
    CaseResult result;
    result.pair = name_;
    result.resolution_mm = plan_.resolution_mm;
    result.mishap = mishap;
    const std::size_t turn = out_.cases.size() + plan_.turn;
    result.voxels = plan_.voxels_every > 0 && turn % plan_.voxels_every == 0;
    result.gated = turn % 3 == 0;
    try {
      const Planted planted = plant(twin.sound, mishap);
      const Run run(target_, stock_, planted.text, planted.cutter, planted.allowance_mm);
      const StageDeviation d = measure(run, result.gated ? twin.limits : kFarLimits, result.voxels);
      result.cells = d.cells;
      result.reached_resolution = d.reached_resolution;
      judge_sides(twin, run, d, result);
    } catch (const std::exception& error) {
      result.broken = error.what();
    }
    result.seconds = watch.seconds();
    return result;
  }

  void judge_sides(Twin& twin, const Run& run, const StageDeviation& d, CaseResult& result) {
    judge_gouge(run, d, result.gouge);
    judge_uncut(run, d, result.uncut);
    result.gouge.gate_mm = twin.limits.gouge_mm;
    result.uncut.gate_mm = twin.limits.uncut_mm;
    const auto fails = [&](bool gouge) {
      verifier::GateLimits limits = twin.limits;
      limits.has_gouge = gouge, limits.has_uncut = !gouge;
      return certified_verdict(d, limits) == verifier::Verdict::fail;
    };
    result.gouge.failed = fails(true);
    result.uncut.failed = fails(false);
    for (SideResult* side : {&result.gouge, &result.uncut})
      side->due = side->truth_mm > side->gate_mm + plan_.resolution_mm;
    find_places(twin, run, d, result);
  }

  /// The most that a right verdict may call uncut: the tolerance of contact counts as reached.
  static double allowed_uncut_mm(const Twin& twin, const StageDeviation& d) {
    double most = twin.run.oracle.surely_uncut(places_of(d.uncuts)).depth_mm;
    for (const Place& p : places_of(d.uncuts))
      most = std::max(most, twin.run.oracle.possibly_uncut(p));
    return most;
  }

  /// The decision by the certified intervals alone.
  static verifier::Verdict certified_verdict(StageDeviation d, const verifier::GateLimits& limits) {
    d.voxel_uncut_mm = 0;
    return decide(d, limits).verdict;
  }

  StageDeviation measure(const Run& run, const verifier::GateLimits& limits, bool voxels) const {
    verifier::StageCheck check;
    check.allowance_mm = run.allowance_mm;
    check.limits = limits;
    check.resolution_mm = plan_.resolution_mm;
    check.field_spacing_mm = kFieldSpacing_mm;
    const auto path = std::make_shared<const model::Toolpath>(run.path);
    std::optional<app::StockRayProbe> probe;
    if (voxels) probe.emplace(cut_stock(run, path));
    const verifier::Pass pass = pass_of(run, path);
    const verifier::StockProbe* asked = probe ? &*probe : nullptr;
    if (!plan_.lying)
      return measure_stage(target_.surface, stock_, {&pass, 1}, asked, check, {1, nullptr, {}});
    StageDeviation d =
        measure_stage(*lying_surface_, lying_stock_, {&pass, 1}, asked, check, {1, nullptr, {}});
    turn(d, plan_.lying->inverse());
    return d;
  }

  verifier::Pass pass_of(const Run& run, const std::shared_ptr<const model::Toolpath>& path) const {
    return {run.cutter, path, plan_.lying.value_or(model::Pose())};
  }

  simulator::StockModel cut_stock(const Run& run,
                                  const std::shared_ptr<const model::Toolpath>& path) const {
    constexpr std::size_t kMemory = std::size_t{4} << 30;
    const model::RunControl control{1, nullptr, {}};
    const model::Stock raw = plan_.lying ? lying_stock_ : model::Stock(stock_);
    return simulator::StockModel(raw, kVoxel_mm, kMemory).cut(pass_of(run, path), control);
  }

  static std::vector<Place> places_of(const std::vector<Finding>& findings) {
    constexpr std::size_t kFirst = 2;
    std::vector<Place> out;
    for (std::size_t k = 0; k < std::min(kFirst, findings.size()); ++k)
      out.push_back({findings[k].place.patch, findings[k].place.u, findings[k].place.v});
    return out;
  }

  void judge_gouge(const Run& run, const StageDeviation& d, SideResult& side) const {
    side.certified = d.gouge_mm;
    side.truth_mm = run.oracle.surely_gouged(places_of(d.gouges)).depth_mm;
    double most = side.truth_mm;
    for (const Place& p : places_of(d.gouges)) most = std::max(most, run.oracle.possibly_gouged(p));
    side.contained = holds(d.gouge_mm, side.truth_mm, most);
  }

  void judge_uncut(const Run& run, const StageDeviation& d, SideResult& side) const {
    side.certified = d.uncut_mm;
    side.truth_mm = run.oracle.surely_uncut(places_of(d.uncuts)).depth_mm;
    // The certified low end may be reached where contact is within the stated tolerance only.
    double most = side.truth_mm;
    for (const Place& p : places_of(d.uncuts)) most = std::max(most, run.oracle.possibly_uncut(p));
    side.contained = holds(d.uncut_mm, side.truth_mm, most);
  }

  /// No place has more than `high`, and some may have `low`.
  static bool holds(const verifier::Interval& certified, double sure_mm, double possible_mm) {
    return sure_mm <= certified.high + kSame_mm && possible_mm >= certified.low - kSame_mm;
  }

  static double distance_to_move(const Run& run, std::size_t move, const Vec3& p) {
    const simulator::SweptMove swept(model::move_from(run.path, move), run.path.moves[move].to,
                                     static_cast<std::uint32_t>(move));
    return swept_distance(simulator::CutterProfile(run.cutter), swept, p).distance;
  }

  void find_places(const Twin& twin, const Run& run, const StageDeviation& d,
                   CaseResult& result) const {
    const std::set<Segment> now = segments(run.path);
    const std::vector<Segment> made = difference(now, twin.segments_of),
                               lost = difference(twin.segments_of, now);
    const double wide = simulator::CutterProfile(run.cutter).largest_radius() + 2 * plan_.step_mm;
    const bool other_program = !made.empty() || !lost.empty();
    const auto beside = [&](const Vec3& p) {
      const auto near = [&](const Segment& s) { return distance_in_plan(s, p) <= wide; };
      return !other_program || std::any_of(made.begin(), made.end(), near) ||
             std::any_of(lost.begin(), lost.end(), near);
    };
    const double a = run.allowance_mm;
    for (const Finding& f : d.gouges) {
      const Vec3& p = f.place.point;
      const Place place{f.place.patch, f.place.u, f.place.v};
      if (run.oracle.possibly_gouged(place) < f.depth_mm - kSameInField_mm) {
        result.broken = "a gouge is not as deep as the simulator says there";
        return;
      }
      if (f.depth_mm <= result.gouge.gate_mm || !beside(p)) continue;
      // Worse than the twin there: at a ridge the oracle gives the twin up to a micrometre more.
      if (twin.run.oracle.possibly_gouged(place) > f.depth_mm - plan_.resolution_mm) continue;
      result.gouge.located = true;
      // The move named swept the bottom of the run.
      const Vec3 bottom = p + target_.samples.at(place).normal * (a - f.depth_mm);
      const bool cut_there = !f.raw_stock && distance_to_move(run, f.move, bottom) <= kBottom_mm;
      const bool touched =
          !other_program || (!f.raw_stock && !twin.segments_of.contains(segment(run.path, f.move)));
      const bool line = !f.raw_stock && f.line == run.path.moves[f.move].line && f.line > 0;
      result.gouge.named = cut_there && touched && line;
      break;
    }
    for (const Finding& f : d.uncuts) {
      const Vec3& p = f.place.point;
      // Worse than the twin there: another allowance or cutter moves the rim of what can be
      // reached.
      const Place place{f.place.patch, f.place.u, f.place.v};
      if (f.depth_mm <= result.uncut.gate_mm || !beside(p)) continue;
      // What the oracle gives both, reach aside.
      const Vec3 n = target_.samples.at(place).normal;
      if (run.oracle.uncut(p, n).possible_mm <=
          twin.run.oracle.uncut(p, n).possible_mm + plan_.resolution_mm)
        continue;
      result.uncut.located = true;
      break;
    }
  }

  const PairPlan& plan_;
  Target target_;
  model::BoxStock stock_;
  std::optional<verifier::ReferenceSurface> lying_surface_;
  model::Stock lying_stock_;
  std::string name_;
  PairResult out_;
};

}  // namespace

PairResult run_pair(const PairPlan& plan) {
  return PairBench(plan).run();
}

}  // namespace limitgauge::tests::defects
