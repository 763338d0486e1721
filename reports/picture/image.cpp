#include "reports/picture/image.h"

#include <algorithm>

namespace limitgauge::reports {
namespace {

/// The mean of four pixels, each colour weighed by its alpha.
Rgba mean(const Rgba& p, const Rgba& q, const Rgba& r, const Rgba& s) {
  if (p.a == 255 && q.a == 255 && r.a == 255 && s.a == 255) {
    const auto of = [](int a, int b, int c, int d) {
      return static_cast<std::uint8_t>((a + b + c + d + 2) / 4);
    };
    return {of(p.r, q.r, r.r, s.r), of(p.g, q.g, r.g, s.g), of(p.b, q.b, r.b, s.b), 255};
  }
  double sum[3] = {}, alpha = 0;
  for (const Rgba* c : {&p, &q, &r, &s}) {
    sum[0] += c->r * c->a, sum[1] += c->g * c->a, sum[2] += c->b * c->a;
    alpha += c->a;
  }
  if (alpha == 0) return {0, 0, 0, 0};
  return {channel(sum[0] / alpha), channel(sum[1] / alpha), channel(sum[2] / alpha),
          channel(alpha / 4)};
}

}  // namespace

Image::Image(int width, int height, Rgba fill)
    : width_(width), height_(height), pixels_(std::size_t(width) * height, fill) {}

void Image::blend(int x, int y, const Rgba& colour, double coverage) {
  if (!holds(x, y)) return;
  Rgba& under = at(x, y);
  if (colour.a == 0) return;
  if (colour.a == 255 && coverage >= 1) {
    under = colour;
    return;
  }
  const double over = std::clamp(coverage, 0.0, 1.0) * colour.a / 255.0;
  const double below = under.a / 255.0 * (1 - over), alpha = over + below;
  if (alpha == 0) return;
  const auto mix = [&](double a, double b) { return channel((a * over + b * below) / alpha); };
  under = {mix(colour.r, under.r), mix(colour.g, under.g), mix(colour.b, under.b),
           channel(alpha * 255)};
}

void Image::draw(const Image& other, int x0, int y0) {
  for (int y = 0; y < other.height(); ++y)
    for (int x = 0; x < other.width(); ++x) blend(x0 + x, y0 + y, other.at(x, y), 1);
}

void Image::fill(int x0, int y0, int width, int height, const Rgba& colour) {
  for (int y = std::max(y0, 0); y < std::min(y0 + height, height_); ++y)
    for (int x = std::max(x0, 0); x < std::min(x0 + width, width_); ++x) at(x, y) = colour;
}

Image Image::halved() const {
  Image out(width_ / 2, height_ / 2);
  out.put_halved(*this, height_, 0);
  return out;
}

void Image::put_halved(const Image& fine, int rows, int y0) {
  for (int y = 0; y < rows / 2; ++y) {
    const Rgba *upper = &fine.at(0, 2 * y), *lower = &fine.at(0, 2 * y + 1);
    for (int x = 0; x < width_; ++x, upper += 2, lower += 2)
      at(x, y0 + y) = mean(upper[0], upper[1], lower[0], lower[1]);
  }
}

}  // namespace limitgauge::reports
