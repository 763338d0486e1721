#pragma once

#include <algorithm>
#include <cstdint>
#include <vector>

namespace limitgauge::reports {

/// A colour with straight (not premultiplied) alpha, 8 bits a channel, sRGB.
struct Rgba {
  std::uint8_t r = 0, g = 0, b = 0, a = 255;
  friend constexpr bool operator==(const Rgba&, const Rgba&) = default;
};
/// The channel's value nearest to `value`.
inline std::uint8_t channel(double value) {
  return static_cast<std::uint8_t>(std::clamp(value, 0.0, 255.0) + 0.5);
}
/// `t` = 0 gives `from`, 1 gives `to`. Asked for millions of pixels.
inline Rgba mixed(const Rgba& from, const Rgba& to, double t) {
  const auto mix = [t](double a, double b) { return channel(a + (b - a) * t); };
  return {mix(from.r, to.r), mix(from.g, to.g), mix(from.b, to.b), mix(from.a, to.a)};
}

/// A picture, row by row from the top; a new one is transparent.
class Image {
 public:
  Image(int width, int height, Rgba fill = {0, 0, 0, 0});
  int width() const { return width_; }
  int height() const { return height_; }
  const Rgba& at(int x, int y) const { return pixels_[std::size_t(y) * width_ + x]; }
  Rgba& at(int x, int y) { return pixels_[std::size_t(y) * width_ + x]; }
  const std::vector<Rgba>& pixels() const { return pixels_; }
  std::vector<Rgba>& pixels() { return pixels_; }
  bool holds(int x, int y) const { return x >= 0 && y >= 0 && x < width_ && y < height_; }

  /// Puts `colour` over what is there, with `coverage` (0 to 1) of its alpha.
  void blend(int x, int y, const Rgba& colour, double coverage);
  /// Puts `other` over this picture, its upper left corner at (x, y).
  void draw(const Image& other, int x, int y);
  void fill(int x, int y, int width, int height, const Rgba& colour);
  /// The picture at half the size, each pixel the mean of four.
  Image halved() const;
  /// Puts the first `rows` rows of `fine`, twice as wide as this picture, in place of what is there
  /// from row `y` on, at half the size.
  void put_halved(const Image& fine, int rows, int y);

 private:
  int width_, height_;
  std::vector<Rgba> pixels_;
};

}  // namespace limitgauge::reports
