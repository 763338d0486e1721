#include "reports/compare/spot_tree.h"

#include <algorithm>

namespace limitgauge::reports::compare {

struct SpotTree::Search {
  model::Vec3 at;
  double radius;
  std::vector<Near> found;  ///< nearest first
  std::size_t visits = 0;

  double limit() const { return found.size() < kMost ? radius : found.back().distance_mm; }
  void offer(const Near& near) {
    if (near.distance_mm > radius) return;
    if (found.size() == kMost && near.distance_mm >= found.back().distance_mm) return;
    const auto place = std::upper_bound(
        found.begin(), found.end(), near,
        [](const Near& a, const Near& b) { return a.distance_mm < b.distance_mm; });
    found.insert(place, near);
    if (found.size() > kMost) found.pop_back();
  }
};

SpotTree::SpotTree(std::span<const Spot> spots, std::vector<std::size_t> members)
    : spots_(spots), order_(std::move(members)) {
  build(0, order_.size(), 0);
}

void SpotTree::build(std::size_t begin, std::size_t end, int axis) {
  if (end - begin < 2) return;
  const std::size_t middle = begin + (end - begin) / 2;
  const auto at = [this](std::size_t i) { return order_.begin() + static_cast<std::ptrdiff_t>(i); };
  std::nth_element(at(begin), at(middle), at(end), [&](std::size_t a, std::size_t b) {
    return spots_[a].at_mm[axis] < spots_[b].at_mm[axis];
  });
  build(begin, middle, (axis + 1) % 3);
  build(middle + 1, end, (axis + 1) % 3);
}

void SpotTree::visit(Search& search, std::size_t begin, std::size_t end, int axis) const {
  if (begin >= end || ++search.visits > kMostVisits) return;
  const std::size_t middle = begin + (end - begin) / 2;
  const std::size_t spot = order_[middle];
  search.offer({spot, model::distance(search.at, spots_[spot].at_mm)});
  const double beside = search.at[axis] - spots_[spot].at_mm[axis];
  const int next = (axis + 1) % 3;
  const bool is_left = beside < 0;
  is_left ? visit(search, begin, middle, next) : visit(search, middle + 1, end, next);
  if (std::abs(beside) > search.limit()) return;
  is_left ? visit(search, middle + 1, end, next) : visit(search, begin, middle, next);
}

std::vector<SpotTree::Near> SpotTree::nearest(const model::Vec3& p, double radius_mm) const {
  Search search{p, radius_mm, {}};
  visit(search, 0, order_.size(), 0);
  return std::move(search.found);
}

}  // namespace limitgauge::reports::compare
