#include "tests/defects/orientations/lying_judge.h"

#include <algorithm>
#include <cmath>

#include "simulator/sweep/cutter_profile.h"
#include "simulator/sweep/swept_distance.h"

namespace limitgauge::tests::defects {
namespace {

using model::Vec3;

constexpr double kSpacing_mm = 0.12;
/// Two implementations of the same distances; marches of the oracle are one-sided.
constexpr double kSame_mm = 1e-6;
/// Findings come from a field that is stored in single precision.
constexpr double kSameInField_mm = 2e-6;
/// The bottom of a gouge by one of the moves that end there.
constexpr double kBottom_mm = 1e-5;

model::BoxStock block_about(const model::Box3& part) {
  constexpr double kAside_mm = 1.5, kBelow_mm = 2, kAbove_mm = 0.5;
  const Vec3 low = part.low - Vec3{kAside_mm, kAside_mm, kBelow_mm};
  return {low, part.high + Vec3{kAside_mm, kAside_mm, kAbove_mm} - low};
}

std::vector<Place> first_places(const std::vector<NamedPlace>& named) {
  constexpr std::size_t kFirst = 2;
  std::vector<Place> out;
  for (std::size_t k = 0; k < std::min(kFirst, named.size()); ++k) out.push_back(named[k].place);
  return out;
}

/// No place has more than `high`, and some may have `low`.
bool holds(const verifier::Interval& certified, double sure_mm, double possible_mm) {
  return sure_mm <= certified.high + kSame_mm && possible_mm >= certified.low - kSame_mm;
}

void finish(SideResult& side, double most_mm) {
  side.contained = holds(side.certified, side.truth_mm, most_mm);
  side.due = side.truth_mm > side.gate_mm + kLyingResolution_mm;
  side.failed = side.certified.low > side.gate_mm;
}

/// Of a stage the stretches so far: the first of a program that turns stands at 0 and cuts nothing.
std::size_t stretches_at(const Posted& posted, const StageSaid& stage) {
  const std::size_t all = posted.stretches.size();
  return stage.stretch > 1 ? std::min(all, stage.stretch - 1) : all;
}

}  // namespace

LyingGround::LyingGround(const LyingPlan& made)
    : plan(made), part(made.cage, kSpacing_mm), stock(block_about(part.surface.bounding_box())) {}

TurnedOracle LyingGround::oracle(const LyingCase& lying_case, std::size_t stretches) const {
  return {part,
          plan.cage,
          stock,
          plan.cutter,
          std::span(lying_case.posted.stretches).first(stretches),
          plan.allowance_mm};
}

void LyingJudge::judge(const LyingCase& judged, const StageSaid& stage, LyingResult& result) const {
  const std::size_t stretches = stretches_at(judged.posted, stage);
  const TurnedOracle truth = ground_.oracle(judged, stretches);
  Judged j{judged, truth, stage, {}};
  judge_gouge(j, result.gouge);
  judge_uncut(j, result.uncut);
  // What is left is asked of the last stretch alone.
  if (stretches < judged.posted.stretches.size()) result.uncut.due = false;
  if (!result.harmed) return;
  if (is_local(result.kind)) j.touched = changed(judged.program, twin_.program);
  find_gouge(j, result);
  find_uncut(j, result.uncut);
}

void LyingJudge::judge_gouge(const Judged& j, SideResult& side) const {
  const std::vector<Place> places = first_places(j.stage.gouges);
  side.certified = j.stage.gouge, side.gate_mm = gate_.gouge_mm;
  double most = side.truth_mm = j.truth.surely_gouged_mm(places);
  for (const Place& p : places) most = std::max(most, j.truth.possibly_gouged_mm(p));
  finish(side, most);
}

void LyingJudge::judge_uncut(const Judged& j, SideResult& side) const {
  const std::vector<Place> places = first_places(j.stage.uncuts);
  side.certified = j.stage.uncut, side.gate_mm = gate_.uncut_mm;
  double most = side.truth_mm = j.truth.surely_uncut_mm(places);
  for (const Place& p : places) most = std::max(most, j.truth.possibly_uncut_mm(p));
  finish(side, most);
}

LyingJudge::Ends LyingJudge::ends(const NcText& program, std::size_t block) {
  const Vec3 &a = program.blocks[block > 0 ? block - 1 : 0].to, &b = program.blocks[block].to;
  return {a.x, a.y, a.z, b.x, b.y, b.z};
}

/// Moves that one program makes and the other does not, either way.
std::vector<LyingJudge::Ends> LyingJudge::changed(const NcText& a, const NcText& b) {
  const auto moves = [](const NcText& program) {
    std::vector<Ends> all;
    for (std::size_t k = 0; k < program.blocks.size(); ++k) all.push_back(ends(program, k));
    std::sort(all.begin(), all.end());
    return all;
  };
  const std::vector<Ends> of_a = moves(a), of_b = moves(b);
  std::vector<Ends> out;
  std::set_symmetric_difference(of_a.begin(), of_a.end(), of_b.begin(), of_b.end(),
                                std::back_inserter(out));
  return out;
}

/// Beside a move that the mishap changed; anywhere where it changed all.
bool LyingJudge::beside(const Vec3& p, const std::vector<Ends>& touched) const {
  const double wide =
      simulator::CutterProfile(ground_.plan.cutter).largest_radius() + 2 * ground_.plan.step_mm;
  const auto near = [&](const Ends& s) {
    const double dx = s[3] - s[0], dy = s[4] - s[1], l2 = dx * dx + dy * dy;
    const double along = (p.x - s[0]) * dx + (p.y - s[1]) * dy;
    const double t = l2 > 0 ? std::clamp(along / l2, 0.0, 1.0) : 0.0;
    return std::hypot(p.x - s[0] - t * dx, p.y - s[1] - t * dy) <= wide;
  };
  return touched.empty() || std::any_of(touched.begin(), touched.end(), near);
}

std::string LyingJudge::contradiction(const Judged& j, const NamedPlace& f) const {
  const Vec3 point = ground_.part.samples.at(f.place).position;
  if (distance(j.lying_case.lying.file.point(point), f.point) > kSame_mm)
    return "a place is not where the part's file has it";
  if (j.truth.possibly_gouged_mm(f.place) < f.depth_mm - kSameInField_mm)
    return "a gouge is not as deep as is said there";
  return {};
}

void LyingJudge::find_gouge(const Judged& j, LyingResult& result) const {
  for (const NamedPlace& f : j.stage.gouges) {
    result.broken = contradiction(j, f);
    if (!result.broken.empty()) return;
    const Vec3 point = ground_.part.samples.at(f.place).position;
    if (f.depth_mm <= gate_.gouge_mm || !beside(point, j.touched)) continue;
    // Worse than the twin there.
    if (twin_oracle_.possibly_gouged_mm(f.place) > f.depth_mm - kLyingResolution_mm) continue;
    result.gouge.located = true;
    result.gouge.named = cuts_there(j, f);
    return;
  }
}

/// The line named has a move that swept the bottom of the run, and one that the mishap made.
bool LyingJudge::cuts_there(const Judged& j, const NamedPlace& f) const {
  const verifier::SurfaceSample s = ground_.part.samples.at(f.place);
  const Vec3 bottom = s.position + s.normal * (ground_.plan.allowance_mm - f.depth_mm);
  const auto is_touched = [&](const Ends& made) {
    return j.touched.empty() ||
           std::find(j.touched.begin(), j.touched.end(), made) != j.touched.end();
  };
  for (const Stretch& stretch : j.lying_case.posted.stretches)
    for (std::size_t i = 0; i < stretch.moves.size(); ++i)
      if (static_cast<long>(stretch.moves[i].line) == f.line)
        return swept(stretch, i, bottom) &&
               is_touched(ends(j.lying_case.program, stretch.moves[i].block));
  return false;
}

/// Whether a move ends, within rounding, at a place of the nominal frame.
bool LyingJudge::swept(const Stretch& stretch, std::size_t move, const Vec3& p) const {
  const Vec3 from = move == 0 ? stretch.start : stretch.moves[move - 1].to;
  const simulator::SweptMove way(from, stretch.moves[move].to, 0);
  const simulator::CutterProfile profile(ground_.plan.cutter);
  return swept_distance(profile, way, stretch.lying.point(p)).distance <= kBottom_mm;
}

void LyingJudge::find_uncut(const Judged& j, SideResult& side) const {
  for (const NamedPlace& f : j.stage.uncuts) {
    const Vec3 point = ground_.part.samples.at(f.place).position;
    if (f.depth_mm <= gate_.uncut_mm || !beside(point, j.touched)) continue;
    // Worse than the twin there, reach aside.
    if (twin_oracle_.standing_mm(f.place) > f.depth_mm - kLyingResolution_mm) continue;
    side.located = true;
    return;
  }
}

}  // namespace limitgauge::tests::defects
