#pragma once

#include <array>
#include <vector>

#include "tests/defects/surfaces/sampled_surface.h"

namespace limitgauge::tests::defects {

/// Where a ray meets S after its start: solved on the exact patches from every cell of the samples
/// that it passes, with two answers where it grazes.
class Crossings {
 public:
  explicit Crossings(const SampledSurface& surface);

  struct First {
    double possible = 0;  ///< the first place that may be a crossing or a touch; else the limit
    double sure = 0;      ///< the first place where S is passed for certain; else the limit
  };
  /// Along `from` + t·`along` (a unit vector), `least` < t < `limit`, in mm; what lies within
  /// 1e-5 mm of `except` is no crossing, unless it faces right against `facing`.
  First first(const model::Vec3& from, const model::Vec3& along, double least, double limit,
              const model::Vec3& except, const model::Vec3& facing) const;

 private:
  struct Cell {
    int patch = 0;
    double u = 0, v = 0, size = 0;
    model::Box3 box;
  };
  struct Node {
    model::Box3 box;
    std::uint32_t first = 0, count = 0;  ///< cells of a leaf, or the two nodes from `first` on
  };
  void add_cells(const SampledSurface::Grid& grid);
  void build(std::uint32_t node, std::uint32_t first, std::uint32_t count);
  void meet(const Cell& cell, const model::Vec3& from, const model::Vec3& along, double least,
            const model::Vec3& except, const model::Vec3& facing, First& out) const;

  const SampledSurface& surface_;
  std::vector<Cell> cells_;
  std::vector<Node> nodes_;
};

}  // namespace limitgauge::tests::defects
