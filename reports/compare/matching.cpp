#include "reports/compare/matching.h"

#include <algorithm>
#include <numeric>
#include <tuple>

#include "reports/compare/spot_tree.h"

namespace limitgauge::reports::compare {
namespace {

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
