#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <random>

#include "tests/model/gcode/compensated_contour.h"
#include "tests/support/catch.h"

using namespace limitgauge::model;
using namespace limitgauge::model::gcode;
using namespace limitgauge::model::test;

namespace {

using Point = std::array<double, 2>;
constexpr double kFull = 2 * std::numbers::pi;

double apart(Point p, Point q) {
  return std::hypot(p[0] - q[0], p[1] - q[1]);
}

/// A straight piece or an arc (sweep counter-clockwise, not 0), with its own evaluation of points
/// and distances: nothing here is shared with what it tests.
struct Piece {
  Point from, to, centre{};
  double sweep = 0;

  double radius() const { return apart(from, centre); }
  double length() const { return sweep == 0 ? apart(from, to) : radius() * std::abs(sweep); }
  Point at(double share) const {
    if (sweep == 0)
      return {from[0] + share * (to[0] - from[0]), from[1] + share * (to[1] - from[1])};
    const double angle = std::atan2(from[1] - centre[1], from[0] - centre[0]) + share * sweep;
    return {centre[0] + radius() * std::cos(angle), centre[1] + radius() * std::sin(angle)};
  }
  double heading(double share) const {
    if (sweep == 0) return std::atan2(to[1] - from[1], to[0] - from[0]);
    const Point p = at(share);
    return std::atan2(p[1] - centre[1], p[0] - centre[0]) +
           std::copysign(std::numbers::pi / 2, sweep);
  }
  double distance_to(Point p) const {
    const double ends = std::min(apart(p, from), apart(p, to));
    if (sweep == 0) {
      const double dx = to[0] - from[0], dy = to[1] - from[1], square = dx * dx + dy * dy;
      const double share = ((p[0] - from[0]) * dx + (p[1] - from[1]) * dy) / square;
      return share < 0 || share > 1 ? ends : apart(p, at(share));
    }
    const double start = std::atan2(from[1] - centre[1], from[0] - centre[0]);
    const double angle = std::atan2(p[1] - centre[1], p[0] - centre[0]);
    const double turned = std::remainder((angle - start) - sweep / 2, kFull);
    return std::abs(turned) > std::abs(sweep) / 2 ? ends : std::abs(apart(p, centre) - radius());
  }
};

using Contour = std::vector<Piece>;

double distance_to(const Contour& contour, Point p) {
  double nearest = 1e300;
  for (const Piece& piece : contour) nearest = std::min(nearest, piece.distance_to(p));
  return nearest;
}

/// By crossings of a ray with 24 chords a piece; points are far off the contour against their
/// error.
bool is_inside(const Contour& contour, Point p) {
  bool inside = false;
  for (const Piece& piece : contour) {
    for (int i = 0; i < 24; ++i) {
      const Point a = piece.at(i / 24.0), b = piece.at((i + 1) / 24.0);
      if ((a[1] > p[1]) == (b[1] > p[1])) continue;
      inside ^= p[0] < a[0] + (p[1] - a[1]) / (b[1] - a[1]) * (b[0] - a[0]);
    }
  }
  return inside;
}

Piece bulged(Point from, Point to, double sweep) {
  if (sweep == 0) return {from, to};
  // The centre lies on the bisector, left of the chord for a counter-clockwise arc.
  const double height = 0.5 / std::tan(sweep / 2);
  const double dx = to[0] - from[0], dy = to[1] - from[1];
  return {
      from, to, {(from[0] + to[0]) / 2 - height * dy, (from[1] + to[1]) / 2 + height * dx}, sweep};
}

/// A closed contour, counter-clockwise about the origin, that begins amid a straight edge.
Contour random_contour(std::mt19937& random) {
  std::uniform_real_distribution<double> part(0, 1);
  const int corners = 4 + static_cast<int>(random() % 6);
  std::vector<Point> points;
  for (int i = 0; i < corners; ++i) {
    const double angle = kFull * (i + 0.6 * part(random)) / corners, r = 15 + 25 * part(random);
    points.push_back({r * std::cos(angle), r * std::sin(angle)});
  }
  const Point start = {(points[0][0] + points.back()[0]) / 2,
                       (points[0][1] + points.back()[1]) / 2};
  Contour contour = {{start, points[0]}};
  for (std::size_t i = 1; i < points.size(); ++i) {
    const double sweep = part(random) < 0.4 ? 0 : 3.6 * (part(random) - 0.5);
    contour.push_back(bulged(points[i - 1], points[i], std::abs(sweep) < 0.2 ? 0 : sweep));
  }
  contour.push_back({points.back(), start});
  return contour;
}

/// Whether a cutter of radius r finds room at every place, which compensation takes for granted:
/// pieces are long, corners neither nearly smooth nor sharp, and pieces come near to each other at
/// their corners only.
bool has_room(const Contour& contour, double r) {
  const std::size_t n = contour.size();
  for (std::size_t i = 0; i < n; ++i) {
    const Piece& piece = contour[i];
    if (piece.length() < 8 * r || (piece.sweep != 0 && piece.radius() < 4 * r)) return false;
    const Piece& next = contour[(i + 1) % n];
    const double turn = std::abs(std::remainder(next.heading(0) - piece.heading(1), kFull));
    if (i + 1 < n && (turn < 0.06 || turn > 2)) return false;
    for (std::size_t j = 0; j < n; ++j) {
      for (int k = 0; k <= 40 && j != i; ++k) {
        const Point p = contour[j].at(k / 40.0);
        const bool at_corner = apart(p, piece.from) < 4 * r || apart(p, piece.to) < 4 * r;
        if (piece.distance_to(p) < 2.5 * r && !at_corner) return false;
      }
    }
  }
  return true;
}

Contour path_of(const std::vector<Motion>& motions, Point from) {
  Contour path;
  for (const Motion& motion : motions) {
    const Point to = {motion.to.x, motion.to.y}, centre = {motion.centre1, motion.centre2};
    double sweep = 0;
    if (motion.kind == MotionKind::arc) {
      sweep = std::atan2(to[1] - centre[1], to[0] - centre[0]) -
              std::atan2(from[1] - centre[1], from[0] - centre[0]);
      if (sweep * motion.turns < 0) sweep += std::copysign(kFull, motion.turns);
      CHECK(std::abs(apart(from, centre) - apart(to, centre)) < 1e-9);
    }
    path.push_back({from, to, centre, sweep});
    from = to;
  }
  return path;
}

void cut(CompensatedContour& compensated, const Contour& contour) {
  for (const Piece& piece : contour) {
    if (piece.sweep == 0)
      compensated.line(piece.to[0], piece.to[1]);
    else
      compensated.arc(piece.to[0], piece.to[1], piece.centre[0], piece.centre[1],
                      piece.sweep > 0 ? 1 : -1);
  }
  compensated.compensation().end();
}

/// Where the tool stands before the contour: behind its start, in line with it.
Point before(const Contour& contour, double length) {
  const double heading = contour[0].heading(0);
  return {contour[0].from[0] - length * std::cos(heading),
          contour[0].from[1] - length * std::sin(heading)};
}

/// The path beside the contour without its entry.
Contour compensated_path(const Contour& contour, CompensationSide side, double r,
                         CompensationStyle style = CompensationStyle::linuxcnc) {
  CompensatedContour compensated;
  const Point start = before(contour, 3 * r);
  compensated.begin(side, r, {start[0], start[1], 0}, style);
  compensated.line(contour[0].from[0], contour[0].from[1]);
  cut(compensated, contour);
  Contour path = path_of(compensated.motions(), start);
  path.erase(path.begin());
  return path;
}

/// Looks at random contours in which a cutter of the radius has room, and at a side of each.
template <class Look>
void look_at_contours(unsigned seed, int count, const Look& look) {
  std::mt19937 random(seed);
  for (int contours = 0; contours < count;) {
    const double r = std::uniform_real_distribution<double>(0.2, 1.5)(random);
    const Contour contour = random_contour(random);
    if (!has_room(contour, r)) continue;
    ++contours;
    look(contour, r, random() % 2 == 0 ? CompensationSide::left : CompensationSide::right);
  }
}

}  // namespace

