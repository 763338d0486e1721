#include "reports/picture/perspective_map.h"

#include <algorithm>
#include <cmath>

#include "reports/picture/deviation_map.h"

namespace limitgauge::reports {
namespace {

using model::Vec3;
using Sample = verifier::DeviationField::Sample;

constexpr int kOversampling = 2;
constexpr Rgba kBorder{20, 24, 30, 90}, kBack{120, 124, 130};
/// Colours must stay those of the bar: light takes a fifth of them at most.
constexpr double kDarkest = 0.8;

/// What the nearest surface holds at each pixel.
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

template <typename Paint>
void fill_quads(DepthBuffer& depth, const verifier::DeviationField& field,
                const PerspectiveView& view, Paint&& paint) {
  std::vector<ScreenPoint> points;
  points.reserve(field.samples.size());
  for (const Sample& s : field.samples) points.push_back(view.project(s.place.point));
  const auto fill = [&](std::uint32_t a, std::uint32_t b, std::uint32_t c) {
    const std::array<ScreenPoint, 3> corners{points[a], points[b], points[c]};
    depth.fill_triangle(corners, [&](std::size_t pixel, const auto& on_screen) {
      paint(pixel, field.samples[a], field.samples[b], field.samples[c],
            in_space(on_screen, corners));
    });
  };
  for (const auto& q : field.quads) fill(q[0], q[1], q[2]), fill(q[0], q[2], q[3]);
}

void fill_layers(DepthBuffer& depth, Layers& layers, const verifier::DeviationField& field,
                 const PerspectiveView& view) {
  const Lamp lamp(view);
  fill_quads(depth, field, view,
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

/// Both patches have their common border: it is collected first, then blended once.
void draw_borders(Image& image, const DepthBuffer& depth, const verifier::DeviationField& field,
                  const PerspectiveView& view) {
  std::vector<bool> is_border(image.pixels().size());
  const auto mark = [&](const Vec3& p) {
    const ScreenPoint at = view.project(p);
    if (!is_in_sight(at, depth)) return;
    for (int dy = 0; dy < kOversampling; ++dy)
      for (int dx = 0; dx < kOversampling; ++dx)
        if (image.holds(int(at.x) + dx, int(at.y) + dy))
          is_border[std::size_t(int(at.y) + dy) * image.width() + int(at.x) + dx] = true;
  };
  for (const auto& quad : field.quads) {
    for (int k = 0; k < 4; ++k) {
      const Sample &a = field.samples[quad[k]], &b = field.samples[quad[(k + 1) % 4]];
      if (!on_patch_border(a, b)) continue;
      const ScreenPoint from = view.project(a.place.point), to = view.project(b.place.point);
      const int steps = 1 + int(std::hypot(to.x - from.x, to.y - from.y));
      for (int i = 0; i <= steps; ++i)
        mark(model::lerp(a.place.point, b.place.point, double(i) / steps));
    }
  }
  for (std::size_t i = 0; i < is_border.size(); ++i)
    if (is_border[i]) image.blend(int(i % image.width()), int(i / image.width()), kBorder, 1);
}

}  // namespace

bool is_in_sight(const ScreenPoint& p, const DepthBuffer& depth) {
  // A little nearer than the surface that it lies on, which pixels see from their centres.
  constexpr double kNearer = 1.004;
  const int x = int(std::floor(p.x)), y = int(std::floor(p.y));
  if (x < 0 || y < 0 || x >= depth.width() || y >= depth.height()) return false;
  const std::size_t pixel = std::size_t(y) * depth.width() + x;
  return depth.is_empty(pixel) || p.z * kNearer >= depth.nearest(pixel);
}

DepthBuffer perspective_depth(const verifier::DeviationField& field, const PerspectiveView& view) {
  DepthBuffer depth(view.width(), view.height());
  fill_quads(depth, field, view, [](auto&&...) {});
  return depth;
}

PerspectiveMap draw_perspective_map(const verifier::DeviationField& field,
                                    const DeviationScale& scale, const PerspectiveView& view) {
  const PerspectiveView fine = view.scaled(kOversampling);
  Image image(fine.width(), fine.height());
  DepthBuffer depth(fine.width(), fine.height());
  Layers layers(image.pixels().size());
  fill_layers(depth, layers, field, fine);
  for (std::size_t i = 0; i < image.pixels().size(); ++i) {
    if (depth.is_empty(i)) continue;
    const Rgba colour = layers.reachable[i] < 0.5f
                            ? hatch_colour(i % fine.width(), i / fine.width())
                            : scale.colour(layers.deviation_mm[i]);
    image.pixels()[i] = shaded(colour, layers.light[i]);
  }
  draw_borders(image, depth, field, fine);
  return {image.halved(), std::move(depth), kOversampling};
}

}  // namespace limitgauge::reports
