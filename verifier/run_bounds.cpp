#include "verifier/run_bounds.h"

#include <algorithm>
#include <cmath>

namespace limitgauge::verifier {
namespace {

using model::Vec3;

Bezier shifted(Bezier cell, const Vec3& by) {
  for (int k = 0; k < 16; ++k) cell.x[k] += by.x, cell.y[k] += by.y, cell.z[k] += by.z;
  return cell;
}

}  // namespace

RunBounds::RunBounds(const SurfaceCells& cells, const RemovedSpace& space, Side side,
                     double allowance_mm)
    : space_(space),
      tracer_(cells, space),
      bounder_(space),
      side_(side),
      allowance_mm_(side == Side::missing_stock ? 0 : allowance_mm) {
  model::Box3 box = space.stock_box().value_or(model::Box3{});
  if (!cells.nodes().empty())
    box.add(cells.nodes().front().box.low), box.add(cells.nodes().front().box.high);
  longest_mm_ = length(box.size()) + std::abs(allowance_mm_) + 1;
}

bool RunBounds::surely_within(const OffsetCell& cell, double length_mm) {
  if (length_mm >= longest_mm_) return true;
  if (side_ == Side::uncut) return is_gone(cell, allowance_mm_ + length_mm);
  if (stands(cell, allowance_mm_ - length_mm)) return true;
  return side_ == Side::gouge && surely_unswept(cell, length_mm);
}

/// By how much a place has to be beyond a face for all of a cell moved by t to be beyond it.
double RunBounds::margin_mm(const OffsetCell& cell, double t_mm) const {
  return std::abs(t_mm) * cell.remainder + space_.chord_error_mm();
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
  if (at.distance.value <= -margin && bounder_.surely_inside(cell.moved(t_mm), margin, at.body))
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

/// Whether the cell moved by t stands, all of it, or what is beside it by next to nothing: of one
/// face, or of those that meet in an edge.
bool RunBounds::stands(const OffsetCell& cell, double t_mm) {
  constexpr int kMostFaces = 3;
  const double margin = margin_mm(cell, t_mm) + kSkin_mm;
  const Vec3 middle = cell.moved_middle(t_mm);
  Nearest at = look(middle);
  if (at.distance.value >= margin && bounder_.surely_outside(cell.moved(t_mm), margin, at.body))
    return true;
  Vec3 shift;
  for (int face = 0; face < kMostFaces && is_beside(cell, at); ++face) {
    shift += at.distance.gradient * kBeside_mm;
    at = space_.nearest(middle + shift, at.body);
    if (at.distance.value >= margin &&
        bounder_.surely_outside(shifted(cell.moved(t_mm), shift), margin, at.body))
      return true;
  }
  return false;
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
    const double margin = margin_mm(cell, std::abs(top) + down) + down * turning - kSkin_mm;
    return bounder_.surely_unswept(moved, cell.normal * -down, margin);
  };
  // Most often nothing swept anything there at all.
  if (unswept(longest_mm_)) return true;
  const double free = tracer_.free_length_mm(from, -cell.normal, longest_mm_) + 2 * radius;
  return free < longest_mm_ && stands(cell, top - free) && unswept(free);
}

bool RunBounds::ends_within(const OffsetCell& cell, double length_mm) {
  const double t = side_ == Side::uncut ? allowance_mm_ + length_mm : allowance_mm_ - length_mm;
  const Nearest at = look(cell.moved_middle(t));
  const double error = space_.chord_error_mm();
  return side_ == Side::uncut ? at.distance.value <= -error : at.distance.value >= error;
}

bool RunBounds::surely_within_thin(const OffsetCell& cell, const TracedRun& run, double length_mm) {
  const double run_mm = run.length_mm;
  if (run_mm >= length_mm) return false;
  // Where the run ends, or what ends it is beside it.
  const double past = run_mm + kStepOver_mm;
  if (side_ != Side::uncut) return stands(cell, allowance_mm_ - past);
  if (is_gone(cell, allowance_mm_ + past)) return true;
  const double from = allowance_mm_ + run_mm;
  if (run.body && is_gone_deepest(cell, *run.body, from, allowance_mm_ + length_mm)) return true;
  const double limit = length_mm - run_mm;
  const double free = tracer_.free_length_mm(cell.moved_middle(from), cell.normal, limit);
  if (free >= limit || free <= kSkin_mm) return false;
  return surely_within(cell, run_mm + free / 2);
}

TracedRun RunBounds::run(const Vec3& s, const Vec3& n, double least_mm) const {
  if (n == Vec3{}) return {};
  if (side_ == Side::uncut) return tracer_.material(s, n, allowance_mm_, longest_mm_, least_mm);
  return tracer_.removed(s, n, allowance_mm_, longest_mm_, least_mm, side_ == Side::missing_stock);
}

double RunBounds::quick_run(const Vec3& s, const Vec3& n, std::optional<BodyRef>& hint) const {
  const Nearest at = space_.nearest(s + n * allowance_mm_, hint);
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
    looked_ = {p, space_.nearest(p, looked_ ? std::optional(looked_->second.body) : std::nullopt)};
  return looked_->second;
}

}  // namespace limitgauge::verifier
