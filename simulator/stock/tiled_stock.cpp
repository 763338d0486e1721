#include "simulator/stock/tiled_stock.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace limitgauge::simulator {
namespace {

constexpr double kAll = std::numeric_limits<double>::infinity();

bool meets(const IndexBox& tile, const Lattice& lattice, const model::Box3& region) {
  const model::Vec3 low = lattice.point(tile.low), high = lattice.point(tile.high);
  for (int a = 0; a < 3; ++a)
    if (high[a] < region.low[a] || low[a] > region.high[a]) return false;
  return true;
}

}  // namespace

model::RunControl part_of(const model::RunControl& control, double from, double to) {
  model::RunControl part = control;
  if (control.progress)
    part.progress = [report = control.progress, from, to](double fraction) {
      report(from + (to - from) * fraction);
    };
  return part;
}

StockGrid build_grid(const Material& material, const Lattice& lattice, const IndexBox& box,
                     const model::RunControl& control) {
  const double parts = static_cast<double>(material.passes().size()) + 1;
  StockGrid grid(material.raw(), lattice, box, kLeafEdge, part_of(control, 0, 1 / parts));
  for (std::size_t i = 0; i < material.passes().size(); ++i) {
    const SweepIndex& pass = *material.passes()[i];
    const double from = static_cast<double>(i) + 1;
    const model::RunControl part = part_of(control, from / parts, (from + 1) / parts);
    const PassReach reach = grid.reach(pass, part);
    grid = std::move(grid).cut(pass, reach, part);
  }
  return grid;
}

TiledStock::TiledStock(const Material& material, const Lattice& lattice,
                       std::vector<IndexBox> tiles, const model::RunControl& control)
    : lattice_(lattice), tiles_(std::move(tiles)) {
  const IndexBox extent = stock_extent(material.raw(), lattice);
  tops_ = empty_tops(extent, lattice);
  each_tile(material, {{-kAll, -kAll, -kAll}, {kAll, kAll, kAll}}, control,
            [&](const StockGrid& tile, const model::RunControl& part) {
              volume_ += tile.volume(part);
              tile.raise_tops(extent, part, tops_);
            });
}

void TiledStock::each_tile(const Material& material, const model::Box3& region,
                           const model::RunControl& control, const Visit& visit) const {
  std::vector<IndexBox> met;
  for (const IndexBox& tile : tiles_)
    if (meets(tile, lattice_, region)) met.push_back(tile);
  const double n = static_cast<double>(met.size());
  for (std::size_t i = 0; i < met.size(); ++i) {
    const double from = static_cast<double>(i) / n;
    const model::RunControl building = part_of(control, from, from + 0.5 / n);
    visit(build_grid(material, lattice_, met[i], building),
          part_of(control, from + 0.5 / n, from + 1 / n));
    control.report(static_cast<double>(i + 1) / n);
  }
}

double interpolated_value(const Material& material, const Lattice& lattice,
                          const model::Vec3& p_mm) {
  const model::Vec3 at = (p_mm - lattice.origin_mm) / lattice.voxel_mm;
  Index3 low;
  model::Vec3 share;
  for (int a = 0; a < 3; ++a) {
    const double floor = std::floor(at[a]);
    low[a] = static_cast<int>(floor);
    share[a] = at[a] - floor;
  }
  const auto band = static_cast<float>(kBandVoxels * lattice.voxel_mm);
  double sum = 0;
  for (int k = 0; k < 8; ++k) {
    const int dx = k >> 2 & 1, dy = k >> 1 & 1, dz = k & 1;
    const model::Vec3 corner = lattice.point({low[0] + dx, low[1] + dy, low[2] + dz});
    const auto exact = static_cast<float>(material.sample(corner).value);
    sum += std::clamp(exact, -band, band) * (dx ? share.x : 1 - share.x) *
           (dy ? share.y : 1 - share.y) * (dz ? share.z : 1 - share.z);
  }
  return sum;
}

}  // namespace limitgauge::simulator
