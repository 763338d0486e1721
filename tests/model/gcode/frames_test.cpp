#include "model/gcode/machine/coordinate_systems.h"

#include <cmath>
#include <complex>
#include <numbers>
#include <random>

#include "model/base/angle.h"
#include "tests/support/catch.h"

using namespace limitgauge::model;
using gcode::Frame;

TEST_CASE("a frame adds origin, turned offsets and tool length", "[unit][gcode]") {
  const Frame frame{{10, 20, 30}, 90, {1, 2, 3}, -5};
  // (4, 6) after G92's offset, turned by 90 degrees: (-6, 4).
  CHECK(frame.to_machine({3, 4, 5}) == Vec3{4, 24, 33});
  CHECK(frame.to_work({4, 24, 33}) == Vec3{3, 4, 5});
}

TEST_CASE("quarter turns are exact", "[unit][gcode]") {
  const Vec3 v{0.1, 0.7, 3};
  CHECK(turned(v, 0) == v);
  CHECK(turned(v, 90) == Vec3{-0.7, 0.1, 3});
  CHECK(turned(v, -90) == Vec3{0.7, -0.1, 3});
  CHECK(turned(v, 180) == Vec3{-0.1, -0.7, 3});
  CHECK(turned(v, -540) == Vec3{-0.1, -0.7, 3});
  CHECK(turned(v, 450) == Vec3{-0.7, 0.1, 3});
}

TEST_CASE("turning agrees with complex numbers, and frames go there and back",
          "[property][gcode]") {
  std::mt19937 random(31);
  std::uniform_real_distribution<double> number(-300, 300);
  for (int round = 0; round < 1000; ++round) {
    const Frame frame{{number(random), number(random), number(random)},
                      number(random),
                      {number(random), number(random), number(random)},
                      number(random)};
    const Vec3 p{number(random), number(random), number(random)};
    const std::complex<double> turn = std::polar(1.0, frame.rotation_deg * std::numbers::pi / 180);
    const std::complex<double> flat =
        std::complex<double>(p.x + frame.g92_mm.x, p.y + frame.g92_mm.y) * turn;
    const Vec3 at = frame.to_machine(p);
    // A few roundings of 1000 mm.
    CHECK(std::abs(at.x - flat.real() - frame.origin_mm.x) < 1e-11);
    CHECK(std::abs(at.y - flat.imag() - frame.origin_mm.y) < 1e-11);
    CHECK(distance(frame.to_work(at), p) < 1e-11);
  }
}
