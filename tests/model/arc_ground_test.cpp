// Arcs of programs against circles worked out here: centre, way round and height from the words of
// the block by hand. Simulator and verifier read programs with the same code.
#include <array>
#include <cmath>
#include <numbers>

#include "model/gcode/program_path.h"
#include "tests/model/gcode/read_text.h"
#include "tests/support/catch.h"

using namespace limitgauge::model;
using namespace limitgauge::model::test;

namespace {

constexpr double kPi = std::numbers::pi;
constexpr double kChordErrorMm = 0.002;
/// Cosines at radii up to 30 mm: an ulp of 3.6e-15, a few dozen operations.
constexpr double kMarginMm = 1e-11;

/// An arc as it is drawn: in the plane of the axes `first` and `second` about a centre, from an
/// angle by another (radians, positive from `first` to `second`), and along the third axis.
struct Drawn {
  int first = 0, second = 1, third = 2;
  double centre1 = 0, centre2 = 0, radius = 0;
  double from = 0, by = 0;
  double level = 0, rise = 0;

  Vec3 at(double share) const {
    Vec3 p;
    p[first] = centre1 + radius * std::cos(from + share * by);
    p[second] = centre2 + radius * std::sin(from + share * by);
    p[third] = level + share * rise;
    return p;
  }
};

/// `lead` brings the tool to the arc's start; the last block is the arc.
void check_arc(const std::string& lead, const std::string& arc, const Drawn& drawn) {
  CAPTURE(lead, arc);
  const Toolpath path = to_toolpath(read_text(lead + "\n" + arc + "\n"), kChordErrorMm);
  REQUIRE(path.moves.size() > 1);
  CHECK(distance(path.start, drawn.at(0)) < kMarginMm);
  const auto count = static_cast<double>(path.moves.size());
  double worst_mm = 0;
  for (std::size_t i = 0; i < path.moves.size(); ++i) {
    const Vec3 &a = move_from(path, i), &b = path.moves[i].to;
    // Chords divide the arc evenly, so chord i ends at the share (i + 1) / count of it.
    CHECK(distance(b, drawn.at(static_cast<double>(i + 1) / count)) < kMarginMm);
    for (int k = 1; k < 8; ++k) {
      // Points of the arc against the chord that stands for their stretch of it.
      const double share = (static_cast<double>(i) + k / 8.0) / count;
      const Vec3 on_arc = drawn.at(share), chord = b - a;
      const double along = dot(on_arc - a, chord) / dot(chord, chord);
      worst_mm = std::max(worst_mm, distance(on_arc, lerp(a, b, along)));
    }
  }
  CHECK(worst_mm <= path.chord_error_mm + kMarginMm);
  CHECK(path.chord_error_mm <= kChordErrorMm);
  // The error stated is the real one, not a bound far above it: the middle of a chord is sampled.
  if (drawn.rise == 0) CHECK(worst_mm == Approx(path.chord_error_mm).margin(kMarginMm));
}

/// A drawn arc in XY.
Drawn level_arc(double cx, double cy, double radius, double from, double by, double z = 0) {
  return {0, 1, 2, cx, cy, radius, from, by, z, 0};
}

}  // namespace

TEST_CASE("arcs by their centre", "[unit][program]") {
  check_arc("G0 X10 Y0 Z0 F60", "G3 X0 Y10 I-10", level_arc(0, 0, 10, 0, kPi / 2));
  check_arc("G0 X10 Y0 Z0 F60", "G2 X0 Y10 I-10", level_arc(0, 0, 10, 0, -1.5 * kPi));
  check_arc("G0 X7 Y3 Z-1 F60", "G3 X7 Y3 I2 J0", level_arc(9, 3, 2, kPi, 2 * kPi, -1));
  check_arc("G0 X7 Y3 Z-1 F60", "G2 I0 J-5", level_arc(7, -2, 5, kPi / 2, -2 * kPi, -1));
  // A right triangle of 3, 4, 5: from (5, 0) to (3, 4) about the origin.
  check_arc("G0 X5 Y0 Z2 F60", "G3 X3 Y4 I-5 J0", level_arc(0, 0, 5, 0, std::atan2(4, 3), 2));
  check_arc("G0 X15 Y20 Z2 F60", "G90.1 G2 X13 Y24 I10 J20",
            level_arc(10, 20, 5, 0, std::atan2(4, 3) - 2 * kPi, 2));
}

