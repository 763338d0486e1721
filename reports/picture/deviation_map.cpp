#include "reports/picture/deviation_map.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "reports/picture/quad_bunches.h"
#include "reports/picture/raster.h"
#include "reports/tolerance.h"

namespace limitgauge::reports {
namespace {

using Sample = verifier::DeviationField::Sample;

constexpr Rgba kHatchDark{110, 114, 120}, kHatchLight{196, 199, 203};
constexpr Rgba kBorder{20, 24, 30, 70};
constexpr int kOversampling = 2;
constexpr int kHatchPeriod = 14;  ///< oversampled pixels

/// What the uppermost surface holds at each pixel of some rows, where there is one. The same memory
/// is for all of them.
struct MapLayers {
  explicit MapLayers(int width)
      : depth(width, kRowsAtOnce),
        deviation_mm(std::size_t(width) * kRowsAtOnce),
        reachable(std::size_t(width) * kRowsAtOnce) {}
  DepthBuffer depth;
  std::vector<float> deviation_mm, reachable;
};

std::vector<ScreenPoint> screen_points(const verifier::DeviationField& field,
                                       const MapFrame& frame) {
  std::vector<ScreenPoint> points;
  points.reserve(field.samples.size());
  for (const Sample& s : field.samples) {
    const model::Vec2 p = frame.pixel(s.place.point);
    points.push_back({p.x, p.y, s.place.point.z});
  }
  return points;
}

void fill_layers(MapLayers& layers, const verifier::DeviationField& field,
                 const std::vector<ScreenPoint>& points, const QuadBunches& bunches) {
  const auto fill = [&](std::uint32_t a, std::uint32_t b, std::uint32_t c) {
    const Sample &sa = field.samples[a], &sb = field.samples[b], &sc = field.samples[c];
    layers.depth.fill_triangle(
        {points[a], points[b], points[c]}, [&](std::size_t i, const auto& w) {
          layers.deviation_mm[i] = static_cast<float>(
              w[0] * sa.deviation_mm + w[1] * sb.deviation_mm + w[2] * sc.deviation_mm);
          layers.reachable[i] =
              static_cast<float>(w[0] * sa.reachable + w[1] * sb.reachable + w[2] * sc.reachable);
        });
  };
  bunches.each(layers.depth,
               [&](const auto& q) { fill(q[0], q[1], q[2]), fill(q[0], q[2], q[3]); });
}

/// Puts the colours of the rows into `image`.
void colour_rows(const MapLayers& layers, const DeviationScale& scale, Image& image) {
  const std::size_t width = image.width(), pixels = width * layers.depth.height();
  for (std::size_t i = 0; i < pixels; ++i) {
    Rgba& pixel = image.pixels()[i];
    if (layers.depth.is_empty(i)) {
      pixel = {0, 0, 0, 0};
    } else if (layers.reachable[i] < 0.5f) {
      pixel = hatch_colour(i % width, layers.depth.first_row() + i / width);
    } else {
      pixel = scale.colour(layers.deviation_mm[i]);
    }
  }
}

using Stroke = std::array<model::Vec2, 2>;

std::vector<Stroke> border_strokes(const verifier::DeviationField& field, const MapFrame& frame) {
  std::vector<Stroke> strokes;
  visit_borders(field, [&](std::size_t a, std::size_t b) {
    strokes.push_back(
        {frame.pixel(field.samples[a].place.point), frame.pixel(field.samples[b].place.point)});
  });
  return strokes;
}

/// Borders are met from both patches: collect them as coverage first, then blend once.
void draw_borders(Image& image, const std::vector<Stroke>& strokes) {
  constexpr double kWidth = 1.0;
  Image mask(image.width(), kRowsAtOnce);
  by_rows(image.height(), [&](int first_row, int rows) {
    mask.fill(0, 0, mask.width(), rows, {0, 0, 0, 0});
    for (const auto& [a, b] : strokes) {
      const double above = first_row - kWidth, below = first_row + rows + kWidth;
      if (std::max(a.y, b.y) < above || std::min(a.y, b.y) > below) continue;
      const model::Vec2 up{0, double(first_row)};
      draw_stroke(mask, {a - up, b - up}, kWidth, {kBorder.r, kBorder.g, kBorder.b, 255});
    }
    for (int y = 0; y < rows; ++y)
      for (int x = 0; x < mask.width(); ++x)
        if (mask.at(x, y).a > 0) image.blend(x, first_row + y, kBorder, mask.at(x, y).a / 255.0);
  });
}

}  // namespace

Rgba hatch_colour(std::size_t x, std::size_t y) {
  return (x + y) % kHatchPeriod < kHatchPeriod / 3 ? kHatchDark : kHatchLight;
}

void visit_borders(const verifier::DeviationField& field,
                   const std::function<void(std::size_t, std::size_t)>& visit) {
  for (const verifier::DeviationField::Grid& grid : field.grids) {
    const std::size_t columns = grid.columns, last_row = grid.first + columns * (grid.rows - 1);
    for (std::size_t i = 0; i + 1 < columns; ++i) {
      visit(grid.first + i, grid.first + i + 1);
      visit(last_row + i, last_row + i + 1);
    }
    for (std::size_t at = grid.first; at < last_row; at += columns) {
      visit(at, at + columns);
      visit(at + columns - 1, at + 2 * columns - 1);
    }
  }
}

MapFrame map_frame(const verifier::DeviationField& field, int largest_width, int largest_height) {
  model::Box3 box;
  for (const Sample& s : field.samples) box.add(s.place.point);
  if (box.empty()) return {};
  const double margin_px = 12;
  const model::Vec3 size = box.size();
  const double scale =
      std::min((largest_width - 2 * margin_px) / std::max(size.x, kLeastExtent_mm),
               (largest_height - 2 * margin_px) / std::max(size.y, kLeastExtent_mm));
  return {box.low.x - margin_px / scale, box.high.y + margin_px / scale, scale,
          int(std::ceil(size.x * scale + 2 * margin_px)),
          int(std::ceil(size.y * scale + 2 * margin_px))};
}

void draw_hatch(Image& image, int left, int top, int size) {
  Image fine(size * kOversampling, size * kOversampling);
  for (int y = 0; y < fine.height(); ++y)
    for (int x = 0; x < fine.width(); ++x) fine.at(x, y) = hatch_colour(x, y);
  image.draw(fine.halved(), left, top);
}

Image draw_map(const verifier::DeviationField& field, const DeviationScale& scale,
               const MapFrame& frame) {
  MapFrame fine = frame;
  fine.pixels_per_mm *= kOversampling, fine.width *= kOversampling, fine.height *= kOversampling;
  const std::vector<ScreenPoint> points = screen_points(field, fine);
  const QuadBunches bunches(field, points);
  MapLayers layers(fine.width);
  Image colours(fine.width, kRowsAtOnce), out(frame.width, frame.height);
  by_rows(fine.height, [&](int first_row, int rows) {
    layers.depth.restart(first_row, rows);
    fill_layers(layers, field, points, bunches);
    colour_rows(layers, scale, colours);
    out.put_halved(colours, rows, first_row / kOversampling);
  });
  draw_borders(out, border_strokes(field, frame));
  return out;
}

}  // namespace limitgauge::reports
