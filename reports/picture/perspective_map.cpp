#include "reports/picture/perspective_map.h"

#include <algorithm>
#include <cmath>

#include "reports/picture/deviation_map.h"
#include "reports/picture/quad_bunches.h"

namespace limitgauge::reports {
namespace {

using model::Vec3;
using Sample = verifier::DeviationField::Sample;

constexpr int kOversampling = 2;
constexpr Rgba kBorder{20, 24, 30, 90}, kBack{120, 124, 130};
/// Colours must stay those of the bar: light takes a fifth of them at most.
constexpr double kDarkest = 0.8;

/// What the nearest surface holds at each pixel, where there is one. The same memory is for all
/// rows.
struct Layers {
  explicit Layers(std::size_t pixels) : deviation_mm(pixels), reachable(pixels), light(pixels) {}
  std::vector<float> deviation_mm, reachable;
  std::vector<float> light;  ///< 0 to 1; minus that where the surface is seen from its back
};

/// Light from above and behind the viewer's left shoulder.
struct Lamp {
  explicit Lamp(const PerspectiveView& view)
      : direction(model::normalized(view.towards() * 0.5 + view.up() * 0.75 - view.right() * 0.7)) {
  }
  /// How much falls on a surface with this normal that is seen along `to_eye`.
  float on(const Vec3& normal, const Vec3& to_eye) const {
    const bool back = model::dot(normal, to_eye) < 0;
    const double facing = model::dot(model::normalized(normal), direction);
    const double light = std::max(0.05, back ? -facing : facing);
    return static_cast<float>(back ? -light : light);
  }
  Vec3 direction;
};

std::vector<ScreenPoint> screen_points(const verifier::DeviationField& field,
                                       const PerspectiveView& view) {
  std::vector<ScreenPoint> points;
  points.reserve(field.samples.size());
  for (const Sample& s : field.samples) points.push_back(view.project(s.place.point));
  return points;
}

template <typename Paint>
void fill_quads(DepthBuffer& depth, const verifier::DeviationField& field,
                const std::vector<ScreenPoint>& points, const QuadBunches& bunches, Paint&& paint) {
  const auto fill = [&](std::uint32_t a, std::uint32_t b, std::uint32_t c) {
    const std::array<ScreenPoint, 3> corners{points[a], points[b], points[c]};
    depth.fill_triangle(corners, [&](std::size_t pixel, const auto& on_screen) {
      paint(pixel, field.samples[a], field.samples[b], field.samples[c],
            in_space(on_screen, corners));
    });
  };
  bunches.each(depth, [&](const auto& q) { fill(q[0], q[1], q[2]), fill(q[0], q[2], q[3]); });
}

void fill_layers(DepthBuffer& depth, Layers& layers, const verifier::DeviationField& field,
                 const std::vector<ScreenPoint>& points, const QuadBunches& bunches,
                 const PerspectiveView& view) {
  const Lamp lamp(view);
  fill_quads(depth, field, points, bunches,
             [&](std::size_t i, const Sample& a, const Sample& b, const Sample& c, const auto& w) {
               layers.deviation_mm[i] = static_cast<float>(
                   w[0] * a.deviation_mm + w[1] * b.deviation_mm + w[2] * c.deviation_mm);
               layers.reachable[i] =
                   static_cast<float>(w[0] * a.reachable + w[1] * b.reachable + w[2] * c.reachable);
               const Vec3 p = a.place.point * w[0] + b.place.point * w[1] + c.place.point * w[2];
               layers.light[i] =
                   lamp.on(a.normal * w[0] + b.normal * w[1] + c.normal * w[2], view.eye() - p);
             });
}

Rgba shaded(const Rgba& colour, float light) {
  const double share = kDarkest + (1 - kDarkest) * std::min(1.0, 1.25 * std::abs(double(light)));
  const Rgba shade = mixed({0, 0, 0}, colour, share);
  return light < 0 ? mixed(shade, kBack, 0.45) : shade;
}

/// Places along the borders of patches, a pixel apart at most.
std::vector<ScreenPoint> border_points(const verifier::DeviationField& field,
                                       const std::vector<ScreenPoint>& points,
                                       const PerspectiveView& view) {
  std::vector<ScreenPoint> along;
  visit_borders(field, [&](std::size_t i, std::size_t j) {
    const Sample &a = field.samples[i], &b = field.samples[j];
    const int steps = 1 + int(std::hypot(points[j].x - points[i].x, points[j].y - points[i].y));
    for (int n = 0; n <= steps; ++n)
      along.push_back(view.project(model::lerp(a.place.point, b.place.point, double(n) / steps)));
  });
  return along;
}

/// Pixels of the finer picture that have a border. Both patches have their common one: it is
/// collected first, then blended once.
class BorderMask {
 public:
  BorderMask(int width, int height)
      : width_(width), height_(height), is_border_(std::size_t(width) * height) {}
  /// Those of `along` that are seen in the rows of `depth`, and what they reach of the next one.
  void mark(const std::vector<ScreenPoint>& along, const DepthBuffer& depth) {
    for (const ScreenPoint& at : along) {
      const int x = int(std::floor(at.x)), y = int(std::floor(at.y));
      if (!depth.pixel_at(x, y) || !is_in_sight(at, depth)) continue;
      for (int dy = 0; dy < kOversampling; ++dy)
        for (int dx = 0; dx < kOversampling; ++dx)
          if (x + dx < width_ && y + dy < height_)
            is_border_[std::size_t(y + dy) * width_ + x + dx] = true;
    }
  }
  /// On the first `rows` rows of `image`, which are those of the screen from `first_row` on.
  void draw(Image& image, int first_row, int rows) const {
    for (int y = 0; y < rows; ++y)
      for (int x = 0; x < width_; ++x)
        if (is_border_[std::size_t(first_row + y) * width_ + x]) image.blend(x, y, kBorder, 1);
  }

