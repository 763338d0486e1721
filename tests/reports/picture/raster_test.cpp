#include "reports/picture/raster.h"

#include <algorithm>
#include <cmath>
#include <random>
#include <set>
#include <utility>
#include <vector>

#include "reports/picture/quad_bunches.h"
#include "tests/support/catch.h"

using namespace limitgauge;
using namespace limitgauge::reports;

TEST_CASE("triangles that share an edge leave no gap between them", "[property][picture]") {
  for (int k = 0; k < 50; ++k) {
    const double a = 0.37 * k;
    const ScreenPoint p{20 + 15 * std::cos(a), 20 + 15 * std::sin(a), 0}, q{40 - p.x, 40 - p.y, 0};
    const ScreenPoint l{p.y, 40 - p.x, 0}, r{40 - p.y, p.x, 0};
    DepthBuffer depth(40, 40);
    int painted = 0;
    const auto count = [&](std::size_t, const auto&) { ++painted; };
    depth.fill_triangle({p, q, l}, count);
    depth.fill_triangle({q, p, r}, count);
    // Every pixel once: the second triangle is no nearer on the shared edge. The number of pixel
    // centres in a convex figure differs from its area by less than its perimeter.
    CHECK(std::abs(painted - 450) < 85);
    for (int y = 0; y < 40; ++y) {
      int changes = 0;
      for (int x = 1; x < 40; ++x)
        changes += depth.is_empty(y * 40 + x) != depth.is_empty(y * 40 + x - 1);
      CHECK(changes <= 2);
    }
  }
}

TEST_CASE("the nearer triangle hides the other, whatever their order", "[unit][picture]") {
  const auto triangle = [](double z) {
    return std::array<ScreenPoint, 3>{{{0, 0, z}, {9, 0, z}, {0, 9, z}}};
  };
  for (const bool near_first : {true, false}) {
    DepthBuffer depth(10, 10);
    int seen = 0;
    for (const double z : {near_first ? 2.0 : 1.0, near_first ? 1.0 : 2.0})
      depth.fill_triangle(triangle(z), [&](std::size_t i, const auto& w) {
        CHECK(w[0] + w[1] + w[2] == Approx(1));
        if (i == 11) seen = int(z);
      });
    CHECK(seen == 2);
  }
}

TEST_CASE("a picture that is drawn some rows at a time is the one that is drawn at once",
          "[property][picture]") {
  constexpr int kWidth = 90, kHeight = 600;
  std::mt19937 random(7);
  std::uniform_real_distribution<double> x(-10, kWidth + 10), y(-10, kHeight + 10), z(0, 1);
  std::vector<std::array<ScreenPoint, 3>> triangles(60);
  for (auto& t : triangles)
    for (ScreenPoint& p : t) p = {x(random), y(random), z(random)};
  // Which triangle is seen at each pixel, and with what weight of its first corner.
  using Seen = std::vector<std::pair<int, double>>;
  const auto draw = [&](DepthBuffer& depth) {
    Seen seen(std::size_t(depth.width()) * depth.height(), {-1, 0.0});
    for (int k = 0; k < int(triangles.size()); ++k)
      depth.fill_triangle(triangles[k], [&](std::size_t i, const auto& w) { seen[i] = {k, w[0]}; });
    return seen;
  };
  DepthBuffer whole(kWidth, kHeight), part(kWidth, kRowsAtOnce);
  const Seen at_once = draw(whole);
  Seen by_parts;
  int parts = 0;
  by_rows(kHeight, [&](int first_row, int rows) {
    part.restart(first_row, rows);
    const Seen seen = draw(part);
    by_parts.insert(by_parts.end(), seen.begin(), seen.end());
    const std::size_t first = std::size_t(first_row) * kWidth;
    for (std::size_t i = 0; i < seen.size(); ++i)
      REQUIRE(part.nearest(i) == whole.nearest(first + i));
    ++parts;
    CHECK_FALSE(part.pixel_at(0, first_row - 1));
    CHECK(part.pixel_at(3, first_row) == std::size_t{3});
  });
  CHECK(parts == (kHeight + kRowsAtOnce - 1) / kRowsAtOnce);
  CHECK(by_parts == at_once);
}

TEST_CASE("quads are found by the rows that they reach, all of them and in their order",
          "[property][picture]") {
  constexpr std::size_t kQuads = 3000;
  std::mt19937 random(5);
  std::uniform_real_distribution<double> beside(-20, 20);
  verifier::DeviationField field;
  std::vector<ScreenPoint> points;
  for (std::uint32_t k = 0; k < kQuads; ++k) {
    field.quads.push_back({4 * k, 4 * k + 1, 4 * k + 2, 4 * k + 3});
    for (int corner = 0; corner < 4; ++corner)
      points.push_back({beside(random), 0.2 * k + beside(random), 1});
  }
  const QuadBunches bunches(field, points);
  std::size_t visited = 0;
  by_rows(620, [&](int first_row, int rows) {
    std::vector<std::uint32_t> met;
    bunches.each(DepthBuffer(40, rows, first_row), [&](const auto& q) { met.push_back(q[0]); });
    visited += met.size();
    CHECK(std::is_sorted(met.begin(), met.end()));
    const std::set<std::uint32_t> all(met.begin(), met.end());
    for (const auto& q : field.quads) {
      bool reaches = false;
      for (const auto corner : q)
        reaches |= points[corner].y >= first_row && points[corner].y <= first_row + rows;
      if (reaches) REQUIRE(all.contains(q[0]));
    }
  });
  // A quad of 40 rows reaches 1.6 parts of 64 rows on average; most of the others are passed over.
  CHECK(visited < 3 * kQuads);
}
