#include "engine/strategy/linking/least_links.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>

#include "engine/strategy/linking/link_fan.h"
#include "engine/tolerance.h"

namespace limitgauge::engine::strategy {
namespace {

/// How much steeper than 45 degrees a flat piece may get before it ends, and the other way round.
constexpr double kSteadiness = 1.3;

/// Walks through the tunnel round a function: `points` ascend in s.
class Tunnel {
 public:
  Tunnel(const std::vector<PlanePoint>& points, double error_mm)
      : points_(points), error_mm_(error_mm) {}

  std::vector<PlanePoint> shortest() {
    std::vector<PlanePoint> vertices = {points_.front()};
    LinkFan fan;
    fan.add_upper(points_.front());
    fan.add_lower(points_.front());
    std::size_t k = 1;
    for (; k < points_.size(); ++k) {
      if (const auto turn = fan.misses(upper(k), lower(k))) {
        vertices_of_last_link(fan, *turn, k, vertices);
        fan = next_fan(*turn, k);
      }
      fan.add_upper(upper(k));
      fan.add_lower(lower(k));
    }
    if (window_) vertices.push_back(bend(window_->line, fan.middle()));
    vertices.push_back(points_.back());
    return vertices;
  }

 private:
  /// The part of a finished link from which the next one sets out.
  struct Window {
    Line line;
    double from = 0, to = 0;
  };

  /// Ends are kept as they are.
  double slack(std::size_t k) const { return k == 0 || k + 1 == points_.size() ? 0 : error_mm_; }
  PlanePoint upper(std::size_t k) const { return {points_[k].s, points_[k].z + slack(k)}; }
  PlanePoint lower(std::size_t k) const { return {points_[k].s, points_[k].z - slack(k)}; }

  PlanePoint bend(const Line& before, const Line& after) const {
    const double turn = after.slope - before.slope;
    double s = window_->from;
    if (turn != 0) s = before.at.s + (after.height(before.at.s) - before.at.z) / -turn;
    s = std::clamp(s, window_->from, window_->to);
    return {s, before.height(s)};
  }

  /// Where the last link's line leaves the tunnel before point k.
  double leaves_at(const Line& line, bool upwards, std::size_t k) const {
    const PlanePoint a = upwards ? lower(k - 1) : upper(k - 1), b = upwards ? lower(k) : upper(k);
    const double da = line.height(a.s) - a.z, db = line.height(b.s) - b.z;
    return da == db ? a.s : a.s + (b.s - a.s) * std::clamp(da / (da - db), 0.0, 1.0);
  }

  void vertices_of_last_link(const LinkFan& fan, LinkFan::Turn turn, std::size_t k,
                             std::vector<PlanePoint>& vertices) {
    const bool upwards = turn == LinkFan::Turn::up;
    const Line line = upwards ? fan.steepest() : fan.least();
    if (window_) vertices.push_back(bend(window_->line, line));
    window_ = Window{line, fan.last_touch(turn).s, leaves_at(line, upwards, k)};
  }

  /// Links that set out from the window and turn: what turns up keeps below the upper wall from the
  /// window's begin on, and above the lower one from the window's end on. The rest of both walls is
  /// the last link's affair, or lies beyond it.
  LinkFan next_fan(LinkFan::Turn turn, std::size_t k) const {
    LinkFan fan;
    const PlanePoint begin{window_->from, window_->line.height(window_->from)};
    const PlanePoint end{window_->to, window_->line.height(window_->to)};
    const auto after = std::upper_bound(points_.begin(), points_.end(), begin.s,
                                        [](double s, const PlanePoint& p) { return s < p.s; });
    const bool up = turn == LinkFan::Turn::up;
    up ? fan.add_upper(begin) : fan.add_lower(begin);
    for (auto j = static_cast<std::size_t>(after - points_.begin()); j < k; ++j)
      up ? fan.add_upper(upper(j)) : fan.add_lower(lower(j));
    up ? fan.add_lower(end) : fan.add_upper(end);
    return fan;
  }

  const std::vector<PlanePoint>& points_;
  double error_mm_;
  std::optional<Window> window_;
};

enum class Slope { flat, up, down };

Slope slope_of(const PlanePoint& a, const PlanePoint& b, Slope before) {
  const double ds = b.s - a.s, dz = b.z - a.z;
  const double limit = before == Slope::flat ? kSteadiness * ds : ds / kSteadiness;
  if (std::abs(dz) <= limit) return Slope::flat;
  return dz > 0 ? Slope::up : Slope::down;
}

/// Exchanges s and z, so that the steep way goes on in ascending s; undone by itself.
PlanePoint turned(const PlanePoint& p, Slope slope) {
  if (slope == Slope::flat) return p;
  return slope == Slope::up ? PlanePoint{p.z, p.s} : PlanePoint{-p.z, -p.s};
}

void append_links(const std::vector<PlanePoint>& piece, Slope slope, double error_mm,
                  std::vector<PlanePoint>& result) {
  std::vector<PlanePoint> points;
  for (const PlanePoint& p : piece) points.push_back(turned(p, slope));
  const std::vector<PlanePoint> links = Tunnel(points, error_mm).shortest();
  for (std::size_t i = 1; i < links.size(); ++i) result.push_back(turned(links[i], slope));
}

/// The line without points that are the one before but for rounding, as sections leave them where
/// two triangles meet: what they bound has no width, and a link through both may be upright. The
/// ends are kept as they are.
std::vector<PlanePoint> without_repeats(const std::vector<PlanePoint>& line) {
  const auto same = [](const PlanePoint& a, const PlanePoint& b) {
    return std::hypot(b.s - a.s, b.z - a.z) <= kSamePlace_mm;
  };
  std::vector<PlanePoint> kept = {line.front()};
  for (const PlanePoint& p : line)
    if (!same(kept.back(), p)) kept.push_back(p);
  while (kept.size() > 1 && same(kept.back(), line.back())) kept.pop_back();
  kept.push_back(line.back());
  return kept;
}

}  // namespace

std::vector<PlanePoint> least_links(const std::vector<PlanePoint>& all, double error_mm) {
  if (all.size() < 3) return all;
  const std::vector<PlanePoint> line = without_repeats(all);
  std::vector<PlanePoint> result = {line.front()}, piece = {line.front()};
  Slope slope = slope_of(line[0], line[1], Slope::flat);
  for (std::size_t i = 1; i < line.size(); ++i) {
    const Slope here = slope_of(line[i - 1], line[i], slope);
    if (here != slope) {
      append_links(piece, slope, error_mm, result);
      piece = {line[i - 1]};
      slope = here;
    }
    piece.push_back(line[i]);
  }
  append_links(piece, slope, error_mm, result);
  return result;
}

}  // namespace limitgauge::engine::strategy
