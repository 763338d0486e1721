#include "simulator/stock/stock_layout.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <utility>

#include "model/base/error.h"
#include "model/base/memory.h"
#include "model/text/number_text.h"
#include "simulator/grid/block_cut.h"
#include "simulator/grid/stock_grid.h"

namespace limitgauge::simulator {
namespace {

// A tree of its own takes a root's eight children at most, where the lattice's zero is in it.
constexpr double kTreeBytes = 8 * 280e3;
constexpr int kCoarsest = 64;
// Of a voxel that was too fine: to 3e10 times as much, and to within a twentieth of the finest.
constexpr int kMostDoublings = 35, kHalvings = 4;
constexpr double kMostNodes = 4e6;

using Columns = std::map<std::pair<int, int>, double>;  // bytes by block column, x before y

Columns columns_of(const GridForecast& forecast, const IndexBox& extent) {
  Columns columns;
  for (int x = extent.low[0]; x < extent.high[0]; x += kBlockEdge)
    for (int y = extent.low[1]; y < extent.high[1]; y += kBlockEdge) columns[{x, y}] = 0;
  for (const Index3& b : forecast.blocks) columns[{b[0], b[1]}] += forecast.bytes_a_block;
  return columns;
}

// How much larger a tile is for the leaf of margin on both sides of `blocks`.
double with_margin(int voxels) {
  return static_cast<double>(voxels + 2 * kLeafEdge) / voxels;
}

// One column of blocks along y at x, cut so that each part takes no more than `most`.
bool divide_slab(const Columns& columns, const IndexBox& slab, double most,
                 std::vector<IndexBox>& tiles) {
  IndexBox tile = slab;
  double sum = 0;
  for (int y = slab.low[1]; y < slab.high[1]; y += kBlockEdge) {
    const double column = columns.at({slab.low[0], y});
    const double taken =
        (sum + column) * with_margin(kBlockEdge) * with_margin(y + kBlockEdge - tile.low[1]);
    if (taken > most) {
      if (y == tile.low[1]) return false;
      tile.high[1] = y;
      tiles.push_back(tile);
      tile.low[1] = y, sum = 0;
      if (column * with_margin(kBlockEdge) * with_margin(kBlockEdge) > most) return false;
    }
    sum += column;
  }
  tile.high[1] = slab.high[1];
  tiles.push_back(tile);
  return true;
}

std::optional<std::vector<IndexBox>> divide(const GridForecast& forecast, const IndexBox& extent,
                                            double most) {
  const Columns columns = columns_of(forecast, extent);
  std::vector<IndexBox> tiles;
  IndexBox run = extent;  // of whole slabs
  double sum = 0;
  const auto close = [&](int x) {
    run.high[0] = x;
    if (run.high[0] > run.low[0]) tiles.push_back(run);
    run.low[0] = x, sum = 0;
  };
  for (int x = extent.low[0]; x < extent.high[0]; x += kBlockEdge) {
    IndexBox slab = extent;
    slab.low[0] = x, slab.high[0] = x + kBlockEdge;
    double bytes = 0;
    for (int y = extent.low[1]; y < extent.high[1]; y += kBlockEdge) bytes += columns.at({x, y});
    const bool too_large = bytes * with_margin(kBlockEdge) > most;
    if (too_large || (sum + bytes) * with_margin(x + kBlockEdge - run.low[0]) > most) close(x);
    if (!too_large) {
      sum += bytes;
      continue;
    }
    if (!divide_slab(columns, slab, most, tiles)) return std::nullopt;
    run.low[0] = x + kBlockEdge;
  }
  close(extent.high[0]);
  return tiles;
}

// The finest multiple of the voxel whose whole grid fits into `most`, of all up to eight, and a
// quarter apart from there on.
std::optional<int> coarsening(const Material& material, const Lattice& lattice,
                              const GridForecast& fine, double most,
                              const model::RunControl& control) {
  // A grid's memory goes with the inverse square of its voxel, more slowly where it is small.
  for (int n = 2; n <= kCoarsest; n += std::max(1, n / 4)) {
    if (fine.bytes / (n * n) > most) continue;
    const Lattice coarse{lattice.origin_mm, n * lattice.voxel_mm};
    if (forecast_grid(material, coarse, control).bytes <= most) return n;
  }
  return std::nullopt;
}

// Voxels so small that the blocks could not even be counted.
bool too_fine(const Material& material, const Lattice& lattice) {
  const model::Vec3 size = bounding_box(material.raw()).size();
  double nodes = 1;
  for (int a = 0; a < 3; ++a) nodes *= size[a] / (kNodeEdge * lattice.voxel_mm) + 2;
  return nodes > kMostNodes;
}

std::optional<StockLayout> layout_within(const Material& material, const Lattice& lattice,
                                         double limit, const model::RunControl& control) {
  if (too_fine(material, lattice)) return std::nullopt;
  StockLayout layout;
  const double moves = pass_bytes(material), left = limit - moves;
  layout.forecast = forecast_grid(material, lattice, control);
  layout.bytes = layout.forecast.bytes + moves;
  if (layout.bytes <= limit) return layout;
  layout.whole = false;
  const auto coarse = coarsening(material, lattice, layout.forecast, left / 4, control);
  auto tiles =
      divide(layout.forecast, stock_extent(material.raw(), lattice), left / 2 - kTreeBytes);
  if (!coarse || !tiles) return std::nullopt;
  layout.coarsening = *coarse;
  layout.tiles = *std::move(tiles);
  layout.bytes = moves + 0.75 * left;
  return layout;
}

// Of two digits, and within a twentieth of the finest that `fits` where coarser ones do too: it is
// doubled until it does, and what lies between is halved.
template <class Fits>
std::optional<double> voxel_that_fits(double too_fine, Fits fits) {
  double voxel = two_digits_up(2 * too_fine);
  for (int i = 0; !fits(voxel); ++i, voxel = two_digits_up(2 * voxel)) {
    if (i == kMostDoublings) return std::nullopt;
    too_fine = voxel;
  }
  for (int i = 0; i < kHalvings; ++i) {
    const double between = two_digits_up(std::sqrt(too_fine * voxel));
    if (between >= voxel) break;
    (fits(between) ? voxel : too_fine) = between;
  }
  return voxel;
}

[[noreturn]] void refuse(const Material& material, const Lattice& lattice, double limit,
                         const model::RunControl& control) {
  const double moves = pass_bytes(material);
  const std::string allowed = "allowed are " + model::in_mib(limit);
  if (moves >= limit)
    throw model::ResourceError("the moves alone need " + model::in_mib(moves) + ", " + allowed);
  const std::string needed = "the stock does not fit into memory at a voxel of " +
                             model::six_digits(lattice.voxel_mm) + " mm, not even in tiles; " +
                             allowed;
  const auto fits = [&](double voxel) {
    return layout_within(material, {lattice.origin_mm, voxel}, limit, control).has_value();
  };
  if (const auto voxel = voxel_that_fits(lattice.voxel_mm, fits))
    throw model::ResourceError(needed + "; a voxel of " + model::six_digits(*voxel) +
                               " mm would do");
  throw model::ResourceError(needed + "; fewer moves or more memory would do");
}

}  // namespace

StockLayout choose_layout(const Material& material, const Lattice& lattice, std::size_t limit_bytes,
                          const model::RunControl& control) {
  const auto limit = static_cast<double>(limit_bytes);
  if (auto layout = layout_within(material, lattice, limit, control)) return *std::move(layout);
  refuse(material, lattice, limit, control);
}

}  // namespace limitgauge::simulator
