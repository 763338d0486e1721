#include "engine/strategy/raster/height_map.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "engine/tolerance.h"

namespace limitgauge::engine::strategy {
namespace {

using model::Vec3;

/// A triangle in pixel units, and the pixels it may touch.
class FlatTriangle {
 public:
  FlatTriangle(const Raster& r, const Vec3& a, const Vec3& b, const Vec3& c)
      : p_{to_pixels(r, a), to_pixels(r, b), to_pixels(r, c)} {
    top_ = std::max({a.z, b.z, c.z});
    area_ = (p_[1].x - p_[0].x) * (p_[2].y - p_[0].y) - (p_[1].y - p_[0].y) * (p_[2].x - p_[0].x);
    if (std::abs(area_) < kSliver_px2) return;
    slope_x_ =
        ((p_[1].z - p_[0].z) * (p_[2].y - p_[0].y) - (p_[2].z - p_[0].z) * (p_[1].y - p_[0].y)) /
        area_;
    slope_y_ =
        ((p_[2].z - p_[0].z) * (p_[1].x - p_[0].x) - (p_[1].z - p_[0].z) * (p_[2].x - p_[0].x)) /
        area_;
    has_plane_ = true;
  }

  int first(int axis) const { return pixel(std::min({p_[0][axis], p_[1][axis], p_[2][axis]})); }
  int last(int axis) const { return pixel(std::max({p_[0][axis], p_[1][axis], p_[2][axis]})); }

  /// Whether the pixel's square meets the triangle (its box is looked at by the caller).
  bool touches(int column, int row) const {
    if (!has_plane_) return true;
    const double turn = area_ > 0 ? 1 : -1;
    for (int i = 0; i < 3; ++i) {
      const Vec3 &a = p_[i], &b = p_[(i + 1) % 3];
      const double ex = b.x - a.x, ey = b.y - a.y;
      const double side = turn * (ex * (row - a.y) - ey * (column - a.x));
      if (side + (std::abs(ex) + std::abs(ey)) / 2 < 0) return false;
    }
    return true;
  }
  /// No point of the triangle over the pixel's square is higher.
  double top_over(int column, int row) const {
    if (!has_plane_) return top_;
    const double middle = p_[0].z + slope_x_ * (column - p_[0].x) + slope_y_ * (row - p_[0].y);
    return std::min(top_, middle + (std::abs(slope_x_) + std::abs(slope_y_)) / 2);
  }

 private:
  static Vec3 to_pixels(const Raster& r, const Vec3& p) {
    return {(p.x - r.x0) / r.pixel_mm, (p.y - r.y0) / r.pixel_mm, p.z};
  }
  static int pixel(double at) {
    constexpr double kFar = 1e9;
    return static_cast<int>(std::floor(std::clamp(at, -kFar, kFar) + 0.5));
  }

  std::array<Vec3, 3> p_;
  double top_ = 0, area_ = 0, slope_x_ = 0, slope_y_ = 0;
  bool has_plane_ = false;
};

void raise(HeightMap& map, const FlatTriangle& t) {
  const int column_end = std::min(t.last(0), map.raster.columns - 1);
  const int row_end = std::min(t.last(1), map.raster.rows - 1);
  for (int row = std::max(0, t.first(1)); row <= row_end; ++row)
    for (int column = std::max(0, t.first(0)); column <= column_end; ++column) {
      if (!t.touches(column, row)) continue;
      // Single precision: round up, so that the map stays an upper bound.
      constexpr float kInfinity = std::numeric_limits<float>::infinity();
      const float z = std::nextafter(static_cast<float>(t.top_over(column, row)), kInfinity);
      float& here = map.z[static_cast<std::size_t>(row) * map.raster.columns + column];
      here = std::max(here, z);
    }
}

}  // namespace

Raster cover(const model::Box3& box, double pixel_mm) {
  const model::Vec3 size = box.size();
  return {box.low.x, box.low.y, pixel_mm, static_cast<int>(std::ceil(size.x / pixel_mm)) + 1,
          static_cast<int>(std::ceil(size.y / pixel_mm)) + 1};
}

HeightMap make_height_map(const Raster& raster, const surface::OffsetSampler& sampler) {
  HeightMap map{raster, std::vector<float>(raster.size(), -std::numeric_limits<float>::infinity())};
  surface::for_each_piece(sampler, 0, [&](const surface::Grid& grid) {
    for (int v = 0; v + 1 < grid.rows; ++v)
      for (int u = 0; u + 1 < grid.columns; ++u) {
        const Vec3 &a = grid.at(u, v), &c = grid.at(u + 1, v + 1);
        raise(map, FlatTriangle(raster, a, grid.at(u + 1, v), c));
        raise(map, FlatTriangle(raster, a, c, grid.at(u, v + 1)));
      }
  });
  return map;
}

HeightMap coarsened(const HeightMap& map, int factor) {
  const Raster& fine = map.raster;
  const double shift = (factor - 1) / 2.0;
  const Raster raster{fine.x(shift), fine.y(shift), fine.pixel_mm * factor,
                      (fine.columns + factor - 1) / factor, (fine.rows + factor - 1) / factor};
  HeightMap coarse{raster,
                   std::vector<float>(raster.size(), -std::numeric_limits<float>::infinity())};
  for (int j = 0; j < fine.rows; ++j) {
    const float* from = &map.z[static_cast<std::size_t>(j) * fine.columns];
    float* to = &coarse.z[static_cast<std::size_t>(j / factor) * raster.columns];
    for (int i = 0; i < fine.columns; ++i) to[i / factor] = std::max(to[i / factor], from[i]);
  }
  return coarse;
}

Window overlap(const Window& a, const Window& b) {
  return {std::max(a.first_column, b.first_column), std::max(a.first_row, b.first_row),
          std::min(a.last_column, b.last_column), std::min(a.last_row, b.last_row)};
}

Window covering(const Raster& r, const model::Box3& box) {
  const auto before = [&](double at) { return static_cast<int>(std::floor(at / r.pixel_mm)); };
  const auto after = [&](double at) { return static_cast<int>(std::ceil(at / r.pixel_mm)); };
  return overlap(whole(r), {before(box.low.x - r.x0), before(box.low.y - r.y0),
                            after(box.high.x - r.x0), after(box.high.y - r.y0)});
}

Raster part_of(const Raster& r, const Window& w) {
  return {r.x(w.first_column), r.y(w.first_row), r.pixel_mm, w.columns(), w.rows()};
}

}  // namespace limitgauge::engine::strategy
