#include <png.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "reports/picture/deviation_map.h"
#include "reports/picture/lettering.h"
#include "reports/picture/png.h"
#include "reports/picture/stock_picture.h"
#include "tests/reports/sample_result.h"
#include "tests/support/catch.h"

using namespace limitgauge;
using namespace limitgauge::reports;

namespace {

verifier::GateLimits gate(double gouge_mm, double uncut_mm) {
  return {true, true, false, gouge_mm, uncut_mm, 0};
}

verifier::StageDeviation measured(double gouge_mm, double uncut_mm) {
  verifier::StageDeviation d;
  d.gouge_mm = {gouge_mm, gouge_mm}, d.uncut_mm = {uncut_mm, uncut_mm};
  return d;
}

/// How light a colour looks, 0 to 1 (Rec. 709 weights, gamma of 2.2).
double lightness(const Rgba& c) {
  const auto linear = [](int v) { return std::pow(v / 255.0, 2.2); };
  return 0.2126 * linear(c.r) + 0.7152 * linear(c.g) + 0.0722 * linear(c.b);
}

int largest_difference(const Rgba& a, const Rgba& b) {
  return std::max({std::abs(a.r - b.r), std::abs(a.g - b.g), std::abs(a.b - b.b)});
}

/// A level sheet over [0, 40] x [0, 20], deviation from −0.02 at its left to +0.02 at its right.
void add_sheet(verifier::DeviationField& field, double z, double offset_mm, bool reachable) {
  const auto base = static_cast<std::uint32_t>(field.samples.size());
  for (int i = 0; i <= 40; ++i)
    for (int j = 0; j <= 1; ++j) {
      verifier::DeviationField::Sample s;
      s.place = {0, i / 40.0, double(j), {double(i), 20.0 * j, z}};
      s.deviation_mm = static_cast<float>(0.001 * (i - 20) + offset_mm);
      s.reachable = reachable;
      field.samples.push_back(s);
    }
  for (std::uint32_t i = 0; i < 40; ++i)
    field.quads.push_back({base + 2 * i, base + 2 * i + 2, base + 2 * i + 3, base + 2 * i + 1});
}

Rgba map_colour(const Image& map, const MapFrame& frame, double x, double y) {
  const model::Vec2 p = frame.pixel({x, y, 0});
  return map.at(int(p.x), int(p.y));
}

Image decoded(const std::string& bytes) {
  png_image png{};
  png.version = PNG_IMAGE_VERSION;
  REQUIRE(png_image_begin_read_from_memory(&png, bytes.data(), bytes.size()));
  png.format = PNG_FORMAT_RGBA;
  Image image(int(png.width), int(png.height));
  REQUIRE(png_image_finish_read(&png, nullptr, image.pixels().data(), 0, nullptr));
  return image;
}

}  // namespace

TEST_CASE("a picture survives PNG pixel by pixel", "[unit][picture]") {
  Image image(31, 17);
  for (int y = 0; y < 17; ++y)
    for (int x = 0; x < 31; ++x)
      image.at(x, y) = {std::uint8_t(x * 8), std::uint8_t(y * 15), std::uint8_t(x * y),
                        std::uint8_t(255 - x)};
  const Image back = decoded(png_bytes(image));
  REQUIRE((back.width() == 31 && back.height() == 17));
  CHECK(back.pixels() == image.pixels());
  CHECK(png_bytes(image) == png_bytes(image));
}

TEST_CASE("a picture of few colours keeps them all", "[unit][picture]") {
  Image image(64, 4);
  for (int y = 0; y < 4; ++y)
    for (int x = 0; x < 64; ++x)
      image.at(x, y) = {std::uint8_t(4 * x), std::uint8_t(60 * y), 7, std::uint8_t(255 - x)};
  image.at(0, 0) = {0, 0, 0, 0};
  const Image back = read_png(palette_png(image));
  REQUIRE(back.width() == 64);
  CHECK(back.pixels() == image.pixels());
  CHECK_THROWS_AS(read_png("no picture"), std::runtime_error);
}

TEST_CASE("a picture of many colours stays close to them", "[unit][picture]") {
  // A ramp of 1024 greys on a coloured ground: with 256 colours each is off by a step or two of
  // 256.
  Image image(1024, 8);
  for (int y = 0; y < 8; ++y)
    for (int x = 0; x < 1024; ++x)
      image.at(x, y) = {std::uint8_t(x / 4), std::uint8_t((x + 1) / 4 % 256), std::uint8_t(20 * y),
                        255};
  const Image back = read_png(palette_png(image));
  int worst = 0;
  for (std::size_t i = 0; i < image.pixels().size(); ++i)
    worst = std::max({worst, std::abs(image.pixels()[i].r - back.pixels()[i].r),
                      std::abs(image.pixels()[i].b - back.pixels()[i].b)});
  CHECK(worst <= 24);
  CHECK(worst > 0);
}

