#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "reports/compare/matching.h"

namespace limitgauge::reports::compare {

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

}  // namespace limitgauge::reports::compare
