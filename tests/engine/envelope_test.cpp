#include "engine/strategy/locations/envelope.h"

#include <cmath>

#include "model/geometry/polyline.h"
#include "tests/support/catch.h"

using namespace limitgauge::engine::strategy;

namespace {

using Curves = std::vector<std::vector<PlanePoint>>;

/// The upper half of a circle as chords, each a curve of its own.
void add_arc(Curves& segments, double centre, double radius) {
  constexpr int kChords = 400;
  const auto at = [&](int k) {
    const double a = 3.14159265358979323846 * k / kChords;
    return PlanePoint{centre - radius * std::cos(a), radius * std::sin(a)};
  };
  for (int k = 0; k < kChords; ++k) segments.push_back({at(k), at(k + 1)});
}

}  // namespace

TEST_CASE("two crossing domes meet in their crossing", "[unit][envelope]") {
  Curves segments;
  add_arc(segments, 0, 5);
  add_arc(segments, 6, 5);
  const Envelope envelope = upper_envelope(segments, 1e-9);
  REQUIRE(envelope.runs.size() == 1);
  double valley = 5;
  for (const PlanePoint& p : envelope.runs[0]) {
    const double left = 25 - p.s * p.s, right = 25 - (p.s - 6) * (p.s - 6);
    // Chords of 400 a half circle stay within 5 (1 - cos(pi / 800)) = 4e-5 of it.
    CHECK(p.z == Approx(std::sqrt(std::max({left, right, 0.0}))).margin(0.02));
    if (p.s > 1 && p.s < 5) valley = std::min(valley, p.z);
  }
  CHECK(valley == Approx(4).margin(5e-5));
}

TEST_CASE("a gap parts two runs and a step is a vertical piece", "[unit][envelope]") {
  const Envelope gap =
      upper_envelope(Curves{{{0, 1}, {1, 1}}, {{2, 0}, {3, 0}}, {{2.5, 4}, {3, 4}}}, 1e-9);
  REQUIRE(gap.runs.size() == 2);
  CHECK(gap.runs[0].back() == PlanePoint{1, 1});
  CHECK(gap.runs[1][1] == PlanePoint{2.5, 0});
  CHECK(gap.runs[1][2] == PlanePoint{2.5, 4});
}

TEST_CASE("curves that meet but for rounding show nothing below", "[unit][envelope]") {
  const Envelope envelope =
      upper_envelope(Curves{{{0, 1}, {1, 1}}, {{1 + 1e-15, 1}, {2, 1}}, {{0, -5}, {2, -5}}}, 1e-9);
  REQUIRE(envelope.runs.size() == 1);
  for (const PlanePoint& p : envelope.runs[0]) CHECK(p.z == 1);
}

TEST_CASE("reduction stays within its error", "[property][envelope]") {
  std::vector<PlanePoint> line;
  for (int i = 0; i <= 1000; ++i) line.push_back({i * 0.01, std::sin(i * 0.01)});
  const double error = 1e-3;
  const auto kept = limitgauge::model::reduced(line, error, [](const PlanePoint& p) {
    return limitgauge::model::Vec2{p.s, p.z};
  });
  CHECK(kept.size() < 200);
  std::size_t k = 0;
  for (const PlanePoint& p : line) {
    while (kept[k + 1].s < p.s) ++k;
    const double t = (p.s - kept[k].s) / (kept[k + 1].s - kept[k].s);
    // Height differences are at most distance over the cosine of 45 degrees.
    CHECK(std::abs(kept[k].z + (kept[k + 1].z - kept[k].z) * t - p.z) <= error * 1.4143);
  }
}
