#include "simulator/process/turning/turn_check.h"

#include <algorithm>
#include <array>
#include <stdexcept>

#include "model/base/chunks.h"

namespace limitgauge::simulator {
namespace {

// A turn is looked through in so many stretches, each on a thread of its own: their number is fixed
// so that findings do not depend on that of the threads.
constexpr int kStretches = 8;
// How finely it is looked when a part has left the stock, or begins to arrive.
constexpr int kTimesToLeave = 64;
constexpr std::array kToolParts{ToolPart::cutter, ToolPart::shank, ToolPart::holder};

}  // namespace

/// Of a part's turn among a thing.
struct TurnCheck::Stretch {
  std::size_t obstacle = 0, mover = 0;
  TurnSearch search;
  double near_mm = 0;  // distances below count

  Stretch between(double from, double to) const {
    Stretch part = *this;
    part.search.from = from, part.search.to = to;
    return part;
  }
  void add_parts(std::vector<Stretch>& all) const {
    const double step = (search.to - search.from) / kStretches;
    for (int k = 0; k < kStretches; ++k)
      all.push_back(between(search.from + k * step, search.from + (k + 1) * step));
  }
};

TurnCheck::TurnCheck(const StockModel& stock, const model::Cutter& cutter,
                     const ProcessLimits& limits)
    : tolerance_mm_(limits.tolerance_mm),
      near_miss_mm_(limits.near_miss_mm),
      parts_(ToolBodies(cutter, 0).parts()) {
  require_contact_limits(limits);
  obstacles_.push_back({"stock", stock.material(), true});
  for (const model::Fixture& fixture : limits.fixtures)
    obstacles_.push_back(
        {fixture.name, Material(RawStock(model::MeshStock{fixture.mesh, fixture.file, 0})), false});
  for (const ToolPart part : kToolParts) part_names_.emplace_back(name(part));
  for (const CarriedBody& carried : limits.carried) {
    carried_.emplace_back(carried.body.mesh);
    part_names_.push_back(carried.body.name);
  }
}

MovingShape TurnCheck::shape(std::size_t mover) const {
  if (mover < parts_.size()) return &parts_[mover];
  return &carried_[mover - parts_.size()];
}

std::size_t TurnCheck::part_of(std::size_t mover) const {
  if (mover < parts_.size()) return static_cast<std::size_t>(parts_[mover].part);
  return kToolParts.size() + mover - parts_.size();
}

const TurningPose& TurnCheck::pose_in(const TurningTool& motion, std::size_t obstacle,
                                      std::size_t mover) const {
  if (mover < parts_.size())
    return obstacle == 0 ? motion.in_stock : motion.in_fixtures[obstacle - 1];
  const TurningTool::Carried& carried = motion.carried[mover - parts_.size()];
  return obstacle == 0 ? carried.in_stock : carried.in_fixtures[obstacle - 1];
}

std::vector<TurnCheck::Stretch> TurnCheck::stretches(const TurningTool& motion) const {
  std::vector<Stretch> all;
  for (std::size_t k = 0; k < obstacles_.size(); ++k)
    for (std::size_t m = 0; m < movers(); ++m)
      all.push_back(
          {k, m, {&obstacles_[k].solid, shape(m), &pose_in(motion, k, m)}, near_miss_mm_});
  return all;
}

/// What is left at one time, no less than that; where nothing is near, as much as counts.
double TurnCheck::gap_at(const Stretch& stretch, double t, const model::RunControl& control) const {
  const TurnMeeting there =
      gap_during(stretch.between(t, t).search, stretch.near_mm, tolerance_mm_, control);
  return there.place ? there.place->mm : stretch.near_mm;
}

void TurnCheck::leave_and_arrive(std::vector<Stretch>& all, const Stretch& whole,
                                 const model::RunControl& control) const {
  const auto time = [](int k) { return static_cast<double>(k) / kTimesToLeave; };
  const auto far_at = [&](int k) { return gap_at(whole, time(k), control) >= whole.near_mm; };
  int left = 0, arrives = kTimesToLeave;
  while (left < kTimesToLeave && !far_at(left)) ++left;
  while (arrives > left && !far_at(arrives)) --arrives;
  const auto add = [&](int from, int to, double near_mm) {
    Stretch part = whole.between(time(from), time(to));
    part.near_mm = near_mm;
    if (from < to && near_mm > 0) part.add_parts(all);
  };
  const double at_end = gap_at(whole, 1, control);
  double at_start = gap_at(whole, 0, control);
  if (left == kTimesToLeave) at_start = std::min(at_start, at_end);  // it never leaves
  add(0, left, at_start - tolerance_mm_);
  add(left, arrives, whole.near_mm);
  add(arrives, kTimesToLeave, at_end - tolerance_mm_);
}

/// Where near misses are looked for.
std::vector<TurnCheck::Stretch> TurnCheck::near_stretches(const TurningTool& motion,
                                                          const std::vector<Touch>& touched,
                                                          const model::RunControl& control) const {
  std::vector<Stretch> all;
  for (const Stretch& whole : stretches(motion)) {
    if (touched[whole.obstacle] != Touch::none) continue;
    if (obstacles_[whole.obstacle].is_stock)
      leave_and_arrive(all, whole, control);
    else
      whole.add_parts(all);
  }
  return all;
}

/// Of each pair of thing and part, those of the holder being one.
template <class Look>
std::vector<TurnMeeting> TurnCheck::worst_of(const std::vector<Stretch>& stretches,
                                             const Look& look,
                                             const model::RunControl& control) const {
  std::vector<TurnMeeting> found(stretches.size());
  model::parallel_chunks(found.size(), 1, control,
                         [&](std::size_t i, std::size_t) { found[i] = look(stretches[i]); });
  std::vector<TurnMeeting> worst(obstacles_.size() * part_names_.size());
  for (std::size_t i = 0; i < found.size(); ++i) {
    const std::size_t part = part_of(stretches[i].mover);
    TurnMeeting& known = worst[stretches[i].obstacle * part_names_.size() + part];
    if (found[i].worse_than(known)) known = found[i];
  }
  return worst;
}

FindingKind TurnCheck::contact_kind(std::size_t pair, bool rapid) const {
  if (!obstacles_[pair / part_names_.size()].is_stock) return FindingKind::fixture_touched;
  const std::size_t part = pair % part_names_.size();
  if (part == static_cast<std::size_t>(ToolPart::shank)) return FindingKind::shank_in_stock;
  if (part != static_cast<std::size_t>(ToolPart::cutter)) return FindingKind::holder_in_stock;
  return rapid ? FindingKind::rapid_through_stock : FindingKind::cut_while_turning;
}

/// A place of a fixture goes by the tool into the stock's frame as that stands then.
model::Vec3 TurnCheck::place_in_stock(const TurningTool& motion, const TurnPlace& place,
                                      std::size_t obstacle) const {
  if (obstacles_[obstacle].is_stock) return place.point;
  return motion.in_stock.at(place.t).point(
      motion.in_fixtures[obstacle - 1].at(place.t).point_back(place.point));
}

Finding TurnCheck::finding(FindingKind kind, const TurningTool& motion, const TurnMeeting& meeting,
                           std::size_t pair) const {
  const std::size_t k = pair / part_names_.size();
  const double t = meeting.place ? meeting.place->t : 0.5;
  Finding f{kind,
            0,
            motion.line,
            motion.in_stock.at(t).shift_mm,
            0,
            part_names_[pair % part_names_.size()],
            obstacles_[k].name};
  if (!meeting.place) return f;
  f.depth_mm = kind == FindingKind::near_miss ? -meeting.place->mm : meeting.place->mm;
  f.point = place_in_stock(motion, *meeting.place, k);
  return f;
}

void TurnCheck::require_poses(const TurningTool& motion) const {
  bool has_all = motion.in_fixtures.size() + 1 == obstacles_.size() &&
                 motion.carried.size() == carried_.size();
  for (const TurningTool::Carried& carried : motion.carried)
    has_all = has_all && carried.in_fixtures.size() + 1 == obstacles_.size();
  if (!has_all)
    throw std::invalid_argument("a turn has a pose for each carried body and each fixture");
  for (const Stretch& stretch : stretches(motion)) require_bounds(*stretch.search.pose);
}

std::vector<Finding> TurnCheck::look_at(const TurningTool& motion,
                                        const model::RunControl& control) const {
  require_poses(motion);
  std::vector<Stretch> all;
  for (const Stretch& whole : stretches(motion)) whole.add_parts(all);
  const std::vector<TurnMeeting> worst = worst_of(
      all, [&](const Stretch& s) { return contact_during(s.search, tolerance_mm_, control); },
      control);
  std::vector<Touch> touched(obstacles_.size(), Touch::none);
  for (std::size_t pair = 0; pair < worst.size(); ++pair) {
    Touch& touch = touched[pair / part_names_.size()];
    touch = std::max(touch, worst[pair].touch);
  }
  all = near_miss_mm_ > 0 ? near_stretches(motion, touched, control) : std::vector<Stretch>();
  const auto gap = [&](const Stretch& s) {
    return gap_during(s.search, s.near_mm, tolerance_mm_, control);
  };
  const std::vector<TurnMeeting> nearest = worst_of(all, gap, control);
  std::vector<Finding> findings;
  for (std::size_t pair = 0; pair < worst.size(); ++pair) {
    const Touch touch = touched[pair / part_names_.size()];
    if (touch == Touch::none && nearest[pair].place)
      findings.push_back(finding(FindingKind::near_miss, motion, nearest[pair], pair));
    if (touch == Touch::none || worst[pair].touch != touch) continue;
    const FindingKind kind =
        touch == Touch::slight ? FindingKind::slight_contact : contact_kind(pair, motion.rapid);
    findings.push_back(finding(kind, motion, worst[pair], pair));
  }
  return findings;
}

std::vector<Finding> check_turn(const StockModel& stock, const model::Cutter& cutter,
                                const TurningTool& motion, const ProcessLimits& limits,
                                const model::RunControl& control) {
  return TurnCheck(stock, cutter, limits).look_at(motion, control);
}

}  // namespace limitgauge::simulator
