#include "reports/compare/matching.h"

#include <algorithm>
#include <numeric>
#include <tuple>

namespace limitgauge::reports::compare {
namespace {

/// Points for the question which of them are nearest, a balanced k-d tree.
class SpotTree {
 public:
  /// `spots` must outlive it; only those of `members` are in it.
  SpotTree(std::span<const Spot> spots, std::vector<std::size_t> members);

  struct Near {
    std::size_t spot;
    double distance_mm;
  };
  /// Some of the nearest within `radius_mm`, nearest first; all of the nearest `kMost` unless that
  /// takes more than `kMostVisits` looks: no set of points makes a question dear.
  std::vector<Near> nearest(const model::Vec3& p, double radius_mm) const;

 private:
  struct Search;
  void build(std::size_t begin, std::size_t end, int axis);
  void visit(Search& search, std::size_t begin, std::size_t end, int axis) const;

  static constexpr std::size_t kMost = 8;
  static constexpr std::size_t kMostVisits = 2000;
  std::span<const Spot> spots_;
  std::vector<std::size_t> order_;  ///< the middle of each range parts it, axis by axis
};

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

/// Each round pairs all but those whose neighbours were all nearer to others.
constexpr int kRounds = 8;

using Indices = std::vector<std::size_t>;

struct Both {
  std::span<const Spot> base, now;
  std::vector<char> has_base, has_now;  ///< paired already
  std::vector<Match> matches;

  void pair(std::size_t b, std::size_t n, double distance_mm) {
    has_base[b] = has_now[n] = 1;
    matches.push_back({b, n, distance_mm});
  }
};

auto key(const Spot& spot) {
  return std::tuple(spot.at_mm.x, spot.at_mm.y, spot.at_mm.z);
}

Indices by_place(std::span<const Spot> spots) {
  Indices order(spots.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t a, std::size_t b) { return key(spots[a]) < key(spots[b]); });
  return order;
}

/// However crowded: what did not change is the same.
void pair_equal(Both& both) {
  const Indices base = by_place(both.base), now = by_place(both.now);
  for (std::size_t b = 0, n = 0; b < base.size() && n < now.size();) {
    const auto old_key = key(both.base[base[b]]), new_key = key(both.now[now[n]]);
    if (old_key == new_key)
      both.pair(base[b++], now[n++], 0);
    else if (old_key < new_key)
      ++b;
    else
      ++n;
  }
}

Indices unpaired(const std::vector<char>& has) {
  Indices out;
  for (std::size_t i = 0; i < has.size(); ++i)
    if (!has[i]) out.push_back(i);
  return out;
}

double largest_reach(std::span<const Spot> base, std::span<const Spot> now) {
  double reach = 0;
  for (const Spot& spot : base) reach = std::max(reach, spot.reach_mm);
  for (const Spot& spot : now) reach = std::max(reach, spot.reach_mm);
  return reach;
}

std::vector<Match> candidates(const Both& both, double radius_mm) {
  const SpotTree tree(both.base, unpaired(both.has_base));
  std::vector<Match> out;
  for (const std::size_t n : unpaired(both.has_now)) {
    for (const SpotTree::Near& near : tree.nearest(both.now[n].at_mm, radius_mm)) {
      const double reach = std::max(both.now[n].reach_mm, both.base[near.spot].reach_mm);
      if (near.distance_mm <= reach) out.push_back({near.spot, n, near.distance_mm});
    }
  }
  std::sort(out.begin(), out.end(), [](const Match& a, const Match& b) {
    return std::tie(a.distance_mm, a.base, a.now) < std::tie(b.distance_mm, b.base, b.now);
  });
  return out;
}

}  // namespace

std::vector<Match> match_spots(std::span<const Spot> base, std::span<const Spot> now) {
  Both both{base, now, std::vector<char>(base.size()), std::vector<char>(now.size()), {}};
  pair_equal(both);
  const double radius_mm = largest_reach(base, now);
  for (int round = 0; round < kRounds; ++round) {
    const std::size_t before = both.matches.size();
    for (const Match& m : candidates(both, radius_mm))
      if (!both.has_base[m.base] && !both.has_now[m.now]) both.pair(m.base, m.now, m.distance_mm);
    if (both.matches.size() == before) break;
  }
  return std::move(both.matches);
}

}  // namespace limitgauge::reports::compare