TEST_CASE("blending and halving keep straight alpha", "[unit][picture]") {
  Image image(2, 2);
  image.at(0, 0) = {200, 100, 0, 255};
  // One pixel in four: the colour stays, a quarter of the cover.
  CHECK(image.halved().at(0, 0) == Rgba{200, 100, 0, 64});
  image.blend(1, 1, {10, 20, 30, 255}, 0.5);
  CHECK(image.at(1, 1) == Rgba{10, 20, 30, 128});
  image.blend(0, 0, {0, 0, 0, 255}, 0.5);
  CHECK(image.at(0, 0) == Rgba{100, 50, 0, 255});
  image.blend(-1, 5, {0, 0, 0, 255}, 1);  // outside: nothing
}

TEST_CASE("the scale is centred on zero and jumps at the limits", "[unit][picture]") {
  const DeviationScale scale = DeviationScale::for_gate(measured(0.002, 0.3), gate(0.01, 0.1));
  CHECK(scale.position(0) == 0);
  CHECK(scale.position(-0.01) == Approx(-0.5));
  CHECK(scale.position(0.1) == Approx(0.5));
  CHECK(scale.gouge().end_mm == Approx(0.02));
  CHECK(scale.uncut().end_mm == Approx(0.5));  // what was measured, 0.3, is on the scale
  CHECK(scale.position(7) == 1);
  for (const double t : {-1.0, -0.7, -0.5, -0.2, 0.0, 0.3, 0.5, 0.9})
    CHECK(scale.position(scale.deviation_mm(t)) == Approx(t).margin(1e-12));
  CHECK(scale.colour(0) == Rgba{247, 247, 247});
  CHECK(largest_difference(scale.colour(0.0999), scale.colour(0.1)) <= 1);
  CHECK(largest_difference(scale.colour(0.1), scale.colour(0.1001)) > 30);
  CHECK(largest_difference(scale.colour(-0.01), scale.colour(-0.01001)) > 30);
}

TEST_CASE("colours darken away from zero and the sides differ in blue and red", "[unit][picture]") {
  for (const bool gated : {true, false}) {
    const verifier::StageDeviation d = measured(0.01, 0.02);
    const DeviationScale scale =
        gated ? DeviationScale::for_gate(d, gate(0.01, 0.01)) : DeviationScale::magnified(d);
    for (const int sign : {-1, 1}) {
      double before = 2;
      for (double t = 0.02; t <= 1; t += 0.02) {
        const Rgba c = scale.colour(scale.deviation_mm(sign * t));
        CHECK(lightness(c) < before);
        CHECK((sign > 0 ? c.r > c.b : c.b > c.r));
        before = lightness(c);
      }
    }
  }
}

TEST_CASE("a map has the scale's colours at known places", "[unit][picture]") {
  verifier::DeviationField field;
  add_sheet(field, 0, 0, true);
  const DeviationScale scale = DeviationScale::for_gate(measured(0.02, 0.02), gate(0.01, 0.01));
  const MapFrame frame = map_frame(field, 600, 600);
  const Image map = draw_map(field, scale, frame);
  REQUIRE(map.width() == 600);
  for (const double x : {2.5, 8.5, 20.0, 25.5, 37.5}) {
    INFO(x);
    // A pixel is 0.07 mm wide here: 0.00007 mm of deviation, within two steps of any ramp.
    CHECK(largest_difference(map_colour(map, frame, x, 10), scale.colour(0.001 * (x - 20))) <= 3);
  }
  CHECK(map.at(1, 1).a == 0);
}

TEST_CASE("a map shows the uppermost surface", "[unit][picture]") {
  verifier::DeviationField field;
  add_sheet(field, 5, 0, true);
  add_sheet(field, 1, 1, false);
  const DeviationScale scale = DeviationScale::for_gate(measured(0.02, 0.02), gate(0.01, 0.01));
  const MapFrame frame = map_frame(field, 300, 300);
  CHECK(largest_difference(map_colour(draw_map(field, scale, frame), frame, 20, 10),
                           scale.colour(0)) <= 3);
}

TEST_CASE("unreachable surface is hatched grey", "[unit][picture]") {
  verifier::DeviationField field;
  add_sheet(field, 0, 1, false);
  const MapFrame frame = map_frame(field, 300, 300);
  const Image map = draw_map(field, DeviationScale::magnified(measured(1, 1)), frame);
  std::set<int> tones;
  for (int x = 100; x < 130; ++x) {
    const Rgba& c = map.at(x, 75);
    CHECK(std::max({c.r, c.g, c.b}) - std::min({c.r, c.g, c.b}) < 14);
    tones.insert(c.r);
  }
  CHECK(*tones.rbegin() - *tones.begin() > 40);
}

