#include "engine/strategy/linking/least_links.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <random>
#include <utility>

#include "model/geometry/polyline.h"
#include "tests/support/catch.h"

using namespace limitgauge::engine::strategy;

namespace {

using Line = std::vector<PlanePoint>;

Line sampled(double from, double to, int n, const std::function<double(double)>& height) {
  Line line;
  for (int i = 0; i <= n; ++i) {
    const double s = from + (to - from) * i / n;
    line.push_back({s, height(s)});
  }
  return line;
}

double distance_to(const Line& line, const PlanePoint& p) {
  double least = 1e300;
  for (std::size_t i = 1; i < line.size(); ++i) {
    const PlanePoint &a = line[i - 1], &b = line[i];
    const double ds = b.s - a.s, dz = b.z - a.z, l2 = ds * ds + dz * dz;
    const double t =
        l2 > 0 ? std::clamp(((p.s - a.s) * ds + (p.z - a.z) * dz) / l2, 0.0, 1.0) : 0.0;
    least = std::min(least, std::hypot(p.s - a.s - t * ds, p.z - a.z - t * dz));
  }
  return least;
}

/// Greatest distance of points on `a`, each piece cut into `steps`, to `b`.
double farthest(const Line& a, const Line& b, int steps) {
  double most = 0;
  for (std::size_t i = 1; i < a.size(); ++i)
    for (int k = 0; k <= steps; ++k) {
      const double t = static_cast<double>(k) / steps;
      most = std::max(most, distance_to(b, {a[i - 1].s + (a[i].s - a[i - 1].s) * t,
                                            a[i - 1].z + (a[i].z - a[i - 1].z) * t}));
    }
  return most;
}

void check_bound(const Line& line, double error) {
  const Line links = least_links(line, error);
  CHECK(links.front() == line.front());
  CHECK(links.back() == line.back());
  // Rounding of coordinates up to 30 is far below a thousandth of the errors asked for.
  CHECK(farthest(links, line, 20) <= error * 1.001);
  CHECK(farthest(line, links, 2) <= error * 1.001);
}

}  // namespace

TEST_CASE("links keep within their error both ways", "[property][envelope]") {
  const double error = 1e-3;
  check_bound(sampled(-5, 5, 700, [](double s) { return std::sin(s); }), error);
  check_bound(
      sampled(-5, 5, 700, [](double s) { return std::sin(3 * s) + 0.2 * std::cos(11 * s); }),
      error);
  check_bound(sampled(0, 10, 500, [](double s) { return 0.3 * s; }), error);
  // The upper half of a circle: vertical at its ends.
  check_bound(sampled(-3, 3, 600, [](double s) { return std::sqrt(std::max(0.0, 9 - s * s)); }),
              error);
  std::mt19937 random(3);
  std::uniform_real_distribution<double> noise(-2e-3, 2e-3), jump(-1, 1);
  check_bound(sampled(0, 3, 300, [&](double s) { return std::cos(s) + noise(random); }), error);
  // Steps: vertical pieces between flat ones.
  Line steps = {{0, 0}};
  for (int i = 1; i < 60; ++i) {
    const double z = jump(random);
    steps.push_back({steps.back().s, z});
    steps.push_back({steps.back().s + 0.1, z + noise(random)});
  }
  check_bound(steps, error);
}

TEST_CASE("no fewer links go over an arc", "[unit][envelope]") {
  // A link that touches the outer wall of the tunnel in its middle reaches the inner one at its
  // ends: its sagitta is the tunnel's width 2 e, so it spans 2 acos(1 - 2 e / (r + e)) at most.
  // Vertical measure makes the tunnel narrower by the cosine of the slope, here 1 - s² / 2 r² ≥
  // 0.995.
  const double radius = 20, error = 1e-3, half = 2;
  const Line line =
      sampled(-half, half, 4000, [&](double s) { return std::sqrt(radius * radius - s * s); });
  const double angle = 2 * std::asin(half / radius);
  const double widest = 2 * std::acos(1 - 2 * error / (radius + error));
  const auto links = static_cast<double>(least_links(line, error).size() - 1);
  CHECK(links >= std::floor(angle / widest));
  // One more for each fixed end, which costs half a link, and rounding up.
  CHECK(links <= std::ceil(angle / widest * 1.01) + 1);
  const auto chords = limitgauge::model::reduced(line, error, [](const PlanePoint& p) {
    return limitgauge::model::Vec2{p.s, p.z};
  });
  CHECK(links < 0.8 * static_cast<double>(chords.size() - 1));
}

TEST_CASE("a zigzag within the error is one link", "[unit][envelope]") {
  Line line;
  for (int i = 0; i <= 200; ++i) line.push_back({i * 0.1, (i % 2) * 1.9e-3 + i * 0.02});
  // From end to end on the lower side; the upper corners are 1.9e-3 away, the tunnel 2e-3 wide.
  CHECK(least_links(line, 1e-3).size() <= 4);
  CHECK(least_links(line, 2e-3).size() == 2);
}

TEST_CASE("points that repeat the one before but for rounding change nothing", "[unit][envelope]") {
  // Where sections of two triangles meet, points come twice, one rounding of a coordinate apart.
  // Down the ring of a torus the line passes from flat to steep pieces between two such.
  const double error = GENERATE(1e-3, 3.75e-3, 1e-2);
  const Line once = sampled(-4, 4, GENERATE(160, 320, 641),
                            [](double s) { return std::sqrt(std::max(0.0, 16 - s * s)); });
  Line twice = {once.front()};
  for (std::size_t i = 1; i + 1 < once.size(); ++i) {
    const bool rising = once[i + 1].z > once[i].z;
    twice.push_back(once[i]);
    twice.push_back({std::nextafter(once[i].s, 9), std::nextafter(once[i].z, rising ? 9 : -9)});
    if (i % 3 == 0) twice.push_back(twice.back());
  }
  twice.push_back(once.back());
  for (const PlanePoint& p : least_links(twice, error))
    CHECK((std::isfinite(p.s) && std::isfinite(p.z)));
  check_bound(twice, error);
  CHECK(least_links(twice, error).size() == least_links(once, error).size());
}
