#include <cmath>

#include "reports/picture/lettering.h"
#include "reports/picture/marker.h"
#include "reports/picture/perspective_map.h"
#include "reports/picture/perspective_picture.h"
#include "tests/reports/sample_result.h"
#include "tests/support/catch.h"

using namespace limitgauge;
using namespace limitgauge::reports;
using model::Vec3;

namespace {

/// A level sheet over [0, 40] x [0, 40] at height z of one deviation, n x n samples.
void add_sheet(verifier::DeviationField& field, double z, double deviation_mm, int n = 21,
               bool reachable = true) {
  const auto base = static_cast<std::uint32_t>(field.samples.size());
  for (int j = 0; j < n; ++j)
    for (int i = 0; i < n; ++i) {
      verifier::DeviationField::Sample s;
      const double u = double(i) / (n - 1), v = double(j) / (n - 1);
      s.place = {0, u, v, {40 * u, 40 * v, z}};
      s.normal = {0, 0, 1};
      s.deviation_mm = static_cast<float>(deviation_mm);
      s.reachable = reachable;
      field.samples.push_back(s);
    }
  const auto at = [&](int i, int j) { return base + static_cast<std::uint32_t>(j * n + i); };
  for (int j = 0; j + 1 < n; ++j)
    for (int i = 0; i + 1 < n; ++i)
      field.quads.push_back({at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)});
}

const Vec3 kFront{0.52, -0.95, 0.80};

DeviationScale scale_of_one() {
  verifier::StageDeviation d;
  d.gouge_mm = d.uncut_mm = {1, 1};
  return DeviationScale::magnified(d);
}

/// Red over blue: how much of uncut or gouge a colour shows.
double redness(const Rgba& c) {
  return double(c.r) - double(c.b);
}

Rgba colour_at(const Image& image, const PerspectiveView& view, const Vec3& p) {
  const ScreenPoint at = view.project(p);
  return image.at(int(at.x), int(at.y));
}

}  // namespace

TEST_CASE("a view in perspective keeps lines straight and makes near things larger",
          "[unit][picture]") {
  verifier::DeviationField field;
  add_sheet(field, 0, 0);
  const PerspectiveView view(field, kFront, 800, 600);
  const auto on_screen = [&](double x, double y) { return view.project({x, y, 0}); };
  // Nearer to the viewer, who stands at the front right, the same length is longer.
  const auto width = [&](double y) {
    const ScreenPoint a = on_screen(0, y), b = on_screen(40, y);
    return std::hypot(b.x - a.x, b.y - a.y);
  };
  CHECK(width(0) > 1.15 * width(40));
  const ScreenPoint a = on_screen(0, 0), b = on_screen(20, 20), c = on_screen(40, 40);
  CHECK((b.x - a.x) * (c.y - a.y) - (c.x - a.x) * (b.y - a.y) == Approx(0).margin(1e-6));
  // Four collinear points keep their cross ratio: 4/3 for equal steps.
  const double x0 = on_screen(0, 5).x, x1 = on_screen(10, 5).x, x2 = on_screen(20, 5).x,
               x3 = on_screen(30, 5).x;
  CHECK((x2 - x0) * (x3 - x1) / ((x2 - x1) * (x3 - x0)) == Approx(4.0 / 3));
  for (const auto& s : field.samples) {
    const ScreenPoint p = view.project(s.place.point);
    CHECK((p.x >= 29 && p.x <= 771 && p.y >= 29 && p.y <= view.height() - 29.0));
  }
}

TEST_CASE("weights on the screen become weights in space", "[property][picture]") {
  verifier::DeviationField field;
  add_sheet(field, 0, 0);
  const PerspectiveView view(field, kFront, 900, 700);
  const std::array<Vec3, 3> corners{{{0, 0, 0}, {40, 5, 3}, {10, 40, -6}}};
  const std::array<ScreenPoint, 3> t{view.project(corners[0]), view.project(corners[1]),
                                     view.project(corners[2])};
  for (int i = 1; i < 10; ++i)
    for (int j = 1; i + j < 10; ++j) {
      // A place on the screen, by its weights there; the point in space must lie behind it.
      const std::array<double, 3> screen{1 - 0.1 * (i + j), 0.1 * i, 0.1 * j};
      const std::array<double, 3> w = in_space(screen, t);
      const Vec3 p = corners[0] * w[0] + corners[1] * w[1] + corners[2] * w[2];
      const ScreenPoint seen = view.project(p);
      CHECK(seen.x == Approx(screen[0] * t[0].x + screen[1] * t[1].x + screen[2] * t[2].x));
      CHECK(seen.y == Approx(screen[0] * t[0].y + screen[1] * t[1].y + screen[2] * t[2].y));
      CHECK(seen.z == Approx(screen[0] * t[0].z + screen[1] * t[1].z + screen[2] * t[2].z));
    }
}

TEST_CASE("a perspective map has the scale's colours, lit, and hides what lies behind",
          "[unit][picture]") {
  verifier::DeviationField field;
  add_sheet(field, 10, 0.9);
  add_sheet(field, 0, -0.9);
  const PerspectiveView view(field, kFront, 500, 400);
  // On the upper sheet, and on the lower one under it.
  const std::vector<Vec3> places{{21, 21, 10}, {21, 30, 0}};
  const PerspectiveMap map = draw_perspective_map(field, scale_of_one(), view, places);
  CHECK(redness(colour_at(map.image, view, {21, 21, 10})) > 60);
  // The lower sheet shows at the front, below the edge of the upper one.
  CHECK(redness(colour_at(map.image, view, {39, 1, 0})) < -60);
  CHECK(map.in_sight == std::vector{true, false});
  CHECK(map.image.at(1, 1).a == 0);
  // The darkest light leaves four fifths of a colour.
  const Rgba full = scale_of_one().colour(0.9), seen = colour_at(map.image, view, {21, 21, 10});
  CHECK(seen.r >= 0.79 * full.r);
  CHECK(seen.r <= full.r + 1);
}

TEST_CASE("the perspective picture marks the worst gouge where it is", "[unit][picture]") {
  const RunResult result = sample_result(Outcome::failed);
  const StageResult& stage = result.stages[1];
  const Image marked = draw_perspective_picture(stage);
  StageResult other = stage;
  other.ran->deviation->gouges.clear();
  const Image plain = draw_perspective_picture(other);
  REQUIRE(marked.width() == plain.width());
  REQUIRE(marked.height() == plain.height());
  const PerspectiveView view(stage.ran->deviation->field, kFront, 1240, 860);
  const ScreenPoint at = view.project(stage.ran->deviation->gouges.front().place.point);
  const int x = int(at.x) + 36, y = int(at.y) + 36 + 96;
  // The ring, 16 pixels away.
  CHECK(marked.at(x + 16, y).r < 80);
  CHECK(plain.at(x + 16, y).r > 80);
  CHECK(marked.at(2, 2) == Rgba{255, 255, 255});
}

TEST_CASE("a picture can write any name in ASCII, and lozenges for others", "[unit][picture]") {
  std::string ascii;
  for (char c = ' '; c <= '~'; ++c) ascii += c;
  CHECK(has_glyphs(ascii));
  CHECK_FALSE(has_glyphs("日"));
  CHECK(text_width("日", {20}) == text_width("◊", {20}));
}

TEST_CASE("the perspective picture of a stage without findings and of one point",
          "[unit][picture]") {
  StageResult stage;
  stage.name = "finish";
  add_sheet(stage.ran.emplace().deviation.emplace().field, 0, 0, 2, false);
  CHECK(draw_perspective_picture(stage).width() > 1000);
}
