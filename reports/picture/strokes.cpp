#include "reports/picture/strokes.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>

namespace limitgauge::reports {
namespace {

constexpr double kCapital = 10;  ///< height of a capital in glyph units
constexpr double kGap = 2.6;     ///< between glyphs
constexpr double kSpace = 1.6;

/// Strokes are parted by spaces. A point is a digit for x and a letter for y, 'd' on the baseline,
/// 'k' the height of an x, 'n' of a capital, 'a' of a descender. A stroke that begins with '~' is
/// smoothed, with '@' smoothed and closed.
struct Glyph {
  std::string_view character;
  std::string_view strokes;
};
constexpr Glyph kGlyphs[] = {
    {"0", "@0d6d6n0n"},
    {"1", "0k3n3d"},
    {"2", "~0l0n6n6k6i0d 0d6d"},
    {"3", "~0l0n5n5i2i ~2i6i6d0d0f"},
    {"4", "4d4n0g6g"},
    {"5", "6n1n0i ~0i2j6j6d0d0e"},
    {"6", "~5n0n0g @0d6d6j0j"},
    {"7", "0n6n2d"},
    {"8", "@1i5i5n1n @0d6d6i0i"},
    {"9", "@0h6h6n0n ~6k6d1d"},
    {".", "0d"},
    {",", "1d0b"},
    {":", "0d 0j"},
    {"-", "0h4h"},
    {"–", "0h6h"},
    {"+", "0h6h 3e3k"},
    {"/", "0c5n"},
    {"(", "~2n0k0f2c"},
    {")", "~0n2k2f0c"},
    {"=", "0f6f 0j6j"},
    {"≤", "6m0j6g 0d6d"},
    {"≥", "0m6j0g 0d6d"},
    {"µ", "0a0k ~0g0d5d5g 5k5d"},
    {"a", "@0d5d5k0k 5k5d"},
    {"b", "0n0d @0d5d5k0k"},
    {"c", "~5i5k0k0d5d5f"},
    {"d", "@0d5d5k0k 5n5d"},
    {"e", "0h5h ~5h5k0k0d5d5e"},
    {"f", "~4n2n2l2d 0k4k"},
    {"g", "@0d5d5k0k ~5k5d5a0a0b"},
    {"h", "0n0d ~0h0k5k5h5d"},
    {"i", "0k0d 0n"},
    {"j", "~2k2b2a0a 2n"},
    {"k", "0n0d 5k0g 2h5d"},
    {"l", "0n0d"},
    {"m", "0k0d ~0h0k4k4h4d ~4h4k8k8h8d"},
    {"n", "0k0d ~0h0k5k5h5d"},
    {"o", "@0d5d5k0k"},
    {"p", "0k0a @0d5d5k0k"},
    {"q", "5k5a @0d5d5k0k"},
    {"r", "0k0d ~0h0k3k"},
    {"s", "~5j5k0k0g5h5d0d0e"},
    {"t", "~2n2f2d4d 0k4k"},
    {"u", "~0k0g0d5d5g 5k5d"},
    {"v", "0k3d6k"},
    {"w", "0k2d4k6d8k"},
    {"x", "0k5d 5k0d"},
    {"y", "0k3d 6k3d1a"},
    {"z", "0k5k0d5d"},
    {"A", "0d3n6d 1g5g"},
    {"B", "0d0n4n5m5j4i0i 4i6h6e5d0d"},
    {"C", "~6l6n0n0d6d6f"},
    {"D", "0d0n3n ~3n6n6d3d 3d0d"},
    {"E", "6n0n0d6d 0i4i"},
    {"F", "6n0n0d 0i4i"},
    {"G", "~6l6n0n0d6d6h 6h3h"},
    {"H", "0n0d 6n6d 0i6i"},
    {"I", "0n0d"},
    {"J", "~4n4d0d0f"},
    {"K", "0n0d 6n0h 2j6d"},
    {"L", "0n0d5d"},
    {"M", "0d0n4g8n8d"},
    {"N", "0d0n6d6n"},
    {"O", "@0d7d7n0n"},
    {"P", "0d0n3n ~3n6n6h3h 3h0h"},
    {"Q", "@0d7d7n0n 4g7c"},
    {"R", "0d0n3n ~3n6n6h3h 3h0h 3h6d"},
    {"S", "~6l6n0n0i6i6d0d0f"},
    {"T", "0n6n 3n3d"},
    {"U", "~0n0d6d6n"},
    {"V", "0n3d6n"},
    {"W", "0n2d4n6d8n"},
    {"X", "0n6d 6n0d"},
    {"Y", "0n3i6n 3i3d"},
    {"Z", "0n6n0d6d"},
    {"_", "0c6c"},
    {"%", "@0j2j2n0n @5d7d7h5h 6n1d"},
    {"#", "2n1d 5n4d 0k6k 0g6g"},
    {"[", "2n0n0c2c"},
    {"]", "0n2n2c0c"},
    {"<", "5k0h5e"},
    {">", "0k5h0e"},
    {"'", "0n0l"},
    {"\"", "0n0l 2n2l"},
    {"!", "0n0g 0d"},
    {"?", "~0l0n5n5i2i 2i2g 2d"},
    {"*", "2l2h 0k4i 4k0i"},
    {"&", "6d1l ~1l1n4n4l 4l0g ~0g0d4d6h"},
    {"@", "@2f5f5j2j ~5j5f8f8n0n0d6d"},
    {"$", "~5l5m0m0i5i5e0e0f 3o3c"},
    {";", "1d0b 1j"},
    {"|", "0n0c"},
    {"\\", "0n5c"},
    {"~", "~0g0j3i3g6g6j"},
    {"^", "0k2n4k"},
    {"`", "0n2l"},
    {"{", "3n1n1i0h1g1c3c"},
    {"}", "0n2n2i3h2g2c0c"},
    {"…", "0d 3d 6d"},
    {"\xEF\xBF\xBD", "0d0n6n6d0d"},
};

/// Takes the first character off `text`.
std::string_view next_character(std::string_view& text) {
  std::size_t n = 1;
  while (n < text.size() && (static_cast<unsigned char>(text[n]) & 0xC0) == 0x80) ++n;
  const std::string_view head = text.substr(0, n);
  text.remove_prefix(n);
  return head;
}

const Glyph* find_glyph(std::string_view character) {
  const auto* end = std::end(kGlyphs);
  const auto* glyph = std::find_if(std::begin(kGlyphs), end,
                                   [&](const Glyph& g) { return g.character == character; });
  return glyph == end ? nullptr : glyph;
}

/// What is drawn for `character`: a box where it has no glyph, so that names of any writing keep
/// their length. None for a blank.
const Glyph* shown_glyph(std::string_view character) {
  const Glyph* glyph = find_glyph(character);
  return glyph || character == " " ? glyph : find_glyph("\xEF\xBF\xBD");
}

/// One round of Chaikin's corner cutting; an open line keeps its ends.
std::vector<PixelPoint> with_corners_cut(const std::vector<PixelPoint>& line, bool closed) {
  std::vector<PixelPoint> out;
  const std::size_t n = line.size();
  if (!closed) out.push_back(line.front());
  for (std::size_t i = 0; i + (closed ? 0 : 1) < n; ++i) {
    const PixelPoint &a = line[i], &b = line[(i + 1) % n];
    out.push_back({0.75 * a.x + 0.25 * b.x, 0.75 * a.y + 0.25 * b.y});
    out.push_back({0.25 * a.x + 0.75 * b.x, 0.25 * a.y + 0.75 * b.y});
  }
  if (!closed) out.push_back(line.back());
  return out;
}

std::vector<PixelPoint> decoded(std::string_view stroke) {
  const bool closed = stroke.front() == '@', smooth = closed || stroke.front() == '~';
  if (smooth) stroke.remove_prefix(1);
  std::vector<PixelPoint> line;
  for (std::size_t i = 0; i + 1 < stroke.size(); i += 2)
    line.push_back({double(stroke[i] - '0'), double(stroke[i + 1] - 'd')});
  if (smooth)
    for (int round = 0; round < 3; ++round) line = with_corners_cut(line, closed);
  if (closed) line.push_back(line.front());
  return line;
}

double glyph_width(const Glyph& glyph) {
  double width = 0;
  for (std::size_t i = 0; i < glyph.strokes.size(); ++i)
    if (glyph.strokes[i] >= '0' && glyph.strokes[i] <= '9')
      width = std::max(width, double(glyph.strokes[i] - '0'));
  return width;
}

double distance_to_segment(const PixelPoint& p, const PixelPoint& a, const PixelPoint& b) {
  const double dx = b.x - a.x, dy = b.y - a.y, length2 = dx * dx + dy * dy;
  const double t =
      length2 > 0 ? std::clamp(((p.x - a.x) * dx + (p.y - a.y) * dy) / length2, 0.0, 1.0) : 0;
  return std::hypot(p.x - a.x - t * dx, p.y - a.y - t * dy);
}

void draw_glyph(Image& image, const Glyph& glyph, const PixelPoint& at, const TextStyle& style) {
  const double unit = style.height / kCapital;
  std::string_view rest = glyph.strokes;
  while (!rest.empty()) {
    const std::size_t end = std::min(rest.find(' '), rest.size());
    std::vector<PixelPoint> line = decoded(rest.substr(0, end));
    for (PixelPoint& p : line) p = {at.x + p.x * unit, at.y - p.y * unit};
    draw_stroke(image, line, style.weight * style.height, style.colour);
    rest.remove_prefix(std::min(end + 1, rest.size()));
  }
}

}  // namespace

void draw_stroke(Image& image, const std::vector<PixelPoint>& line, double width,
                 const Rgba& colour) {
  const auto [left, right] = std::minmax_element(
      line.begin(), line.end(), [](const auto& a, const auto& b) { return a.x < b.x; });
  const auto [top, bottom] = std::minmax_element(
      line.begin(), line.end(), [](const auto& a, const auto& b) { return a.y < b.y; });
  for (int y = int(std::floor(top->y - width)); y <= int(bottom->y + width); ++y) {
    for (int x = int(std::floor(left->x - width)); x <= int(right->x + width); ++x) {
      const PixelPoint p{x + 0.5, y + 0.5};
      double d = std::hypot(p.x - line[0].x, p.y - line[0].y);
      for (std::size_t i = 0; i + 1 < line.size(); ++i)
        d = std::min(d, distance_to_segment(p, line[i], line[i + 1]));
      const double coverage = width / 2 - d + 0.5;
      if (coverage > 0) image.blend(x, y, colour, coverage);
    }
  }
}

void draw_ring(Image& image, const PixelPoint& centre, double radius, double width,
               const Rgba& colour) {
  std::vector<PixelPoint> circle;
  constexpr int kCorners = 48;
  for (int i = 0; i <= kCorners; ++i) {
    const double angle = 2 * std::numbers::pi * i / kCorners;
    circle.push_back({centre.x + radius * std::cos(angle), centre.y + radius * std::sin(angle)});
  }
  draw_stroke(image, circle, width, colour);
}

void draw_text(Image& image, std::string_view text, const PixelPoint& at, const TextStyle& style) {
  double x = at.x;
  while (!text.empty()) {
    const std::string_view character = next_character(text);
    const Glyph* glyph = shown_glyph(character);
    if (glyph) draw_glyph(image, *glyph, {x, at.y}, style);
    x += text_width(character, style.height) + kGap * style.height / kCapital;
  }
}

double text_width(std::string_view text, double height) {
  double width = 0;
  bool first = true;
  while (!text.empty()) {
    const Glyph* glyph = shown_glyph(next_character(text));
    width += (first ? 0 : kGap) + (glyph ? glyph_width(*glyph) : kSpace);
    first = false;
  }
  return width * height / kCapital;
}

bool has_glyphs(std::string_view text) {
  while (!text.empty()) {
    const std::string_view character = next_character(text);
    if (character != " " && !find_glyph(character)) return false;
  }
  return true;
}

}  // namespace limitgauge::reports
