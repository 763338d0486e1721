#include "engine/surface/section/grid_section.h"

#include <cmath>
#include <functional>
#include <numbers>
#include <random>

#include "tests/engine/plane_crossing.h"
#include "tests/support/catch.h"

using namespace limitgauge;
using namespace engine::surface;
using test::Crossed;
using test::crossed;

namespace {

/// z = height(x, y) over [-1, 1]² with cells of 2 / n.
Grid grid_of(int n, const std::function<double(double, double)>& height) {
  Grid grid{n + 1, n + 1, {}};
  for (int v = 0; v <= n; ++v)
    for (int u = 0; u <= n; ++u) {
      const double x = 2.0 * u / n - 1, y = 2.0 * v / n - 1;
      grid.points.push_back({x, y, height(x, y)});
    }
  return grid;
}

struct Count {
  int lines = 0, rings = 0;
  friend bool operator==(const Count&, const Count&) = default;
};

Count count(const Grid& grid, int axis, double value) {
  SectionScratch scratch;
  std::vector<SectionChain> chains;
  GridSection(grid, axis).cut(value, scratch, chains);
  Count found;
  for (const SectionChain& chain : chains) ++(chain.closed ? found.rings : found.lines);
  return found;
}

double length_of(const SectionChain& chain) {
  double sum = 0;
  for (std::size_t i = 1; i < chain.points.size(); ++i)
    sum += distance(chain.points[i - 1], chain.points[i]);
  return sum + (chain.closed ? distance(chain.points.back(), chain.points.front()) : 0);
}

}  // namespace

TEST_CASE("curves of a patch are of line or ring type", "[unit][section]") {
  const auto slope = [](double x, double y) { return x + 0.3 * y; };
  CHECK(count(grid_of(16, slope), 2, 0.1) == Count{1, 0});
  const auto dome = [](double x, double y) { return -x * x - y * y; };
  CHECK(count(grid_of(64, dome), 2, -0.5) == Count{0, 1});
  // Beyond r = 1 the circle goes through all four sides; beyond r = √2 there is nothing.
  CHECK(count(grid_of(64, dome), 2, -1.3) == Count{4, 0});
  CHECK(count(grid_of(64, dome), 2, -2.1) == Count{0, 0});
  CHECK(count(grid_of(64, dome), 2, 0.1) == Count{0, 0});
}

TEST_CASE("several loops in one patch are all found", "[unit][section]") {
  // 4 × 4 peaks and pits in turn: at ±0.5 a ring each, at 0.5 round the 8 peaks only.
  const double pi = std::numbers::pi;
  const auto waves = [=](double x, double y) {
    return std::sin(2 * pi * x) * std::sin(2 * pi * y);
  };
  for (const int n : {40, 64, 100}) {
    CHECK(count(grid_of(n, waves), 2, 0.5) == Count{0, 8});
    CHECK(count(grid_of(n, waves), 2, -0.5) == Count{0, 8});
  }
  // Rings within rings: cos(6 r) has zeros at pi / 12 and pi / 4; the one at 5 pi / 12 > 1 is left
  // to the corners.
  const auto target = [](double x, double y) { return std::cos(6 * std::hypot(x, y)); };
  CHECK(count(grid_of(96, target), 2, 1e-3) == Count{4, 2});
  CHECK(count(grid_of(96, target), 2, -1e-3) == Count{4, 2});
}

TEST_CASE("planes that touch or hold parts of the surface", "[unit][section]") {
  // Peak at a vertex: a ring of no size where the plane is exactly as high; a pit shows nothing.
  const auto peak = [](double x, double y) { return -std::abs(x) - std::abs(y); };
  const auto pit = [](double x, double y) { return std::abs(x) + std::abs(y); };
  const Grid touching = grid_of(16, peak);
  REQUIRE(count(touching, 2, 0) == Count{0, 1});
  SectionScratch scratch;
  std::vector<SectionChain> chains;
  GridSection(touching, 2).cut(0, scratch, chains);
  CHECK(length_of(chains[0]) < 1e-15);
  CHECK(count(grid_of(16, pit), 2, 0) == Count{0, 0});
  // A saddle's two branches meet in a vertex: two lines, whichever way they are parted there.
  CHECK(count(grid_of(16, [](double x, double y) { return x * y; }), 2, 0) == Count{2, 0});
  // A figure of eight: two bumps that meet at a vertex in the plane are one ring, two just above.
  const auto bumps = [](double x, double y) { return x * x - 2 * x * x * x * x - y * y; };
  CHECK(count(grid_of(32, bumps), 2, 1e-9).rings == 2);
  CHECK(count(grid_of(32, bumps), 2, 0).rings == 1);
  // A flat top in the plane: its outline; a flat patch in the plane: nothing is below it.
  const auto table = [](double x, double y) { return std::min(0.0, 0.5 - std::hypot(x, y)); };
  CHECK(count(grid_of(32, table), 2, 0) == Count{0, 1});
  CHECK(count(grid_of(32, [](double, double) { return 0.0; }), 2, 0) == Count{0, 0});
  // A wall in the plane x = 0 as seen along x: all its points count as above.
  CHECK(count(grid_of(16, [](double, double) { return 1.0; }), 0, 0) == Count{1, 0});
}

TEST_CASE("rough patches are cut as brute force cuts them", "[property][section]") {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> noise(-1, 1);
  std::vector<double> values;
  for (int k = -9; k <= 9; ++k) values.push_back(k * 0.1);
  for (const int n : {1, 7, 8, 9, 33}) {
    // Heights on a raster of tenths: many vertices and edges lie exactly in the planes.
    const Grid grid =
        grid_of(n, [&](double, double) { return std::round(noise(random) * 10) * 0.1; });
    const GridSection section(grid, 2);
    const SectionStarts starts = section.starts(values);
    SectionScratch scratch;
    for (std::size_t k = 0; k < values.size(); ++k) {
      std::vector<SectionChain> chains;
      section.trace(starts, k, values[k], scratch, chains);
      Crossed sum;
      for (const SectionChain& chain : chains) {
        sum.length += length_of(chain);
        sum.triangles += static_cast<int>(chain.points.size()) - (chain.closed ? 0 : 1);
      }
      const Crossed truth = crossed(grid, {2, values[k]});
      CHECK(sum.triangles == truth.triangles);
      CHECK(sum.length == Approx(truth.length).margin(1e-12));
      std::vector<SectionChain> alone;
      section.cut(values[k], scratch, alone);
      REQUIRE(alone.size() == chains.size());
      for (std::size_t c = 0; c < alone.size(); ++c) CHECK(alone[c].points == chains[c].points);
    }
  }
}

TEST_CASE("what is above lies on the left", "[property][section]") {
  const Grid grid = grid_of(40, [](double x, double y) { return std::sin(3 * x) - y * y; });
  SectionScratch scratch;
  std::vector<SectionChain> chains;
  GridSection(grid, 2).cut(0.2, scratch, chains);
  REQUIRE(!chains.empty());
  for (const SectionChain& chain : chains)
    for (std::size_t i = 1; i < chain.points.size(); ++i) {
      const Vec3 &a = chain.points[i - 1], &b = chain.points[i];
      if (distance(a, b) < 1e-6) continue;
      // The gradient of the height is (3 cos 3x, -2y).
      const double left = -(b.y - a.y) * 3 * std::cos(3 * a.x) + (b.x - a.x) * -2 * a.y;
      CHECK(left > 0);
    }
}
