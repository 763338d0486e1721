#include "verifier/cutter/chord_pieces.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>

#include "model/gcode/program_path.h"
#include "model/part/cutter.h"
#include "tests/model/gcode/read_text.h"
#include "tests/support/catch.h"
#include "verifier/cutter/removed_space.h"
#include "verifier/tolerance.h"

namespace limitgauge::verifier {
namespace {

using model::Toolpath;
using model::Vec3;

/// Cosines at radii of some 10 mm, and sums of coordinates.
constexpr double kMargin_mm = 1e-11;
constexpr double kChords_mm = 0.002;

Toolpath path_of(const std::string& program, double chords_mm = kChords_mm) {
  return to_toolpath(model::test::read_text(program), chords_mm);
}

/// A quarter turn of R4 about the origin between two straight moves, clockwise.
Toolpath corner() {
  return path_of("G0 X-4 Y-9 Z-1\nG1 Y0 F500\nG2 X0 Y4 I4\nG1 X9\n");
}

double from_chord(const Vec3& p, const SweptBody& chord) {
  const Vec3 way = chord.to - chord.from;
  const double t = std::clamp(dot(p - chord.from, way) / dot(way, way), 0.0, 1.0);
  return distance(p, chord.from + way * t);
}

/// That of `p` from a level flat cutter of R2 that rolls round the origin at R4 by a quarter turn,
/// seen at its own height: a ring's part, and a disc at either end.
double from_rolling(const Vec3& p) {
  const double there = std::hypot(p.x, p.y);
  const bool beside = p.x <= 0 && p.y >= 0 && there > 0;
  const double to_ends = std::min(std::hypot(p.x + 4, p.y), std::hypot(p.x, p.y - 4));
  return (beside ? std::abs(there - 4) : to_ends) - 2;
}

}  // namespace

TEST_CASE("pieces of an arc lie on it, end to end, within what is stated", "[unit][removed]") {
  const Toolpath path = corner();
  REQUIRE(path.arcs.size() == 1);
  const ChordPieces pieces(path);
  CHECK(pieces.error_mm() <= kArcPiece_mm);
  CHECK(pieces.error_mm() > 0.5 * kArcPiece_mm);
  CHECK(pieces.from_moves_mm() >= path.chord_error_mm);
  constexpr double kLift_mm = 0.75;
  const std::vector<SweptBody> bodies = pieces.bodies(path, kLift_mm);
  REQUIRE(bodies.size() == pieces.count());
  CHECK(distance(bodies.front().from, path.start + Vec3{0, 0, kLift_mm}) < kMargin_mm);
  double worst_mm = 0;
  for (std::size_t i = 0; i < bodies.size(); ++i) {
    if (i > 0) REQUIRE(bodies[i].from == bodies[i - 1].to);
    const std::uint32_t move = pieces.move_of(static_cast<std::uint32_t>(i));
    // The last piece of a move ends where it does.
    if (i + 1 == bodies.size() || pieces.move_of(static_cast<std::uint32_t>(i + 1)) == move + 1)
      REQUIRE(bodies[i].to == path.moves[move].to + Vec3(0, 0, kLift_mm));
    if (path.moves[move].line != 3) continue;
    const Vec3 middle = (bodies[i].from + bodies[i].to) / 2;
    REQUIRE(std::abs(std::hypot(bodies[i].to.x, bodies[i].to.y) - 4) < kMargin_mm);
    worst_mm = std::max(worst_mm, 4 - std::hypot(middle.x, middle.y));
  }
  CHECK(worst_mm == Approx(pieces.error_mm()).margin(kMargin_mm));
  CHECK(pieces.move_of(static_cast<std::uint32_t>(bodies.size() - 1)) == path.moves.size() - 1);
}

TEST_CASE("a helix in any plane and place keeps to its arc", "[unit][removed]") {
  for (const std::string plane :
       {"G17 G2 X5 Y0 Z-3 I-5 J0 P2", "G18 G3 X9 Y-2 Z0 I2 K1", "G19 G2 X5 Y3 Z4 J1.5 K2"}) {
    CAPTURE(plane);
    const Toolpath made = path_of("G0 X5 Y0 Z0\nF500\n" + plane + "\nG1 X20\n");
    REQUIRE(made.arcs.size() == 1);
    const Toolpath path = turned(made, model::turn_about({1, 2, 3}, 40));
    const ChordPieces pieces(path);
    const std::vector<SweptBody> bodies = pieces.bodies(path, 0);
    const model::ArcMoves& arc = path.arcs.front();
    const std::size_t count = bodies.size() - (path.moves.size() - arc.chords);
    double worst_mm = 0;
    for (std::size_t i = 0; i < count; ++i) {
      const SweptBody& body = bodies[arc.first_move + i];
      // Vertical ones are stored lowest end first; these are none.
      for (const double share : {0.25, 0.5, 1.0}) {
        const Vec3 p =
            arc.arc.point_at((static_cast<double>(i) + share) / static_cast<double>(count));
        worst_mm = std::max(worst_mm, from_chord(p, body));
      }
    }
    CHECK(worst_mm <= pieces.error_mm() + kMargin_mm);
    CHECK(pieces.error_mm() <= kArcPiece_mm);
  }
}

TEST_CASE("a path of many arcs has no more pieces than are allowed, and states the wider error",
          "[unit][removed]") {
  std::string program = "G0 X4 Y0 Z-1\nF500\n";
  for (int k = 0; k < 400; ++k) program += "G3 I-4\n";
  const Toolpath path = path_of(program);
  const ChordPieces pieces(path);
  CHECK(static_cast<double>(pieces.count()) <= kMostArcPieces);
  CHECK(pieces.error_mm() > 2 * kArcPiece_mm);
  CHECK(pieces.error_mm() < path.chord_error_mm / 10);
  double worst_mm = 0;
  for (const SweptBody& body : pieces.bodies(path, 0)) {
    const Vec3 middle = (body.from + body.to) / 2;
    worst_mm = std::max(worst_mm, 4 - std::hypot(middle.x, middle.y));
  }
  CHECK(worst_mm == Approx(pieces.error_mm()).margin(kMargin_mm));
}

TEST_CASE("chords that are as fine already stay as they are", "[unit][removed]") {
  const Toolpath path = path_of("G0 X4 Y0 Z-1\nG3 X0 Y4 I-4 F500\n", 1e-7);
  const ChordPieces pieces(path);
  CHECK(pieces.count() == path.moves.size());
  CHECK(pieces.from_moves_mm() == 0);
  CHECK(pieces.error_mm() == Approx(path.chord_error_mm).epsilon(1e-6));
}

TEST_CASE("a path whose arcs are not known is off by what it states", "[unit][removed]") {
  Toolpath path = corner();
  path.arcs.clear();
  const ChordPieces pieces(path);
  CHECK(pieces.count() == path.moves.size());
  CHECK(pieces.error_mm() == path.chord_error_mm);
  CHECK(pieces.from_moves_mm() == 0);
}

TEST_CASE("what an arc sweeps is a ring's part, to a millionth of a millimetre",
          "[unit][removed]") {
  auto path = std::make_shared<Toolpath>(path_of("G0 X-4 Y0 Z-1\nG2 X0 Y4 I4 F500\n"));
  for (const bool turns : {false, true}) {
    const model::Pose pose = turns ? model::turn_about({1, 1, 0}, 90) : model::Pose{};
    const Pass pass{model::parse_cutter("flat:D=4,L=20"), path, pose};
    const RemovedSpace space(model::BoxStock{{-50, -50, -50}, {100, 100, 100}}, {&pass, 1});
    CHECK(space.chord_error_mm() <= kArcPiece_mm);
    for (double x = -7; x < 4; x += 0.37)
      for (double y = -4; y < 7; y += 0.41) {
        const Vec3 p{x, y, 5};
        const double known = from_rolling(p);
        const Nearest nearest = space.nearest(pose.point(p));
        CAPTURE(x, y);
        if (known > 0) CHECK(nearest.distance.value == Approx(known).margin(1.5e-6));
        CHECK((nearest.distance.value > 1.5e-6) == (known > 1.5e-6));
        REQUIRE(space.move_of(nearest.body) < path->moves.size());
      }
  }
}

}  // namespace limitgauge::verifier
