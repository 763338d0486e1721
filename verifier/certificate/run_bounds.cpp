#include "verifier/certificate/run_bounds.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "verifier/cells/surface_crossing.h"

namespace limitgauge::verifier {
namespace {

using model::Vec3;

/// Faces that meet in a corner.
constexpr int kMostFaces = 3;
/// As far as a cell is moved beside itself at most.
constexpr double kReach_mm = kMostFaces * kBeside_mm;
/// The control points at the corners of a cell.
constexpr std::array kCorners = {0, 3, 12, 15};
/// Deeper in a body than this, no face of it is beside a corner.
constexpr double kDeep_mm = 2 * kBeside_mm;

/// Whether half a micrometre is much to a cell: what is wider is halved first.
bool is_narrow(const OffsetCell& cell) {
  constexpr double kNarrow_mm = 8 * kBeside_mm;
  return std::min(extent_u(cell.shape), extent_v(cell.shape)) <= kNarrow_mm;
}

/// Unit vectors across the sides of a cell, and between them.
std::array<Vec3, 8> ways_along(const OffsetCell& cell) {
  const auto corner = [&](int k) { return cell.shape.control(k); };
  const Vec3 u = normalized(corner(3) + corner(15) - corner(0) - corner(12)),
             v = normalized(corner(12) + corner(15) - corner(0) - corner(3));
  return {
      v, -u, -v, u, normalized(u + v), normalized(u - v), normalized(v - u), normalized(-u - v)};
}

OffsetCell beside(OffsetCell cell, const Vec3& way) {
  cell.shape = shifted(cell.shape, way * kBeside_mm), cell.middle += way * kBeside_mm;
  return cell;
}

}  // namespace

RunBounds::RunBounds(const SurfaceCells& cells, const RemovedSpace& space, Side side,
                     double allowance_mm, const Draws* draws, std::shared_ptr<FarPasses> far)
    : cells_(cells),
      space_(space),
      draws_(draws),
      far_(far ? std::move(far) : std::make_shared<FarPasses>()),
      tracer_(cells, space, far_),
      bounder_(space, far_),
      side_(side),
      allowance_mm_(side == Side::missing_stock ? 0 : allowance_mm) {
  model::Box3 box = space.stock_box().value_or(model::Box3{});
  if (!cells.nodes().empty())
    box.add(cells.nodes().front().box.low), box.add(cells.nodes().front().box.high);
  longest_mm_ = length(box.size()) + std::abs(allowance_mm_) + 1;
}

bool RunBounds::surely_within(const OffsetCell& cell, double length_mm) {
  if (length_mm >= longest_mm_) return true;
  if (side_ == Side::uncut)
    return is_gone(cell, allowance_mm_ + length_mm) || surely_crosses(cell, length_mm);
  if (stands(cell, allowance_mm_ - length_mm)) return true;
  if (side_ == Side::gouge && surely_unswept(cell, length_mm)) return true;
  return is_wedge_beside(cell, length_mm) || surely_crosses(cell, length_mm);
}

/// Whether S itself ends the runs of the cell, all of them, or those beside it by next to nothing:
/// as behind a sharp edge of less than a right angle, across a slot or through a fin.
bool RunBounds::surely_crosses(const OffsetCell& cell, double length_mm) const {
  // The far side may lie aslant of the cell's runs: it is met within as much as the cell is wide.
  constexpr double kWidest = 4;
  if (allowance_mm_ < 0 || control_radius(cell.shape, cell.middle) > kWidest * length_mm)
    return false;
  // Where runs begin on s itself, the segments look past it by no more than a skin.
  const bool is_uncut = side_ == Side::uncut;
  const Way way_on = is_uncut ? Way::outwards : Way::inwards;
  const double far = is_uncut ? allowance_mm_ + length_mm : allowance_mm_ - length_mm;
  const double from =
      allowance_mm_ > kStepOver_mm ? allowance_mm_ : (is_uncut ? -1 : 1) * kStepOver_mm;
  if (surely_crosses_surface(cells_, cell, way_on, std::min(from, far), std::max(from, far)))
    return true;
  // At the rim or a sharp edge, where the far side may end as well, as the wall of a hole does
  // opposite another. What is beside the cell need not be S, so that segments begin beyond it.
  const double beyond = is_uncut ? std::max(allowance_mm_, kStepOver_mm) : -kStepOver_mm;
  if (!is_narrow(cell) || (is_uncut ? far <= beyond : far >= beyond)) return false;
  const auto ways = ways_along(cell);
  return std::any_of(ways.begin(), ways.end(), [&](const Vec3& way) {
    return surely_crosses_surface(cells_, beside(cell, way), way_on, std::min(beyond, far),
                                  std::max(beyond, far));
  });
}

/// Whether half a micrometre beside the runs something stands no deeper than a micrometre, beside
/// all of them in one direction: the cell lies along a sharp edge of the material, or the rim of S
/// along a side of it.
bool RunBounds::is_wedge_beside(const OffsetCell& cell, double length_mm) {
  return is_narrow(cell) && std::any_of(kWedge_mm.begin(), kWedge_mm.end(), [&](double deep) {
           return deep < length_mm && stands_beside(cell, allowance_mm_ - deep, 1);
         });
}

/// By how much a place has to be beyond a face, and its error, for all of a cell moved by t to be
/// beyond it.
double RunBounds::margin_mm(const OffsetCell& cell, double t_mm) const {
  return std::abs(t_mm) * cell.remainder;
}

/// Whether a face runs along the cell's normals, so near beside the place that what is on its other
/// side may stand for it.
bool RunBounds::is_beside(const OffsetCell& cell, const Nearest& at) const {
  return std::abs(at.distance.value) <= kBeside_mm &&
         std::abs(dot(at.distance.gradient, cell.normal)) <= kAlong;
}

/// Whether the cell moved by t was removed, all of it, or what is beside it by next to nothing.
bool RunBounds::is_gone(const OffsetCell& cell, double t_mm) {
  return is_gone(cell, t_mm, look(cell.moved_middle(t_mm)));
}

/// The same by one body, and those about it.
bool RunBounds::is_gone(const OffsetCell& cell, double t_mm, const Nearest& at) {
  const double margin = margin_mm(cell, t_mm) - kSkin_mm;
  if (at.distance.value + space_.error_mm(at.body) <= -margin &&
      bounder_.surely_inside(cell.moved(t_mm), margin, at.body))
    return true;
  return is_beside(cell, at) &&
         bounder_.surely_inside(shifted(cell.moved(t_mm), at.distance.gradient * -kBeside_mm),
                                margin, at.body);
}

/// The same where the middle is deepest in the body that ends its run, between two t: its distance
/// is convex along the ray (that of the outside of a bar or a mesh is not, and any place will do).
bool RunBounds::is_gone_deepest(const OffsetCell& cell, BodyRef body, double from_t_mm,
                                double to_t_mm) {
  constexpr int kSteps = 40;
  const auto distance = [&](double t) { return space_.distance(body, cell.moved_middle(t)); };
  double low = from_t_mm, high = to_t_mm;
  for (int k = 0; k < kSteps && high - low > kSkin_mm; ++k) {
    const double third = (high - low) / 3;
    if (distance(low + third).value <= distance(high - third).value)
      high -= third;
    else
      low += third;
  }
  const double t = (low + high) / 2;
  return is_gone(cell, t, {body, distance(t)});
}

/// Whether the cell moved by t stands, all of it, or what is beside it by next to nothing.
bool RunBounds::stands(const OffsetCell& cell, double t_mm) {
  const double margin = margin_mm(cell, t_mm) + kSkin_mm;
  const Vec3 middle = cell.moved_middle(t_mm);
  const Nearest& at = look(middle);
  const double clear = at.distance.value - space_.error_mm(at.body);
  if (clear >= margin) {
    if (bounder_.surely_outside(cell.moved(t_mm), margin, at.body)) return true;
    // What misses by more than a cell is moved beside itself misses there as well.
    constexpr double kTooFar_mm = (kMostFaces + 1) * kBeside_mm;
    const double missed_mm = bounder_.missed_by_mm();
    if (missed_mm > kTooFar_mm) return false;
    const BodyRef body = bounder_.in_the_way();
    if (missed_mm > 0 && missed_mm > gain_beside_mm(cell, {body, space_.distance(body, middle)},
                                                    control_radius(cell.shape, cell.middle)))
      return false;
  } else if (margin - clear > gain_beside_mm(cell, at, 0)) {
    return false;
  }
  return stands_beside(cell, t_mm, kAlong);
}

/// Whether a body was swept by a cutter that bends little over what a cell is moved beside itself.
bool RunBounds::is_round(BodyRef body) const {
  constexpr double kRound_mm = 20 * kReach_mm;
  return !space_.is_stock(body) && space_.rounding_mm(body) >= kRound_mm;
}

/// By how much what is proven of the distance to a body may grow where a cell of that radius is
/// moved beside itself, as stands_beside() does: by what the gradient has across the normal, and by
/// the bend of what has that rounding. Infinite of what has a sharp edge.
double RunBounds::gain_beside_mm(const OffsetCell& cell, const Nearest& at,
                                 double radius_mm) const {
  if (!is_round(at.body)) return std::numeric_limits<double>::infinity();
  const Vec3& g = at.distance.gradient;
  const double across = length(g - cell.normal * dot(g, cell.normal));
  const double wide = radius_mm + length(space_.sway());
  return kReach_mm * (across + (kReach_mm + 2 * wide) / space_.rounding_mm(at.body));
}

/// Whether the cell moved by t stands where it is moved across its normals as well, away from the
/// faces that come nearest to its corners: those that run along its normals up to that sine of the
/// angle between, one face or the two or three that meet in an edge or a corner.
bool RunBounds::stands_beside(const OffsetCell& cell, double t_mm, double along) {
  constexpr double kSameWay = 0.7;
  const Nearest& middle = look(cell.moved_middle(t_mm));
  if (middle.distance.value < -kBeside_mm || is_deep(cell.moved(t_mm), middle.body)) return false;
  const double margin = margin_mm(cell, t_mm) + kSkin_mm;
  BodyRef body = middle.body;
  Bezier moved = cell.moved(t_mm);
  std::array<Vec3, kMostFaces> ways;
  for (int face = 0; face < kMostFaces; ++face) {
    const Nearest lowest = lowest_corner(moved, body);
    body = lowest.body;
    const Vec3& g = lowest.distance.gradient;
    const Vec3 way = normalized(g - cell.normal * dot(g, cell.normal));
    const auto gone = [&](const Vec3& before) { return dot(before, way) > kSameWay; };
    if (lowest.distance.value < -kDeep_mm || std::abs(dot(g, cell.normal)) > along ||
        way == Vec3{} || std::any_of(ways.begin(), ways.end(), gone))
      return false;
    ways[face] = way;
    moved = shifted(moved, way * kBeside_mm);
    if (bounder_.surely_outside(moved, margin, body)) return true;
  }
  return false;
}

/// Whether a corner of a cell lies deeper in a body than what is beside it could stand for.
bool RunBounds::is_deep(const Bezier& cell, BodyRef body) const {
  return std::any_of(kCorners.begin(), kCorners.end(), [&](int corner) {
    return space_.distance(body, cell.control(corner)).value < -kDeep_mm;
  });
}

/// δ where it is least of the corners of a cell.
Nearest RunBounds::lowest_corner(const Bezier& cell, BodyRef hint) {
  std::optional<Nearest> lowest;
  for (const int corner : kCorners) {
    const Nearest at =
        space_.nearest(cell.control(corner), lowest ? lowest->body : hint, far_.get());
    if (!lowest || at.distance.value < lowest->distance.value) lowest = at;
  }
  return *lowest;
}

/// Whether nothing swept what lies below `length_mm`, down to where something stands: what is
/// missing there was never stock.
bool RunBounds::surely_unswept(const OffsetCell& cell, double length_mm) {
  const double top = allowance_mm_ - length_mm;
  const Vec3 from = cell.moved_middle(top);
  if (!(space_.stock_distance_mm(from) < kBeside_mm)) return false;
  const Bezier moved = cell.moved(top);
  const double radius = control_radius(cell.shape, cell.middle);
  // The cell moved further is not the moved cell moved along n₀ alone: by as much as A turns it.
  const double turning =
      (length(cell.turning[0]) + length(cell.turning[1]) + length(cell.turning[2])) * radius +
      length(cell.fan);
  const auto unswept = [&](double down) {
    return bounder_.surely_unswept(moved, cell.normal * -down, margin_mm(cell, top) - kSkin_mm,
                                   cell.remainder + turning);
  };
  // Most often nothing swept anything there at all.
  if (unswept(longest_mm_)) return true;
  const double free = tracer_.free_length_mm(from, -cell.normal, longest_mm_) + 2 * radius;
  return free < longest_mm_ && stands(cell, top - free) && unswept(free);
}

bool RunBounds::ends_within(const OffsetCell& cell, double length_mm) {
  const double t = side_ == Side::uncut ? allowance_mm_ + length_mm : allowance_mm_ - length_mm;
  const Nearest at = look(cell.moved_middle(t));
  const double error = space_.error_mm(at.body) + space_.swayed_by_mm(at);
  return side_ == Side::uncut ? at.distance.value <= -error : at.distance.value >= error;
}

bool RunBounds::surely_within_thin(const OffsetCell& cell, const TracedRun& run, double length_mm) {
  const double run_mm = run.length_mm;
  if (run_mm >= length_mm) return false;
  // Where the run ends, or what ends it is beside it.
  const double past = run_mm + kStepOver_mm;
  if (side_ != Side::uncut) {
    if (stands(cell, allowance_mm_ - past)) return true;
    // Or in the middle of what stands there.
    const Vec3 end = cell.moved_middle(allowance_mm_ - past);
    const double solid =
        space_.first_met(end, -cell.normal, length_mm - run_mm, {kSkin_mm, 0, 0}, far_.get()).t_mm;
    return solid > kSkin_mm && stands(cell, allowance_mm_ - past - solid / 2);
  }
  if (is_gone(cell, allowance_mm_ + past)) return true;
  const double from = allowance_mm_ + run_mm;
  if (run.body && is_gone_deepest(cell, *run.body, from, allowance_mm_ + length_mm)) return true;
  const double limit = length_mm - run_mm;
  const double free = tracer_.free_length_mm(cell.moved_middle(from), cell.normal, limit);
  if (free >= limit || free <= kSkin_mm) return false;
  return surely_within(cell, run_mm + free / 2);
}

TracedRun RunBounds::run(const Vec3& s, const Vec3& n, double least_mm) {
  if (n == Vec3{}) return {};
  return draws_ ? drawn_run(s, n, least_mm) : run_in(tracer_, s, n, least_mm);
}

TracedRun RunBounds::run_in(const RunTracer& tracer, const Vec3& s, const Vec3& n,
                            double least_mm) const {
  if (side_ == Side::uncut) return tracer.material(s, n, allowance_mm_, longest_mm_, least_mm);
  return tracer.removed(s, n, allowance_mm_, longest_mm_, least_mm, side_ == Side::missing_stock);
}

TracedRun RunBounds::run_shifted(const Vec3& s, const Vec3& n, double x, double y,
                                 double least_mm) const {
  const RemovedSpace drawn =
      draws_->space.shifted(draws_->shift(x, y) + off_path(side_, n, draws_->path_mm));
  TracedRun run = run_in(RunTracer(cells_, drawn, nullptr), s, n, least_mm);
  run.shift_x = x, run.shift_y = y;
  return run;
}

TracedRun RunBounds::drawn_run(const Vec3& s, const Vec3& n, double least_mm) const {
  constexpr std::array<std::array<double, 2>, 5> kShares = {
      {{0, 0}, {-1, -1}, {1, -1}, {-1, 1}, {1, 1}}};
  const Vec3& half = draws_->half_mm;
  std::optional<TracedRun> longest;
  for (const auto& [x, y] : kShares) {
    // Along an axis without a range all shares are one.
    if ((half.x == 0 && x > 0) || (half.y == 0 && y > 0)) continue;
    const double least = std::max(least_mm, longest ? longest->length_mm : 0);
    const TracedRun run = run_shifted(s, n, x, y, least);
    if (!longest || run.length_mm > longest->length_mm) longest = run;
    if (half == Vec3{}) break;
  }
  return longest.value_or(TracedRun{});
}

double RunBounds::quick_run(const Vec3& s, const Vec3& n, std::optional<BodyRef>& hint) {
  const Nearest at = space_.nearest(s + n * allowance_mm_, hint, far_.get());
  hint = at.body;
  if (side_ == Side::uncut) return std::max(0.0, at.distance.value);
  if (side_ == Side::gouge && space_.is_stock(at.body)) return 0;
  return std::max(0.0, -at.distance.value);
}

Vec3 RunBounds::gradient_at(const OffsetCell& cell, double length_mm) {
  const double t = side_ == Side::uncut ? allowance_mm_ + length_mm : allowance_mm_ - length_mm;
  return look(cell.moved_middle(t)).distance.gradient;
}

/// The nearest body, remembered for the next question of the same place.
const Nearest& RunBounds::look(const Vec3& p) {
  if (!looked_ || looked_->first != p)
    looked_ = {p, space_.nearest(p, looked_ ? std::optional(looked_->second.body) : std::nullopt,
                                 far_.get())};
  return looked_->second;
}

}  // namespace limitgauge::verifier
