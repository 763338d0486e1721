#include "simulator/process/turn_check.h"

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
// For what fails nothing.
constexpr std::size_t kMostSlightLooks = kMostTurnLooks / 10;
constexpr std::array kToolParts{ToolPart::cutter, ToolPart::shank, ToolPart::holder};

}  // namespace

/// Of a part with a thing: the deepest contact or the least distance, and when.
struct TurnCheck::Meeting {
  Touch touch = Touch::none;
  std::optional<TurnPlace> place;  // none of a contact that was not excluded

  /// Whether it is worse than what was before: of equal ones the first stays.
  bool worse_than(const Meeting& other) const {
    if (touch != other.touch) return touch > other.touch;
    if (!place || !other.place) return place && !other.place;
    return touch == Touch::none ? place->mm < other.place->mm : place->mm > other.place->mm;
  }
};

/// Of a part's turn among a thing.
struct TurnCheck::Stretch {
  std::size_t obstacle = 0, body = 0;
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
}

const TurningPose& TurnCheck::pose_in(const TurningTool& motion, std::size_t obstacle) {
  return obstacle == 0 ? motion.in_stock : motion.in_fixtures[obstacle - 1];
}

std::vector<TurnCheck::Stretch> TurnCheck::stretches(const TurningTool& motion) const {
  std::vector<Stretch> all;
  for (std::size_t k = 0; k < obstacles_.size(); ++k)
    for (std::size_t b = 0; b < parts_.size(); ++b)
      all.push_back({k, b, {&obstacles_[k].solid, &parts_[b], &pose_in(motion, k)}, near_miss_mm_});
  return all;
}

/// The first look is only sure of what is half as deep again as its tolerance.
TurnCheck::Meeting TurnCheck::contact(const Stretch& stretch,
                                      const model::RunControl& control) const {
  TurnSearch search = stretch.search;
  const TurnAnswer sure = deepest_turn_contact(search, tolerance_mm_, control);
  if (sure.place || !sure.proven) return {Touch::contact, sure.place};
  search.most_looks = kMostSlightLooks;
  const TurnAnswer slight = deepest_turn_contact(search, tolerance_mm_ / 10, control);
  if (!slight.place) return {};
  return {slight.place->mm > tolerance_mm_ ? Touch::contact : Touch::slight, slight.place};
}

TurnCheck::Meeting TurnCheck::gap(const Stretch& stretch, const model::RunControl& control) const {
  TurnSearch search = stretch.search;
  search.most_looks = kMostSlightLooks;
  return {Touch::none, least_turn_gap(search, stretch.near_mm, tolerance_mm_, control).place};
}

/// What is left at one time, no less than that; where nothing is near, as much as counts.
double TurnCheck::gap_at(const Stretch& stretch, double t, const model::RunControl& control) const {
  const Meeting there = gap(stretch.between(t, t), control);
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
std::vector<TurnCheck::Meeting> TurnCheck::worst_of(const std::vector<Stretch>& stretches,
                                                    const Look& look,
                                                    const model::RunControl& control) const {
  std::vector<Meeting> found(stretches.size());
  model::parallel_chunks(found.size(), 1, control,
                         [&](std::size_t i, std::size_t) { found[i] = look(stretches[i]); });
  std::vector<Meeting> worst(obstacles_.size() * kToolParts.size());
  for (std::size_t i = 0; i < found.size(); ++i) {
    const auto part = static_cast<std::size_t>(parts_[stretches[i].body].part);
    Meeting& known = worst[stretches[i].obstacle * kToolParts.size() + part];
    if (found[i].worse_than(known)) known = found[i];
  }
  return worst;
}

FindingKind TurnCheck::contact_kind(std::size_t pair, bool rapid) const {
  if (!obstacles_[pair / kToolParts.size()].is_stock) return FindingKind::fixture_touched;
  switch (kToolParts[pair % kToolParts.size()]) {
    case ToolPart::shank:
      return FindingKind::shank_in_stock;
    case ToolPart::holder:
      return FindingKind::holder_in_stock;
    case ToolPart::cutter:
      break;
  }
  return rapid ? FindingKind::rapid_through_stock : FindingKind::cut_while_turning;
}

/// A place of a fixture goes by the tool into the stock's frame as that stands then.
Finding TurnCheck::finding(FindingKind kind, const TurningTool& motion, const Meeting& meeting,
                           std::size_t pair) const {
  const std::size_t k = pair / kToolParts.size();
  const double t = meeting.place ? meeting.place->t : 0.5;
  Finding f{kind,
            0,
            motion.line,
            motion.in_stock.at(t).shift_mm,
            0,
            name(kToolParts[pair % kToolParts.size()]),
            obstacles_[k].name};
  if (!meeting.place) return f;
  f.depth_mm = kind == FindingKind::near_miss ? -meeting.place->mm : meeting.place->mm;
  f.point =
      obstacles_[k].is_stock
          ? meeting.place->point
          : motion.in_stock.at(t).point(pose_in(motion, k).at(t).point_back(meeting.place->point));
  return f;
}

std::vector<Finding> TurnCheck::look_at(const TurningTool& motion,
                                        const model::RunControl& control) const {
  if (motion.in_fixtures.size() + 1 != obstacles_.size())
    throw std::invalid_argument("a turn has a pose for each fixture");
  for (std::size_t k = 0; k < obstacles_.size(); ++k) require_bounds(pose_in(motion, k));
  std::vector<Stretch> all;
  for (const Stretch& whole : stretches(motion)) whole.add_parts(all);
  const std::vector<Meeting> worst = worst_of(
      all, [&](const Stretch& s) { return contact(s, control); }, control);
  std::vector<Touch> touched(obstacles_.size(), Touch::none);
  for (std::size_t pair = 0; pair < worst.size(); ++pair) {
    Touch& touch = touched[pair / kToolParts.size()];
    touch = std::max(touch, worst[pair].touch);
  }
  all = near_miss_mm_ > 0 ? near_stretches(motion, touched, control) : std::vector<Stretch>();
  const std::vector<Meeting> nearest = worst_of(
      all, [&](const Stretch& s) { return gap(s, control); }, control);
  std::vector<Finding> findings;
  for (std::size_t pair = 0; pair < worst.size(); ++pair) {
    const Touch touch = touched[pair / kToolParts.size()];
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