TEST_CASE("arcs by their radius take the shorter way, negative ones the longer",
          "[unit][program]") {
  // Both circles of radius 10 through (10, 0) and (0, 10): about (0, 0) and about (10, 10).
  check_arc("G0 X10 Y0 Z0 F60", "G3 X0 Y10 R10", level_arc(0, 0, 10, 0, kPi / 2));
  check_arc("G0 X10 Y0 Z0 F60", "G2 X0 Y10 R10", level_arc(10, 10, 10, -kPi / 2, -kPi / 2));
  check_arc("G0 X10 Y0 Z0 F60", "G3 X0 Y10 R-10", level_arc(10, 10, 10, -kPi / 2, 1.5 * kPi));
  check_arc("G0 X10 Y0 Z0 F60", "G2 X0 Y10 R-10", level_arc(0, 0, 10, 0, -1.5 * kPi));
  // From (0, 0) to (8, 0) with radius 5: centres at (4, 3) and (4, -3).
  const double half = std::asin(0.8);
  check_arc("G0 X0 Y0 Z0 F60", "G2 X8 R5", level_arc(4, -3, 5, kPi / 2 + half, -2 * half));
  check_arc("G0 X0 Y0 Z0 F60", "G3 X8 R5", level_arc(4, 3, 5, -kPi / 2 - half, 2 * half));
}

TEST_CASE("helices rise evenly, by whole turns too", "[unit][program]") {
  Drawn helix = level_arc(0, 0, 10, 0, 1.5 * kPi, 8);
  helix.rise = -6;
  check_arc("G0 X10 Y0 Z8 F60", "G3 X0 Y-10 Z2 I-10", helix);
  helix.by = -2 * kPi * 3;
  helix.rise = -8;
  check_arc("G0 X10 Y0 Z8 F60", "G2 Z0 I-10 P3", helix);
  // Two whole turns and a quarter: P counts the begun one.
  helix.by = 4.5 * kPi;
  check_arc("G0 X10 Y0 Z8 F60", "G3 X0 Y10 Z0 I-10 P3", helix);
}

TEST_CASE("arcs of the other planes", "[unit][program]") {
  // G18 is seen from +Y with Z to X, G19 from +X with Y to Z.
  check_arc("G0 X0 Y4 Z10 F60", "G18 G3 X10 Z0 K-10", {2, 0, 1, 0, 0, 10, 0, kPi / 2, 4, 0});
  check_arc("G0 X0 Y4 Z10 F60", "G18 G2 X10 Z0 K-10", {2, 0, 1, 0, 0, 10, 0, -1.5 * kPi, 4, 0});
  check_arc("G0 X4 Y10 Z0 F60", "G19 G3 Y0 Z10 J-10", {1, 2, 0, 0, 0, 10, 0, kPi / 2, 4, 0});
  check_arc("G0 X4 Y10 Z0 F60", "G19 G2 Y0 Z10 R-10", {1, 2, 0, 0, 0, 10, 0, -1.5 * kPi, 4, 0});
  // A helix along Y, a quarter about (z, x) = (0, 0).
  check_arc("G0 X0 Y4 Z10 F60", "G18 G3 X10 Y1 Z0 K-10", {2, 0, 1, 0, 0, 10, 0, kPi / 2, 4, -3});
}

TEST_CASE("arcs in inches and in turned frames", "[unit][program]") {
  check_arc("G20 G0 X1 Y0 Z0 F60", "G3 X0 Y1 I-1", level_arc(0, 0, 25.4, 0, kPi / 2));
  // The frame turned by 90 degrees about (5, 0): work (10, 0) is machine (5, 10).
  check_arc("G10 L2 P1 X5 R90\nG0 X10 Y0 Z0 F60", "G3 X0 Y10 I-10",
            level_arc(5, 0, 10, kPi / 2, kPi / 2));
}