TEST_CASE("the cutter touches the contour everywhere along its path and enters it nowhere",
          "[property][compensation]") {
  int arcs = 0;
  look_at_contours(20240607, 300, [&](const Contour& contour, double r, CompensationSide side) {
    // Double precision at 100 mm leaves 1e-12 mm; corners of 0.06 radians lose three digits.
    const double tolerance_mm = 1e-9;
    double worst = 0;
    bool on_side = true;
    for (const Piece& piece : compensated_path(contour, side, r)) {
      arcs += piece.sweep != 0;
      for (int k = 0; k <= 16; ++k) {
        const Point p = piece.at(k / 16.0);
        worst = std::max(worst, std::abs(distance_to(contour, p) - r));
        on_side &= is_inside(contour, p) == (side == CompensationSide::left);
      }
    }
    CHECK(worst < tolerance_mm);
    CHECK(on_side);
  });
  CHECK(arcs > 1000);
}

TEST_CASE(
    "with straight corners the cutter enters the contour nowhere and leaves it at corners only",
    "[property][compensation]") {
  int farther = 0;
  look_at_contours(20261130, 200, [&](const Contour& contour, double r, CompensationSide side) {
    const Contour path = compensated_path(contour, side, r, CompensationStyle::fanuc);
    bool on_side = true, beside_corners = true;
    double nearest = r, farthest = r;
    for (const Piece& piece : path) {
      for (int k = 0; k <= 16; ++k) {
        const Point p = piece.at(k / 16.0);
        const double apart_mm = distance_to(contour, p);
        nearest = std::min(nearest, apart_mm);
        farthest = std::max(farthest, apart_mm);
        on_side &= is_inside(contour, p) == (side == CompensationSide::left);
        if (apart_mm < r + 1e-9) continue;
        ++farther;
        double corner = 1e300;
        for (const Piece& other : contour) corner = std::min(corner, apart(p, other.to));
        beside_corners &= corner < 1.5 * r;
      }
    }
    CHECK(on_side);
    CHECK(beside_corners);
    CHECK(nearest > r - 1e-9);
    CHECK(farthest < std::sqrt(2.0) * r + 1e-9);
    // Where it ends up at all corners is where the arcs go round them.
    for (const Piece& piece : contour) CHECK(distance_to(path, piece.at(0.5)) < r + 1e-9);
  });
  CHECK(farther > 1000);
}

