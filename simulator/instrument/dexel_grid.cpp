#include "simulator/instrument/dexel_grid.h"

#include <algorithm>
#include <cmath>

#include "simulator/tolerance.h"

namespace limitgauge::simulator {
namespace {

/// The raw stock on one line.
struct RawLine {
  double x, y;
  const std::optional<MeshSolid>& solid;

  std::vector<model::Interval> operator()(const model::BoxStock& box) const {
    return {{box.corner_mm.z, box.corner_mm.z + box.size_mm.z}};
  }
  std::vector<model::Interval> operator()(const model::CylinderStock& bar) const {
    if (std::hypot(x - bar.base_mm.x, y - bar.base_mm.y) > bar.diameter_mm / 2) return {};
    return {{bar.base_mm.z, bar.base_mm.z + bar.height_mm}};
  }
  std::vector<model::Interval> operator()(const model::MeshStock&) const {
    std::vector<model::Interval> intervals;
    const std::vector<double> z = solid->crossings(x, y);
    for (std::size_t i = 0; i + 1 < z.size(); i += 2) {
      // Solids that touch make one interval.
      if (!intervals.empty() && z[i] - intervals.back().high < kDexelRounding_mm)
        intervals.back().high = z[i + 1];
      else if (z[i + 1] - z[i] >= kDexelRounding_mm)
        intervals.push_back({z[i], z[i + 1]});
    }
    return intervals;
  }
};

int divisions(double size, double spacing) {
  // A size that is a whole number of spacings but for rounding is one.
  return std::max(1, static_cast<int>(std::ceil(size / spacing - kWholeSpacing)));
}

int tiles_of(int lines) {
  return (lines + DexelTile::kEdge - 1) / DexelTile::kEdge;
}

}  // namespace

DexelLattice::DexelLattice(const model::Box3& box, double spacing_mm)
    : corner(box.low),
      nx(divisions(box.size().x, spacing_mm)),
      ny(divisions(box.size().y, spacing_mm)),
      tiles_x(tiles_of(nx)),
      tiles_y(tiles_of(ny)) {
  dx = box.size().x / nx, dy = box.size().y / ny;
}

model::Vec3 DexelLattice::line_at(int i, int j) const {
  return {corner.x + (i + 0.5) * dx, corner.y + (j + 0.5) * dy, 0};
}

DexelFrame DexelLattice::frame(int tile_x, int tile_y) const {
  const model::Vec3 first = line_at(tile_x * DexelTile::kEdge, tile_y * DexelTile::kEdge);
  return {first.x, first.y, dx, dy};
}

DexelTiles raw_tiles(const RawStock& raw, const DexelLattice& lattice) {
  std::vector<std::shared_ptr<DexelTile>> tiles(lattice.tiles());
  for (auto& tile : tiles) tile = std::make_shared<DexelTile>();
  for (int j = 0; j < lattice.ny; ++j)
    for (int i = 0; i < lattice.nx; ++i) {
      constexpr int kEdge = DexelTile::kEdge;
      const model::Vec3 p = lattice.line_at(i, j);
      tiles[lattice.tile(i / kEdge, j / kEdge)]->set_material(
          DexelTile::line(i % kEdge, j % kEdge),
          std::visit(RawLine{p.x, p.y, raw.solid()}, raw.stock()));
    }
  return {tiles.begin(), tiles.end()};
}

}  // namespace limitgauge::simulator
