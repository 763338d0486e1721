#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include "reports/page/blocks.h"
#include "verifier/gate/deviation.h"

namespace limitgauge::reports::page {

/// A field has at most so many cells on a page; patches have one each at least.
inline constexpr std::size_t kMostCells = 250'000;

/// The samples of a field that a page shows: all, or every so-many-th of every patch with its
/// borders.
struct PageGrid {
  struct Patch {
    verifier::DeviationField::Grid measured;
    std::uint32_t columns = 0, rows = 0;  ///< that are shown
    friend bool operator==(const Patch&, const Patch&) = default;
  };
  std::vector<Patch> patches;
  std::uint32_t stride = 1;
  friend bool operator==(const PageGrid&, const PageGrid&) = default;
};

/// The smallest stride that leaves at most `most_cells`.
PageGrid page_grid(const verifier::DeviationField& field, std::size_t most_cells = kMostCells);
/// Of `measured` columns (or rows) those that `shown` stand for: index of number `i`, evenly
/// spread, both ends among them.
std::uint32_t measured_index(std::uint32_t i, std::uint32_t shown, std::uint32_t measured);
/// Index of the shown sample nearest to index `k` of the measured ones.
std::uint32_t page_index(std::uint32_t k, std::uint32_t shown, std::uint32_t measured);
/// Calls `visit(sample)` with the index in the field of every shown sample, in the page's order.
void visit_page_samples(const PageGrid& grid, const std::function<void(std::size_t)>& visit);

/// The surfaces of the page: each stage's samples, those at the same places stored once.
class Surfaces {
 public:
  /// Index of the surface that `grid` of `field` is.
  std::size_t add(const verifier::DeviationField& field, const PageGrid& grid, Blob& blob);
  const Json& json() const { return json_; }

 private:
  struct Known {
    PageGrid grid;
    double step_mm = 0;
    std::vector<std::int32_t> position;
    friend bool operator==(const Known&, const Known&) = default;
  };
  std::vector<Known> known_;
  Json json_ = Json::array();
};

/// Points as multiples of a step, x, y, z in turn.
struct GridPoints {
  double step_mm = 1;
  std::vector<std::int32_t> multiples;
};
GridPoints on_grid(const std::vector<model::Vec3>& points);
/// {"block", "step_mm"} of points.
Json points_block(const GridPoints& points, Blob& blob);
/// The vertices of triangles, three in turn.
std::vector<std::int32_t> corners_of(std::span<const std::array<std::uint32_t, 3>> triangles);

}  // namespace limitgauge::reports::page
