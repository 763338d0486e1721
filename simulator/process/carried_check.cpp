#include "simulator/process/carried_check.h"

#include <algorithm>
#include <iterator>
#include <memory>

#include "model/base/chunks.h"

namespace limitgauge::simulator {
namespace {

using model::Box3;
using model::Pose;
using model::Vec3;

constexpr std::size_t kMovesAtOnce = 4096;
// Looks at a run of moves before it is halved.
constexpr std::size_t kMostLooksAtRun = 20'000;

Pose moved_to(const Vec3& tip, const Pose& from_tip) {
  Pose pose = from_tip;
  pose.shift_mm = pose.shift_mm + tip;
  return pose;
}

/// Of a body that goes straight with the tip.
TurningPose along_move(const Vec3& from, const Vec3& to, const Pose& from_tip) {
  return {[=](double t) { return moved_to(from + (to - from) * t, from_tip); }, distance(from, to),
          0, 0, 0};
}

}  // namespace

CarriedCheck::CarriedCheck(const StockModel& before, const Pass& pass, const ProcessLimits& limits)
    : pass_(pass), tolerance_mm_(limits.tolerance_mm), near_miss_mm_(limits.near_miss_mm) {
  if (limits.carried.empty()) return;
  things_.push_back({"stock", before.material()});
  for (const model::Fixture& fixture : limits.fixtures)
    things_.push_back(
        {fixture.name, Material(RawStock(model::MeshStock{fixture.mesh, fixture.file, 0}))});
  for (const CarriedBody& carried : limits.carried)
    bodies_.push_back({carried.body.name, MeshSolid(carried.body.mesh), carried.from_tip});
}

/// Moves [first, end) at once: no tip is farther from the middle of all than half the diagonal of
/// the box around them.
bool CarriedCheck::is_clear(std::size_t first, std::size_t end, const Suspect& pair,
                            const model::RunControl& control) const {
  const model::Toolpath& path = *pass_.path;
  Box3 tips;
  tips.add(move_from(path, first));
  for (std::size_t i = first; i < end; ++i) tips.add(path.moves[i].to);
  const Body& body = bodies_[pair.body];
  const TurningPose still = along_move(tips.centre(), tips.centre(), body.from_tip);
  TurnSearch search{&things_[pair.thing].solid, &body.solid, &still, 0, 0, kMostLooksAtRun};
  const double reach_mm = length(tips.size()) / 2;
  const TurnAnswer answer =
      least_turn_gap(search, reach_mm + near_miss_mm_ + tolerance_mm_, tolerance_mm_, control);
  return answer.proven && !answer.place;
}

void CarriedCheck::add_suspects(std::size_t first, std::size_t end, const Suspect& pair,
                                std::vector<Suspect>& suspects,
                                const model::RunControl& control) const {
  if (is_clear(first, end, pair, control)) return;
  if (end - first == 1) return suspects.push_back({first, pair.body, pair.thing});
  const std::size_t middle = first + (end - first) / 2;
  add_suspects(first, middle, pair, suspects, control);
  add_suspects(middle, end, pair, suspects, control);
}

std::vector<CarriedCheck::Suspect> CarriedCheck::suspects(const model::RunControl& control) const {
  const std::size_t moves = pass_.path->moves.size();
  std::vector<std::vector<Suspect>> found(model::chunk_count(moves, kMovesAtOnce));
  model::parallel_chunks(moves, kMovesAtOnce, control, [&](std::size_t begin, std::size_t end) {
    std::vector<Suspect>& own = found[begin / kMovesAtOnce];
    for (std::size_t b = 0; b < bodies_.size(); ++b)
      for (std::size_t k = 0; k < things_.size(); ++k)
        add_suspects(begin, end, {0, b, k}, own, control);
  });
  std::vector<Suspect> all;
  for (const auto& own : found) all.insert(all.end(), own.begin(), own.end());
  std::ranges::stable_sort(all, {}, &Suspect::move);
  return all;
}

void CarriedCheck::look_at(const Suspect& suspect, const SweepIndex* cut_by,
                           std::vector<Finding>& findings, const model::RunControl& control) const {
  const auto& [name, solid, from_tip] = bodies_[suspect.body];
  const model::Move& move = pass_.path->moves[suspect.move];
  const Vec3& from = move_from(*pass_.path, suspect.move);
  const TurningPose pose = along_move(from, move.to, from_tip);
  TurnSearch search{&things_[suspect.thing].solid, &solid, &pose};
  const bool is_stock = suspect.thing == 0;
  // On the way up the move's own flutes come to places above them after the body does.
  const std::size_t cut = move.to.z > from.z ? suspect.move : suspect.move + 1;
  if (is_stock) search.pass = cut_by, search.end = static_cast<std::uint32_t>(cut);
  TurnMeeting met = contact_during(search, tolerance_mm_, control);
  if (met.touch == Touch::none && near_miss_mm_ > 0)
    met = gap_during(search, near_miss_mm_, tolerance_mm_, control);
  if (met.touch == Touch::none && !met.place) return;
  Finding f{FindingKind::near_miss,     suspect.move, move.line, from, 0, name,
            things_[suspect.thing].name};
  if (met.touch == Touch::slight) f.kind = FindingKind::slight_contact;
  if (met.touch == Touch::contact)
    f.kind = is_stock ? FindingKind::holder_in_stock : FindingKind::fixture_touched;
  if (met.place) {
    f.point = met.place->point;
    f.depth_mm = met.touch == Touch::none ? -met.place->mm : met.place->mm;
  }
  findings.push_back(std::move(f));
}

std::vector<Finding> CarriedCheck::findings(const model::RunControl& control) const {
  if (bodies_.empty()) return {};
  const std::vector<Suspect> all = suspects(control);
  std::unique_ptr<const SweepIndex> cut_by;
  if (std::ranges::any_of(all, [](const Suspect& s) { return s.thing == 0; }))
    cut_by = std::make_unique<const SweepIndex>(pass_, control);
  std::vector<std::vector<Finding>> found(all.size());
  model::parallel_chunks(all.size(), 1, control, [&](std::size_t i, std::size_t) {
    look_at(all[i], cut_by.get(), found[i], control);
  });
  std::vector<Finding> findings;
  for (std::vector<Finding>& own : found)
    std::move(own.begin(), own.end(), std::back_inserter(findings));
  return findings;
}

}  // namespace limitgauge::simulator
