#include "verifier/cells/cell_bounds.h"

#include <algorithm>
#include <cmath>

#include "model/geometry/interval.h"
#include "verifier/tolerance.h"

namespace limitgauge::verifier {
namespace {

using model::Vec3;
using Values = CellValues;

constexpr int kLineSearches = 6;
/// First piece of a prism that is looked at, whatever the cell, mm: fifteen twice as long each
/// reach through any part.
constexpr double kShortestPiece_mm = 1e-3;
/// An edge counts as sharp where its rounding is below so many radii of the cell.
constexpr double kSharp = 8;
/// Bodies whose values at the control points are compared when the upper bound is improved.
constexpr std::size_t kMixed = 24;

/// Extremes of the plane value + g·(P_k − m) over the control points.
model::Interval plane_range(const Bezier& cell, const Vec3& m, const BodyDistance& d) {
  return control_range(cell, d.value - dot(d.gradient, m), d.gradient);
}

std::array<Vec3, 16> controls(const Bezier& cell) {
  std::array<Vec3, 16> out;
  for (int k = 0; k < 16; ++k) out[k] = cell.control(k);
  return out;
}

double largest(const Values& v) {
  return *std::max_element(v.begin(), v.end());
}
double least(const Values& v) {
  return *std::min_element(v.begin(), v.end());
}

/// Moves `a` to the point of the segment from `a` to `b` whose largest entry is least: the upper
/// envelope of as many lines, walked from corner to corner.
void mix(Values& a, const Values& b) {
  double at = 0;
  std::size_t top = std::max_element(a.begin(), a.end()) - a.begin();
  for (std::size_t corner = 0; corner < a.count; ++corner) {
    const double slope = b.at[top] - a.at[top];
    if (slope >= 0) break;
    double next = 1;
    std::size_t over = top;
    for (std::size_t k = 0; k < a.count; ++k) {
      const double steeper = (b.at[k] - a.at[k]) - slope;
      if (steeper <= 0) continue;
      const double crossing = (a.at[top] - a.at[k]) / steeper;
      if (crossing >= at && crossing < next) next = crossing, over = k;
    }
    at = next;
    if (over == top) break;
    top = over;
  }
  for (std::size_t k = 0; k < a.count; ++k) a.at[k] += at * (b.at[k] - a.at[k]);
}

/// Of a box about zero, those that differ.
std::vector<Vec3> corners_of(const Vec3& half) {
  std::vector<Vec3> out{{}};
  for (int axis = 0; axis < 2; ++axis) {
    if (half[axis] == 0) continue;
    const std::size_t count = out.size();
    for (std::size_t k = 0; k < count; ++k) {
      Vec3 low = out[k];
      low[axis] = -half[axis], out[k][axis] = half[axis];
      out.push_back(low);
    }
  }
  return out;
}

}  // namespace

CellBounder::CellBounder(const RemovedSpace& space, std::shared_ptr<FarPasses> far)
    : space_(space),
      far_(std::move(far)),
      corners_(corners_of(space.sway())),
      sway_mm_(length(space.sway())) {}

/// Of a body that is swept at the control points seen from every corner; the raw stock does not
/// sway.
CellValues CellBounder::values_of(const Bezier& cell, BodyRef body) const {
  CellValues out;
  std::array<double, 16> at{};
  const bool fixed = space_.is_stock(body);
  if (fixed) space_.values(body, cell, at);
  for (const Vec3& corner : corners_) {
    if (!fixed) space_.values(body, corner == Vec3{} ? cell : shifted(cell, -corner), at);
    std::copy(at.begin(), at.end(), out.end());
    out.count += at.size();
  }
  return out;
}

/// The same of the body shrunk by its error.
CellValues CellBounder::shrunk_values_of(const Bezier& cell, BodyRef body) const {
  CellValues out = values_of(cell, body);
  if (const double error = space_.error_mm(body); error != 0)
    for (double& value : out) value += error;
  return out;
}

/// A lower bound on a cell, by a plane of that slope, for every shift and error.
double CellBounder::lowered(BodyRef body, double lower, const Vec3& gradient) const {
  if (space_.is_stock(body)) return lower;
  return lower - space_.swayed_by_mm(gradient) - space_.error_mm(body);
}

/// The same by the plane where the cell's middle lies deepest in the body, but for its bend.
double CellBounder::corner_lower(const Bezier& cell, const Vec3& middle, BodyRef body,
                                 const Vec3& gradient) const {
  const Vec3 corner{std::copysign(space_.sway().x, gradient.x),
                    std::copysign(space_.sway().y, gradient.y), 0};
  const BodyDistance d = space_.distance(body, middle - corner);
  return plane_range(cell, middle, d).low - d.slack_mm + dot(d.gradient, corner) -
         space_.swayed_by_mm(d.gradient) - space_.error_mm(body);
}

/// A lower bound that is `enough_mm` need not be better.
CellBounder::Scored CellBounder::score(const Bezier& cell, const Vec3& middle, BodyRef body,
                                       BodyDistance& distance, double enough_mm) const {
  // A plane of a turning body is none under its distance: a bound that may be good enough is all
  // that is asked of it then.
  const bool turns = space_.turns(body);
  if (!turns || !std::isfinite(enough_mm)) distance = space_.distance(body, middle);
  if (turns) {
    const double error = space_.error_mm(body);
    const double lower = space_.lower(body, controls(cell), middle, enough_mm + error);
    return {body, distance.value, lower - error, 0};
  }
  if (const MeshOutside* mesh = space_.mesh_of(body))
    return {body, distance.value, mesh->lower(cell, middle, distance), 0};
  if (!space_.is_concave(body)) {
    const double plane = plane_range(cell, middle, distance).low - distance.slack_mm;
    return {body, distance.value, lowered(body, plane, distance.gradient), 0};
  }
  return {body, distance.value, least(values_of(cell, body)),
          plane_range(cell, middle, distance).high};
}

double CellBounder::upper_of(const Bezier& cell, const Vec3& middle, BodyRef body) {
  if (const MeshOutside* mesh = space_.mesh_of(body))
    return mesh->upper(cell, middle, space_.distance(body, middle));
  if (space_.is_concave(body)) {
    BodyDistance distance;
    return score(cell, middle, body, distance).upper;
  }
  return largest(shrunk_values_of(cell, body));
}

void CellBounder::find_candidates(const Bezier& cell, std::vector<BodyRef>& candidates,
                                  std::optional<BodyRef> hint, double limit_mm) {
  const Vec3 centre = middle(cell);
  candidates.clear();
  // d_i changes by at most the radius within the cell; and a body that is grown may be nearer than
  // one of the stock, which is not.
  const double radius =
      control_radius(cell, centre) + kDistanceRounding_mm + space_.chord_error_mm();
  const Nearest nearest = space_.nearest(centre, hint, far_.get());
  if (nearest.distance.value > limit_mm + radius) return;
  const double upper = upper_of(cell, centre, nearest.body);
  space_.within(centre, std::min(upper, limit_mm) + radius, candidates, far_.get());
}

double CellBounder::improve_upper(const Bezier& cell, double upper, double low_enough) {
  const std::size_t count = std::min(kMixed, scored_.size());
  std::partial_sort(scored_.begin(), scored_.begin() + static_cast<std::ptrdiff_t>(count),
                    scored_.end(), [](const Scored& a, const Scored& b) {
                      return a.value != b.value ? a.value < b.value : a.body < b.body;
                    });
  values_.clear();
  for (std::size_t i = 0; i < count; ++i)
    if (!space_.is_concave(scored_[i].body))
      values_.push_back(shrunk_values_of(cell, scored_[i].body));
  if (values_.size() < 2) return upper;
  const auto first =
      std::min_element(values_.begin(), values_.end(),
                       [](const Values& a, const Values& b) { return largest(a) < largest(b); });
  Values mean = *first;
  double best = largest(mean);
  for (int step = 0; step < kLineSearches && best > low_enough; ++step) {
    const std::size_t worst = std::max_element(mean.begin(), mean.end()) - mean.begin();
    const auto towards = std::min_element(
        values_.begin(), values_.end(),
        [&](const Values& a, const Values& b) { return a.at[worst] < b.at[worst]; });
    mix(mean, *towards);
    const double now = largest(mean);
    const bool stuck = best - now < 1e-3 * std::abs(best - low_enough);
    best = std::min(best, now);
    if (stuck) break;
  }
  return std::min(best, upper);
}

double CellBounder::mixed_lower(const Bezier& cell, const Vec3& middle, BodyRef body) const {
  // The corners see the faces on both sides of an edge; from under S the edge itself is seen.
  const InnerChords chords = inner_chords(cell);
  const Vec3 under = middle - normalized(cross(chords.u, chords.v)) * control_radius(cell, middle);
  std::array<Vec3, 10> points = {
      middle, under, cell.control(0), cell.control(3), cell.control(12), cell.control(15)};
  std::size_t count = 6;
  // So do the corners of the sway.
  if (corners_.size() > 1)
    for (const Vec3& corner : corners_) points[count++] = middle - corner;
  // Planes with their signs changed, so that the largest entry is to be made least, as above.
  std::array<Values, 10> planes;
  const auto end = planes.begin() + count;
  double slack_mm = 0;
  for (std::size_t n = 0; n < count; ++n) {
    const BodyDistance d = space_.distance(body, points[n]);
    slack_mm = std::max(slack_mm, d.slack_mm);
    for (const Vec3& corner : corners_)
      for (int k = 0; k < 16; ++k)
        planes[n].at[planes[n].count++] =
            -(d.value + dot(d.gradient, cell.control(k) - corner - points[n]));
  }
  Values mean = *std::min_element(planes.begin(), end, [](const Values& a, const Values& b) {
    return largest(a) < largest(b);
  });
  for (int step = 0; step < kLineSearches; ++step) {
    const std::size_t worst = std::max_element(mean.begin(), mean.end()) - mean.begin();
    mix(mean, *std::min_element(planes.begin(), end, [&](const Values& a, const Values& b) {
          return a.at[worst] < b.at[worst];
        }));
  }
  return -largest(mean) - slack_mm - space_.error_mm(body);
}

bool CellBounder::sharp(BodyRef body, double radius_mm) const {
  return !space_.is_stock(body) && !space_.turns(body) &&
         space_.rounding_mm(body) < kSharp * radius_mm;
}

bool CellBounder::surely_outside(const Bezier& cell, double margin_mm,
                                 std::optional<BodyRef> first) {
  const Vec3 centre = middle(cell);
  const double radius = control_radius(cell, centre);
  const bool sways = corners_.size() > 1;
  const auto clear = [&](BodyRef body) {
    BodyDistance distance;
    double lower = score(cell, centre, body, distance, margin_mm).lower;
    if (lower >= margin_mm) return true;
    if (sways && !space_.is_stock(body))
      lower = std::max(lower, corner_lower(cell, centre, body, distance.gradient));
    if (lower >= margin_mm) return true;
    const bool by_edge = sharp(body, radius);
    const bool unsure = by_edge || space_.mesh_of(body);
    missed_by_mm_ = unsure ? 0 : margin_mm - lower, in_the_way_ = body;
    // Of a turning body nothing better is looked for where the middle itself is too near.
    if (space_.turns(body))
      if (const double here = space_.distance(body, centre).value - space_.error_mm(body);
          here < margin_mm)
        missed_by_mm_ = margin_mm - here;
    return by_edge && mixed_lower(cell, centre, body) >= margin_mm;
  };
  if (first && !clear(*first)) return false;
  near_.clear();
  space_.within(control_box(cell), margin_mm + sway_mm_ + space_.chord_error_mm(), near_,
                far_.get());
  return std::all_of(near_.begin(), near_.end(), clear);
}

bool CellBounder::surely_unswept(const Bezier& cell, const Vec3& prism, double margin_mm,
                                 double margin_per_mm) {
  // Piece by piece, each twice as long as the one before: what lies beside the cell is near to
  // short ones only, and what swept any of it did so near its beginning, most often.
  const double whole = length(prism);
  double from = 0, piece = std::max(control_radius(cell, middle(cell)), kShortestPiece_mm);
  while (from < whole) {
    const double to = std::min(whole, from + piece);
    if (!piece_unswept(shifted(cell, prism * (from / whole)), prism * ((to - from) / whole),
                       margin_mm + margin_per_mm * to))
      return false;
    from = to, piece *= 2;
  }
  return true;
}

/// The same of one body that turns as it goes.
bool CellBounder::turning_unswept(const Bezier& cell, const Vec3& prism, double margin_mm,
                                  BodyRef body) const {
  std::array<Vec3, 32> ends;
  for (int k = 0; k < 16; ++k) ends[k] = cell.control(k), ends[16 + k] = cell.control(k) + prism;
  const double wanted = margin_mm + space_.error_mm(body);
  return space_.lower(body, ends, middle(cell) + prism / 2, wanted) >= wanted;
}

bool CellBounder::piece_unswept(const Bezier& cell, const Vec3& prism, double margin_mm) {
  const Vec3 centre = middle(cell) + prism / 2;
  model::Box3 box = control_box(cell);
  const model::Box3 end{box.low + prism, box.high + prism};
  box.add(end.low), box.add(end.high);
  near_.clear();
  space_.within(box, margin_mm + sway_mm_ + space_.chord_error_mm(), near_, far_.get());
  return std::all_of(near_.begin(), near_.end(), [&](BodyRef body) {
    if (space_.is_stock(body)) return true;
    if (space_.turns(body)) return turning_unswept(cell, prism, margin_mm, body);
    const BodyDistance d = space_.distance(body, centre);
    // Convex hull of both ends: the plane is least at a control point of one of them.
    const double along = std::min(0.0, dot(d.gradient, prism));
    const double lower = plane_range(cell, centre, d).low + along - d.slack_mm;
    return lowered(body, lower, d.gradient) >= margin_mm;
  });
}

bool CellBounder::surely_inside(const Bezier& cell, double margin_mm, BodyRef first) {
  const Vec3 centre = middle(cell);
  const double radius = control_radius(cell, centre);
  const double precision = turning_precision_mm(radius);
  const auto shrunk = [&](BodyRef body) {
    return space_.distance(body, centre, precision).value + space_.error_mm(body);
  };
  const double lowest = shrunk(first);
  if (lowest > -margin_mm) return false;
  if (upper_of(cell, centre, first) <= -margin_mm) return true;
  // A mean that gives a body a tenth or more is low enough at the middle only if that body is.
  constexpr double kLeastWeight = 0.1;
  const double room = -margin_mm - lowest;
  near_.clear();
  space_.within(centre, std::min(radius + sway_mm_ - margin_mm, lowest + room / kLeastWeight),
                near_, far_.get());
  if (near_.size() < 2) return false;
  scored_.clear();
  for (const BodyRef body : near_)
    if (!space_.is_concave(body)) scored_.push_back({body, shrunk(body)});
  return improve_upper(cell, std::numeric_limits<double>::infinity(), -margin_mm) <= -margin_mm;
}

CellBounds CellBounder::bound(const Bezier& cell, std::vector<BodyRef>& candidates,
                              double low_enough, double high_enough) {
  CellBounds out;
  out.middle = middle(cell);
  scored_.clear();
  out.nearest.distance.value = std::numeric_limits<double>::infinity();
  for (const BodyRef body : candidates) {
    BodyDistance distance;
    scored_.push_back(score(cell, out.middle, body, distance));
    if (distance.value < out.nearest.distance.value) out.nearest = {body, distance};
  }
  out.upper = upper_of(cell, out.middle, out.nearest.body);
  const auto drop = [&] {
    std::erase_if(scored_,
                  [&](const Scored& s) { return s.lower > out.upper + kDistanceRounding_mm; });
  };
  drop();
  if (out.upper > low_enough) {
    out.upper = improve_upper(cell, out.upper, low_enough);
    drop();
  }
  out.lower = std::numeric_limits<double>::infinity();
  candidates.clear();
  const double radius = control_radius(cell, out.middle);
  for (Scored& s : scored_) {
    if (s.lower < high_enough && sharp(s.body, radius))
      s.lower = std::max(s.lower, mixed_lower(cell, out.middle, s.body));
    out.lower = std::min(out.lower, s.lower);
    candidates.push_back(s.body);
  }
  return out;
}

}  // namespace limitgauge::verifier
