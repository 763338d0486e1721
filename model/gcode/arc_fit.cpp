#include "model/gcode/arc_fit.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "model/base/tolerance.h"
#include "model/geometry/segment.h"
#include "model/text/fixed_number.h"

namespace limitgauge::model {
namespace {

constexpr std::size_t kFewestMoves = 3;
constexpr double kSmallestRadiusMm = 0.01;
/// The exchange below ends after a few steps, or does no better.
constexpr int kMostExchanges = 8;

/// Place of the samples of a run by how far they lie off the circle through its ends whose centre
/// is shift / 2 beside the chord: power - shift * height, about twice the radius times the
/// distance.
struct Sample {
  double power = 0, height = 0;
  double off(double shift) const { return power - shift * height; }
};

struct Extremes {
  Sample low, high;
  double worst(double shift) const {
    return std::max(std::abs(low.off(shift)), std::abs(high.off(shift)));
  }
};

}  // namespace

std::optional<FittedArc> ArcFitter::from(std::size_t first) {
  for (const ArcPlane plane : {ArcPlane::xy, ArcPlane::zx, ArcPlane::yz}) {
    const int normal = axes_of(plane)[2];
    const double level = move_from(path_, first)[normal];
    bool flat = path_.moves.size() - first >= kFewestMoves;
    for (std::size_t i = first; flat && i < first + kFewestMoves; ++i)
      flat = alike(first, i) && path_.moves[i].to[normal] == level;
    if (!flat) continue;
    if (const std::optional<FittedArc> arc = longest_in(plane, first)) return arc;
  }
  return std::nullopt;
}

bool ArcFitter::alike(std::size_t first, std::size_t move) const {
  return path_.moves[move].kind == MoveKind::feed &&
         path_.moves[move].feed_mm_min == path_.moves[first].feed_mm_min;
}

std::optional<FittedArc> ArcFitter::longest_in(ArcPlane plane, std::size_t first) {
  std::optional<FittedArc> best = fit(plane, first, kFewestMoves);
  if (!best) return best;
  const int normal = axes_of(plane)[2];
  const double level = move_from(path_, first)[normal];
  std::size_t run = kFewestMoves;  // moves that have been seen to lie in the plane
  const auto extend = [&](std::size_t wanted) {
    while (run < wanted && first + run < path_.moves.size() && alike(first, first + run) &&
           path_.moves[first + run].to[normal] == level)
      ++run;
    return run;
  };
  std::size_t beyond = 0;  // fewest moves that were tried in vain
  while (beyond == 0) {
    const std::size_t count = extend(2 * best->moves);
    if (count == best->moves) return best;
    if (const std::optional<FittedArc> arc = fit(plane, first, count))
      best = arc;
    else
      beyond = count;
  }
  while (beyond - best->moves > 1) {
    const std::size_t count = best->moves + (beyond - best->moves) / 2;
    if (const std::optional<FittedArc> arc = fit(plane, first, count))
      best = arc;
    else
      beyond = count;
  }
  return best;
}

void ArcFitter::gather(ArcPlane plane, std::size_t first, std::size_t count) {
  const auto [one, two, normal] = axes_of(plane);
  const Vec3& start = move_from(path_, first);
  points_.assign(1, Vec2{0, 0});
  for (std::size_t i = first; i < first + count; ++i) {
    const Vec3& to = path_.moves[i].to;
    points_.push_back({to[one] - start[one], to[two] - start[two]});
  }
}

std::optional<FittedArc> ArcFitter::fit(ArcPlane plane, std::size_t first, std::size_t count) {
  gather(plane, first, count);
  const std::optional<Vec2> exact = centre();
  if (!exact) return std::nullopt;
  const Vec2 offset = {fixed(exact->x, decimals_).value, fixed(exact->y, decimals_).value};
  const std::optional<bool> counter_clockwise = direction(offset);
  if (!counter_clockwise || !within(offset)) return std::nullopt;
  return FittedArc{count, plane, *counter_clockwise, offset};
}

/// Centre of a circle through the run's ends that keeps near to its points and to the middles of
/// its moves; nothing where no such circle has a fit radius.
std::optional<Vec2> ArcFitter::centre() const {
  const Vec2 end = points_.back();
  const double chord_mm = length(end);
  if (chord_mm == 0) return std::nullopt;
  const Vec2 along = end / chord_mm;
  const double beside = best_shift(along, chord_mm / 2) / 2;
  if (!(std::hypot(beside, chord_mm / 2) <= kLargestArcRadiusMm)) return std::nullopt;
  return end / 2 + beside * quarter_turn(along);
}

/// Least squares first, then the exchange of Chebyshev approximation: the two samples that are
/// farthest off on either side are brought to the same distance.
double ArcFitter::best_shift(Vec2 along, double half_chord_mm) const {
  std::vector<Sample> samples;
  samples.reserve(2 * points_.size());
  const auto add = [&](Vec2 p) {
    const double x = dot(p, along) - half_chord_mm, y = cross(along, p);
    samples.push_back({x * x + y * y - half_chord_mm * half_chord_mm, y});
  };
  double products = 0, squares = 0;
  for (std::size_t i = 1; i < points_.size(); ++i)
    add((points_[i - 1] + points_[i]) / 2), add(points_[i]);
  for (const Sample& s : samples) products += s.power * s.height, squares += s.height * s.height;
  double shift = products / squares, best = shift;
  double least = std::numeric_limits<double>::infinity();
  for (int step = 0; step < kMostExchanges; ++step) {
    const auto less = [shift](const Sample& a, const Sample& b) {
      return a.off(shift) < b.off(shift);
    };
    const auto [low, high] = std::minmax_element(samples.begin(), samples.end(), less);
    const double worst = Extremes{*low, *high}.worst(shift);
    if (!(worst < least)) break;
    least = worst, best = shift;
    shift = (low->power + high->power) / (low->height + high->height);
  }
  return best;
}

/// Counter-clockwise or not; nothing where a move turns back or by a quarter turn, where a point
/// lies beyond half a turn, or where the whole turn is next to nothing.
std::optional<bool> ArcFitter::direction(Vec2 centre) const {
  const Vec2 begin = points_.front() - centre;
  const double sign = cross(begin, points_[points_.size() / 2] - centre) < 0 ? -1 : 1;
  Vec2 last = begin;
  for (std::size_t i = 1; i < points_.size(); ++i) {
    const Vec2 here = points_[i] - centre;
    const bool onward = sign * cross(last, here) >= 0 && dot(last, here) > 0;
    if (!onward || sign * cross(begin, here) < 0) return std::nullopt;
    last = here;
  }
  const double turn = std::atan2(sign * cross(begin, last), dot(begin, last));
  if (!(turn >= kLeastTurn_rad)) return std::nullopt;
  return sign > 0;
}

bool ArcFitter::within(Vec2 centre) const {
  const double begin = length(points_.front() - centre);
  const double end = length(points_.back() - centre);
  const double small = std::min(begin, end), large = std::max(begin, end);
  if (small < kSmallestRadiusMm || large > kLargestArcRadiusMm) return false;
  if (large - small > kRadiiApartMm) return false;
  for (std::size_t i = 1; i < points_.size(); ++i) {
    const Vec2 a = points_[i - 1] - centre, b = points_[i] - centre;
    if (length(b) - small > tolerance_mm_) return false;
    if (large - distance_to_segment(Vec2{}, a, b) > tolerance_mm_) return false;
  }
  return true;
}

}  // namespace limitgauge::model