TEST_CASE("arcs go round outer corners alike whatever the entry", "[property][compensation]") {
  std::mt19937 random(17);
  for (int contours = 0; contours < 100;) {
    const Contour contour = random_contour(random);
    if (!has_room(contour, 1)) continue;
    ++contours;
    const Contour path = compensated_path(contour, CompensationSide::right, 1);
    const Contour other =
        compensated_path(contour, CompensationSide::right, 1, CompensationStyle::siemens);
    REQUIRE(path.size() == other.size());
    for (std::size_t i = 0; i < path.size(); ++i) {
      CHECK(apart(path[i].to, other[i].to) < 1e-9);
      CHECK(path[i].sweep == Approx(other[i].sweep).margin(1e-9));
    }
  }
}

TEST_CASE("the cutter touches every point of the contour but those in inner corners",
          "[property][compensation]") {
  std::mt19937 random(7);
  int contours = 0, touched = 0, missed = 0;
  while (contours < 150) {
    const double r = std::uniform_real_distribution<double>(0.2, 1.5)(random);
    const Contour contour = random_contour(random);
    if (!has_room(contour, r)) continue;
    ++contours;
    const Contour path = compensated_path(contour, CompensationSide::right, r);
    for (std::size_t i = 0; i < contour.size(); ++i) {
      for (int k = 1; k < 40; ++k) {
        const Point p = contour[i].at(k / 40.0);
        const bool is_near = distance_to(path, p) < r + 1e-9;
        // What room there is about corners is taken from has_room(); nearer ones may be missed.
        const bool at_corner = apart(p, contour[i].from) < 4 * r || apart(p, contour[i].to) < 4 * r;
        touched += is_near;
        missed += !is_near && !at_corner;
        CHECK(distance_to(path, p) > r - 1e-9);
      }
    }
  }
  CHECK(touched > 20000);
  CHECK(missed == 0);
}

TEST_CASE("a mirrored contour on the other side gives the mirrored path",
          "[property][compensation]") {
  std::mt19937 random(11);
  for (int contours = 0; contours < 200;) {
    const Contour contour = random_contour(random);
    if (!has_room(contour, 1)) continue;
    ++contours;
    Contour mirrored = contour;
    for (Piece& piece : mirrored) {
      for (Point* point : {&piece.from, &piece.to, &piece.centre}) (*point)[1] = -(*point)[1];
      piece.sweep = -piece.sweep;
    }
    const Contour path = compensated_path(contour, CompensationSide::left, 1);
    const Contour other = compensated_path(mirrored, CompensationSide::right, 1);
    REQUIRE(path.size() == other.size());
    for (std::size_t i = 0; i < path.size(); ++i)
      CHECK(apart(path[i].to, {other[i].to[0], -other[i].to[1]}) < 1e-9);
  }
}

TEST_CASE("G18 compensates in Z and X as G17 does in X and Y", "[property][compensation]") {
  std::mt19937 random(13);
  for (int contours = 0; contours < 100;) {
    const Contour contour = random_contour(random);
    if (!has_room(contour, 1)) continue;
    ++contours;
    CompensatedContour xy, zx(ArcPlane::zx);
    for (CompensatedContour* compensated : {&xy, &zx}) {
      const Point start = before(contour, 3);
      compensated->begin(CompensationSide::left, 1, compensated->point(start[0], start[1]));
      compensated->line(contour[0].from[0], contour[0].from[1]);
      cut(*compensated, contour);
    }
    REQUIRE(xy.motions().size() == zx.motions().size());
    for (std::size_t i = 0; i < xy.motions().size(); ++i) {
      const Motion &a = xy.motions()[i], &b = zx.motions()[i];
      CHECK(b.to == Vec3{a.to.y, a.to.z, a.to.x});
      CHECK((a.kind != MotionKind::arc || b.plane == ArcPlane::zx));
      CHECK((b.centre1 == a.centre1 && b.centre2 == a.centre2 && b.turns == a.turns));
    }
  }
}
