#include "simulator/instrument/dexel_grid.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <limits>

#include "simulator/tolerance.h"

namespace limitgauge::simulator {
namespace {

/// The part of a line p + t·d that lies between two planes across an axis.
void clip(model::Interval& t, double p, double d, double low, double high) {
  if (d == 0) {
    if (p < low || p > high) t.high = t.low;
    return;
  }
  const double at_low = (low - p) / d, at_high = (high - p) / d;
  t = {std::max(t.low, std::min(at_low, at_high)), std::min(t.high, std::max(at_low, at_high))};
}

std::vector<model::Interval> unless_empty(const model::Interval& t) {
  if (t.high - t.low < kDexelRounding_mm) return {};
  return {t};
}

constexpr model::Interval kWholeLine{-std::numeric_limits<double>::infinity(),
                                     std::numeric_limits<double>::infinity()};

/// Of a block on a line, d a unit vector.
std::vector<model::Interval> on_line(const model::BoxStock& box, const model::Vec3& p,
                                     const model::Vec3& d) {
  model::Interval t = kWholeLine;
  for (const int a : {0, 1, 2})
    clip(t, p[a], d[a], box.corner_mm[a], box.corner_mm[a] + box.size_mm[a]);
  return unless_empty(t);
}

/// Of an upright bar on a line, d a unit vector: where |q + t·e| ≤ r in plan, and between its ends.
std::vector<model::Interval> on_line(const model::CylinderStock& bar, const model::Vec3& p,
                                     const model::Vec3& d) {
  model::Interval t = kWholeLine;
  clip(t, p.z, d.z, bar.base_mm.z, bar.base_mm.z + bar.height_mm);
  const double r = bar.diameter_mm / 2, x = p.x - bar.base_mm.x, y = p.y - bar.base_mm.y;
  const double level = std::hypot(d.x, d.y);
  if (level == 0) return std::hypot(x, y) > r ? std::vector<model::Interval>{} : unless_empty(t);
  // Along the line in plan: the place nearest to the axis, and half the chord about it.
  const double beside = (x * d.y - y * d.x) / level;
  if (std::abs(beside) >= r) return {};
  const double middle = -(x * d.x + y * d.y) / (level * level);
  const double half = std::sqrt((r - beside) * (r + beside)) / level;
  return unless_empty({std::max(t.low, middle - half), std::min(t.high, middle + half)});
}

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
  std::vector<model::Interval> operator()(const model::LeaningStock& stock) const {
    const model::Vec3 from = stock.pose.point_back({x, y, 0});
    const model::Vec3 along = stock.pose.direction_back({0, 0, 1});
    return std::visit([&](const auto& shape) { return on_line(shape, from, along); },
                      stock.upright);
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

int tiles_along(int lines) {
  return (lines + DexelTile::kEdge - 1) / DexelTile::kEdge;
}

}  // namespace

DexelLattice::DexelLattice(const model::Box3& box, double spacing_mm)
    : corner(box.low),
      nx(divisions(box.size().x, spacing_mm)),
      ny(divisions(box.size().y, spacing_mm)),
      tiles_x(tiles_along(nx)),
      tiles_y(tiles_along(ny)) {
  dx = box.size().x / nx, dy = box.size().y / ny;
}

model::Vec3 DexelLattice::line_at(int i, int j) const {
  return {corner.x + (i + 0.5) * dx, corner.y + (j + 0.5) * dy, 0};
}

DexelFrame DexelLattice::frame(int tile_x, int tile_y) const {
  const model::Vec3 first = line_at(tile_x * DexelTile::kEdge, tile_y * DexelTile::kEdge);
  return {first.x, first.y, dx, dy};
}

std::vector<model::Interval> raw_on_line(const RawStock& raw, double x, double y) {
  return std::visit(RawLine{x, y, raw.solid()}, raw.stock());
}

DexelTiles raw_tiles(const RawStock& raw, const DexelLattice& lattice) {
  return tiles_of([&](double x, double y) { return raw_on_line(raw, x, y); }, lattice, {1});
}

DexelTiles tiles_of(const LineMaterial& standing, const DexelLattice& lattice,
                    const model::RunControl& control) {
  constexpr int kEdge = DexelTile::kEdge;
  DexelTiles tiles(lattice.tiles());
  std::atomic<std::size_t> done = 0;
  model::parallel_for(tiles.size(), control.threads, [&](std::size_t t) {
    const int first_i = static_cast<int>(t % static_cast<std::size_t>(lattice.tiles_x)) * kEdge;
    const int first_j = static_cast<int>(t / static_cast<std::size_t>(lattice.tiles_x)) * kEdge;
    auto tile = std::make_shared<DexelTile>();
    for (int j = first_j; j < std::min(first_j + kEdge, lattice.ny); ++j) {
      control.check();
      for (int i = first_i; i < std::min(first_i + kEdge, lattice.nx); ++i) {
        const model::Vec3 p = lattice.line_at(i, j);
        tile->set_material(DexelTile::line(i - first_i, j - first_j), standing(p.x, p.y));
      }
    }
    tiles[t] = std::move(tile);
    control.report(static_cast<double>(++done) / static_cast<double>(tiles.size()));
  });
  return tiles;
}

}  // namespace limitgauge::simulator