TEST_CASE("the deviation picture marks the worst gouge and can draw all its words",
          "[unit][picture]") {
  const RunResult result = sample_result(Outcome::failed);
  const StageResult& stage = result.stages[1];
  const verifier::StageDeviation& d = *stage.ran->deviation;
  const Image picture = decoded(png_bytes(draw_deviation_picture(d, stage.limits)));
  const MapFrame frame = map_frame(d.field, 1400, 1100);
  const model::Vec2 worst = frame.pixel(d.gouges.front().place.point);
  const int margin = 36, ring = 16;
  CHECK(lightness(picture.at(int(worst.x) + margin + ring, int(worst.y) + margin)) < 0.1);
  CHECK(picture.at(2, 2) == Rgba{255, 255, 255});
  CHECK(has_glyphs("uncut gouge limit worst not reachable GU: 0123456789.,+–/ µm mm"));
  CHECK_FALSE(has_glyphs("日"));
}

TEST_CASE("text leaves ink where it is set and nowhere else", "[unit][picture]") {
  Image image(220, 60, {255, 255, 255, 255});
  const TextStyle style{20, {0, 0, 0}};
  draw_text(image, "12.5 µm²", {20, 40}, style);
  const double end = 20 + text_width("12.5 µm²", style);
  REQUIRE(end < 210);
  double ink = 0;
  for (int y = 0; y < 60; ++y)
    for (int x = 0; x < 220; ++x) {
      const double dark = 255 - image.at(x, y).r;
      ink += dark;
      if (x < 19 || x > end + 1 || y < 16 || y > 50) CHECK(dark == 0);
    }
  // At least a hundred full pixels of ink.
  CHECK(ink > 100 * 255);
}

TEST_CASE("a capital stands on the baseline and has the height that was asked for",
          "[unit][picture]") {
  for (const int height : {16, 18, 20, 22, 30, 60}) {
    for (const bool bold : {false, true}) {
      INFO(height << " " << bold);
      Image image(100, 100, {255, 255, 255, 255});
      draw_text(image, "H", {20, 80}, {double(height), {0, 0, 0}, bold});
      int top = 100, bottom = 0;
      for (int y = 0; y < 100; ++y)
        for (int x = 0; x < 100; ++x)
          if (image.at(x, y).r < 128) top = std::min(top, y), bottom = y;
      // Whole pixels and a whole font size.
      CHECK(bottom == 79);
      CHECK(std::abs(bottom - top + 1 - height) <= 1);
    }
  }
}

TEST_CASE("every character has a shape of its own, or the one of what is missing",
          "[unit][picture]") {
  const auto drawn = [](const char* text, int grown = 0) {
    Image image(60, 60, {255, 255, 255, 255});
    draw_text(image, text, {20, 40}, {20, {0, 0, 0}, false, grown});
    return image;
  };
  // Bytes that are no character of their own, were they drawn one by one, would look alike.
  const char* signs[] = {"µ", "²", "³", "≤", "≥", "–", "…", "Ü", "±", "◊"};
  for (const char* a : signs)
    for (const char* b : signs) {
      INFO(a << " " << b);
      CHECK((drawn(a).pixels() == drawn(b).pixels()) == (a == b));
    }
  for (const char* missing : {"日", "\xFF", "\xC3"})
    CHECK(drawn(missing).pixels() == drawn("◊").pixels());
  CHECK(drawn("").pixels() == Image(60, 60, {255, 255, 255, 255}).pixels());
  // A halo covers its letter and more.
  const Image letter = drawn("m"), halo = drawn("m", 3);
  int more = 0;
  for (std::size_t i = 0; i < letter.pixels().size(); ++i) {
    CHECK(halo.pixels()[i].r <= letter.pixels()[i].r);
    more += letter.pixels()[i].r == 255 && halo.pixels()[i].r == 0;
  }
  CHECK(more > 100);
}

TEST_CASE("the stock picture is lit from above", "[unit][picture]") {
  simulator::StockMesh cube;
  for (int i = 0; i < 8; ++i)
    cube.vertices.push_back({double(i & 1), double(i >> 1 & 1), double(i >> 2 & 1)});
  // One vertex a face corner, so that the faces keep their own normals.
  simulator::StockMesh mesh;
  const int faces[6][4] = {{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4},
                           {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}};
  for (const auto& f : faces) {
    const auto base = static_cast<std::uint32_t>(mesh.vertices.size());
    for (const int corner : f) mesh.vertices.push_back(cube.vertices[corner]);
    mesh.triangles.push_back({base, base + 1, base + 2});
    mesh.triangles.push_back({base, base + 2, base + 3});
  }
  const Image image = draw_stock_picture(mesh, 400);
  REQUIRE(image.width() == 400);
  const int middle = image.width() / 2;
  int top = 0;
  while (image.at(middle, top).a < 255) ++top;
  int bottom = image.height() - 1;
  while (image.at(middle, bottom).a < 255) --bottom;
  CHECK(lightness(image.at(middle, top + 20)) > 1.5 * lightness(image.at(middle, bottom - 20)));
  CHECK(image.at(2, 2).a == 0);
}
