#include "study/pareto.h"

#include <algorithm>
#include <iterator>
#include <map>

namespace limitgauge::study {
namespace {

using Point = std::vector<double>;

bool at_most(const Point& a, const Point& b) {
  for (std::size_t i = 0; i < a.size(); ++i)
    if (a[i] > b[i]) return false;
  return true;
}

/// What was found so far, asked for points in rising order: none of them can dominate an earlier,
/// and the first coordinate of an earlier one never stands in the way.
class Found {
 public:
  bool dominates(const Point& point) const {
    if (kept_.empty()) return false;
    // Of two coordinates the last kept has the least second one.
    if (point.size() <= 2) return at_most(*kept_.back(), point);
    if (point.size() == 3) return is_over_stairs(point);
    // Neighbours in order are the likeliest to beat it.
    return std::any_of(kept_.rbegin(), kept_.rend(),
                       [&](const Point* kept) { return at_most(*kept, point); });
  }

  void keep(const Point& point) {
    kept_.push_back(&point);
    if (point.size() != 3) return;
    auto step = stairs_.insert_or_assign(point[1], point[2]).first;
    for (++step; step != stairs_.end() && step->second >= point[2];) step = stairs_.erase(step);
  }

 private:
  bool is_over_stairs(const Point& point) const {
    const auto beyond = stairs_.upper_bound(point[1]);
    return beyond != stairs_.begin() && std::prev(beyond)->second <= point[2];
  }

  std::vector<const Point*> kept_;
  /// Of three coordinates: the second with the least third up to there, which falls along it.
  std::map<double, double> stairs_;
};

}  // namespace

std::vector<std::size_t> pareto_front(const std::vector<Point>& points) {
  std::vector<std::size_t> order(points.size());
  for (std::size_t i = 0; i < order.size(); ++i) order[i] = i;
  std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    return points[a] != points[b] ? points[a] < points[b] : a < b;
  });
  std::vector<std::size_t> front;
  Found found;
  for (const std::size_t i : order) {
    const bool alike = !front.empty() && points[front.back()] == points[i];
    if (!alike && found.dominates(points[i])) continue;
    if (!alike) found.keep(points[i]);
    front.push_back(i);
  }
  return front;
}

}  // namespace limitgauge::study
