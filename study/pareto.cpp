#include "study/pareto.h"

#include <algorithm>

namespace limitgauge::study {
namespace {

using Point = std::vector<double>;

bool at_most(const Point& a, const Point& b) {
  for (std::size_t i = 0; i < a.size(); ++i)
    if (a[i] > b[i]) return false;
  return true;
}

/// What was found so far, asked for points in rising order: none of them can dominate an earlier.
class Staircase {
 public:
  bool dominates(const Point& point) const {
    if (kept_.empty()) return false;
    // Of two coordinates the last kept has the least second one.
    if (point.size() <= 2) return at_most(*kept_.back(), point);
    // Neighbours in order are the likeliest to beat it.
    return std::any_of(kept_.rbegin(), kept_.rend(),
                       [&](const Point* kept) { return at_most(*kept, point); });
  }
  void keep(const Point& point) { kept_.push_back(&point); }

 private:
  std::vector<const Point*> kept_;
};

}  // namespace

std::vector<std::size_t> pareto_front(const std::vector<Point>& points) {
  std::vector<std::size_t> order(points.size());
  for (std::size_t i = 0; i < order.size(); ++i) order[i] = i;
  std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    return points[a] != points[b] ? points[a] < points[b] : a < b;
  });
  std::vector<std::size_t> front;
  Staircase staircase;
  for (const std::size_t i : order) {
    const bool alike = !front.empty() && points[front.back()] == points[i];
    if (!alike && staircase.dominates(points[i])) continue;
    if (!alike) staircase.keep(points[i]);
    front.push_back(i);
  }
  return front;
}

}  // namespace limitgauge::study