 private:
  int width_, height_;
  std::vector<bool> is_border_;
};

/// Puts the colours of the rows of `depth` into `image`, in the light.
void colour_lit_rows(const DepthBuffer& depth, const Layers& layers, const DeviationScale& scale,
                     Image& image) {
  const std::size_t width = depth.width(), pixels = width * depth.height();
  for (std::size_t i = 0; i < pixels; ++i) {
    if (depth.is_empty(i)) {
      image.pixels()[i] = {0, 0, 0, 0};
      continue;
    }
    const Rgba colour = layers.reachable[i] < 0.5f
                            ? hatch_colour(i % width, depth.first_row() + i / width)
                            : scale.colour(layers.deviation_mm[i]);
    image.pixels()[i] = shaded(colour, layers.light[i]);
  }
}

}  // namespace

bool is_in_sight(const ScreenPoint& p, const DepthBuffer& depth) {
  // A little nearer than the surface that it lies on, which pixels see from their centres.
  constexpr double kNearer = 1.004;
  const auto pixel = depth.pixel_at(int(std::floor(p.x)), int(std::floor(p.y)));
  if (!pixel) return false;
  return depth.is_empty(*pixel) || p.z * kNearer >= depth.nearest(*pixel);
}

DepthBuffer perspective_depth(const verifier::DeviationField& field, const PerspectiveView& view) {
  DepthBuffer depth(view.width(), view.height());
  const std::vector<ScreenPoint> points = screen_points(field, view);
  fill_quads(depth, field, points, QuadBunches(field, points), [](auto&&...) {});
  return depth;
}

PerspectiveMap draw_perspective_map(const verifier::DeviationField& field,
                                    const DeviationScale& scale, const PerspectiveView& view,
                                    std::span<const Vec3> places) {
  const PerspectiveView fine = view.scaled(kOversampling);
  const std::vector<ScreenPoint> points = screen_points(field, fine);
  const std::vector<ScreenPoint> borders = border_points(field, points, fine);
  const QuadBunches bunches(field, points);
  BorderMask mask(fine.width(), fine.height());
  DepthBuffer part(fine.width(), kRowsAtOnce);
  std::vector<bool> in_sight(places.size());
  Layers layers(std::size_t(fine.width()) * kRowsAtOnce);
  Image colours(fine.width(), kRowsAtOnce);
  Image image(fine.width() / kOversampling, fine.height() / kOversampling);
  by_rows(fine.height() / kOversampling * kOversampling, [&](int first_row, int rows) {
    part.restart(first_row, rows);
    fill_layers(part, layers, field, points, bunches, fine);
    mask.mark(borders, part);
    for (std::size_t i = 0; i < places.size(); ++i)
      if (is_in_sight(fine.project(places[i]), part)) in_sight[i] = true;
    colour_lit_rows(part, layers, scale, colours);
    mask.draw(colours, first_row, rows);
    image.put_halved(colours, rows, first_row / kOversampling);
  });
  return {std::move(image), std::move(in_sight)};
}

}  // namespace limitgauge::reports
