// Outlines of cutters as ISO 3592 (APT's CUTTER/d,r,e,f,a,b,h) draws them, worked out here from the
// drawing alone. Simulator and verifier both take their shapes from model::seven_figures; an error
// in it would agree with itself everywhere else.
#include <array>
#include <cmath>
#include <random>

#include "model/part/cutter.h"
#include "tests/support/catch.h"

using namespace limitgauge::model;

namespace {

const double kDegree = std::acos(-1.0) / 180;
/// A few dozen operations on lengths up to 100 mm, an ulp of which is 1.4e-14.
constexpr double kMargin = 1e-11;

struct Point {
  double r = 0, z = 0;
};

/// What the drawing shows: bottom line from the tip, corner arc, side line.
struct Drawing {
  double d = 0, r = 0, a_deg = 0, b_deg = 0, h = 0;
};

/// The arc's centre: r from the bottom line (through the tip, rising by a) and r from the side line
/// (through the lines' meeting at d/2, leaning by b). Two lines, each moved inwards by r, meet in
/// it; Cramer's rule.
Point centre_of(const Drawing& c) {
  const double a = c.a_deg * kDegree, b = c.b_deg * kDegree;
  // Inward normals: of the bottom up and towards the axis, of the side towards the axis and up.
  const double n1r = -std::sin(a), n1z = std::cos(a), n2r = -std::cos(b), n2z = std::sin(b);
  const double meet_r = c.d / 2, meet_z = c.d / 2 * std::tan(a);
  const double k1 = c.r, k2 = c.r + n2r * meet_r + n2z * meet_z;
  const double det = n1r * n2z - n1z * n2r;
  return {(k1 * n2z - k2 * n1z) / det, (n1r * k2 - n2r * k1) / det};
}

/// Radius of the drawn outline at height z: on the bottom line, the arc or the side line.
double drawn_radius(const Drawing& c, double z) {
  const double a = c.a_deg * kDegree, b = c.b_deg * kDegree;
  const Point centre = centre_of(c);
  const Point low{centre.r + c.r * std::sin(a), centre.z - c.r * std::cos(a)};
  const Point high{centre.r + c.r * std::cos(b), centre.z - c.r * std::sin(b)};
  if (z <= low.z && a > 0) return z / std::tan(a);
  if (z < high.z)
    return centre.r + std::sqrt(std::max(0.0, c.r * c.r - (z - centre.z) * (z - centre.z)));
  return high.r + (z - high.z) * std::tan(b);
}

/// The same of the seven figures, by their own e and f.
double figured_radius(const SevenFigures& c, double z) {
  const double a = c.lower_angle * kDegree, b = c.upper_angle * kDegree, r = c.corner_radius;
  const double low_z = c.centre_height - r * std::cos(a);
  const double high_z = c.centre_height - r * std::sin(b);
  if (z <= low_z && a > 0) return z / std::tan(a);
  if (z < high_z)
    return c.centre_radius +
           std::sqrt(std::max(0.0, r * r - (z - c.centre_height) * (z - c.centre_height)));
  return c.centre_radius + r * std::cos(b) + (z - high_z) * std::tan(b);
}

void check_outline(const std::string& text, const Drawing& drawing) {
  CAPTURE(text);
  const SevenFigures c = seven_figures(parse_cutter(text));
  const Point centre = centre_of(drawing);
  CHECK(c.centre_radius == Approx(centre.r).margin(kMargin));
  CHECK(c.centre_height == Approx(centre.z).margin(kMargin));
  CHECK(c.diameter == Approx(drawing.d).margin(kMargin));
  CHECK(c.height == drawing.h);
  // A thousandth of the height off the ends: at the tip of a flat the radius jumps, and where an
  // arc begins level its slope is infinite.
  for (int i = 1; i < 1000; ++i) {
    const double z = drawing.h * i / 1000;
    CHECK(figured_radius(c, z) == Approx(drawn_radius(drawing, z)).margin(1e-9));
  }
}

}  // namespace

TEST_CASE("radii at heights by hand", "[unit][cutter]") {
  const auto radius = [](const std::string& text, double z) {
    return figured_radius(seven_figures(parse_cutter(text)), z);
  };
  CHECK(radius("flat:D=8,L=20", 0.001) == 4);
  CHECK(radius("flat:D=8,L=20", 20) == 4);
  // 3-4-5 triangles: 1 above the tip of a ball of radius 5 it is 3 wide, 2 above it 4.
  CHECK(radius("ball:D=10,L=20", 1) == Approx(3).epsilon(1e-14));
  CHECK(radius("ball:D=10,L=20", 2) == Approx(4).epsilon(1e-14));
  CHECK(radius("ball:D=10,L=20", 5) == Approx(5).epsilon(1e-14));
  CHECK(radius("bull:D=16,r=5,L=20", 1) == Approx(6).epsilon(1e-14));
  CHECK(radius("bull:D=16,r=5,L=20", 2) == Approx(7).epsilon(1e-14));
  CHECK(radius("bull:D=16,r=5,L=20", 9) == Approx(8).epsilon(1e-14));
  // A drill of 90 degrees is as wide as it is high.
  CHECK(radius("drill:D=6,angle=90,L=30", 1.25) == Approx(1.25).epsilon(1e-14));
  CHECK(radius("drill:D=6,angle=90,L=30", 3) == Approx(3).epsilon(1e-14));
  CHECK(radius("drill:D=6,angle=90,L=30", 20) == Approx(3).epsilon(1e-14));
  // A sharp taper of 45 degrees grows by its height.
  CHECK(radius("taper:D=2,angle=45,L=10", 4) == Approx(5).epsilon(1e-14));
  // A ball tip of radius 1 under 30 degrees: the cone touches the ball at half its radius below
  // the centre, at cos 30 from the axis; 1 mm above that place it is tan 30 wider.
  CHECK(radius("taper:D=2,r=1,angle=30,L=10", 1.5) ==
        Approx(std::sqrt(3.0) / 2 + 1 / std::sqrt(3.0)).epsilon(1e-14));
  // A dovetail of 45 degrees, sharp: as much narrower as it is higher.
  CHECK(radius("apt:D=10,b=-45,L=3", 2) == Approx(3).epsilon(1e-14));
}

TEST_CASE("figures of every type against the drawing", "[unit][cutter]") {
  check_outline("flat:D=8,L=20", {8, 0, 0, 0, 20});
  check_outline("ball:D=6,L=20", {6, 3, 0, 0, 20});
  check_outline("bull:D=8,r=1,L=20", {8, 1, 0, 0, 20});
  check_outline("drill:D=6,angle=118,L=30", {6, 0, 31, 0, 30});
  check_outline("apt:D=10,r=1,a=10,b=-5,L=20", {10, 1, 10, -5, 20});
  check_outline("apt:D=10,r=2,b=30,L=20", {10, 2, 0, 30, 20});
  check_outline("apt:D=10,r=1.5,a=20,b=-15,L=9", {10, 1.5, 20, -15, 9});
}

TEST_CASE("a taper's tip is tangent to its cone", "[unit][cutter]") {
  for (const auto& [diameter, corner, angle_deg] :
       {std::array{1.0, 0.5, 5.0}, std::array{2.0, 0.5, 10.0}, std::array{3.0, 0.0, 20.0}}) {
    const std::string rounding = corner > 0 ? ",r=" + std::to_string(corner) : std::string();
    const std::string text = "taper:D=" + std::to_string(diameter) + rounding +
                             ",angle=" + std::to_string(angle_deg) + ",L=20";
    // The tip's circle stands at D/2 - r; the cone touches it, and meets the level through the tip
    // at half the drawing's d: from the touching point down along the cone.
    const double b = angle_deg * kDegree, centre_r = diameter / 2 - corner;
    const Point touch{centre_r + corner * std::cos(b), corner - corner * std::sin(b)};
    const double meet_r = touch.r - touch.z * std::tan(b);
    check_outline(text, {2 * meet_r, corner, 0, angle_deg, 20});
    const Point centre = centre_of({2 * meet_r, corner, 0, angle_deg, 20});
    CHECK(centre.r == Approx(centre_r).margin(kMargin));
    CHECK(centre.z == Approx(corner).margin(kMargin));
    CHECK(largest_radius_mm(parse_cutter(text)) ==
          Approx(touch.r + (20 - touch.z) * std::tan(b)).epsilon(1e-12));
  }
}

TEST_CASE("corner circles touch bottom and side in one point each", "[property][cutter]") {
  std::mt19937 random(3592);
  std::uniform_real_distribution<double> lower(0, 40), upper(-35, 40), share(0.01, 0.5);
  int made = 0;
  for (int round = 0; round < 400; ++round) {
    Cutter cutter;
    cutter.type = CutterType::apt;
    cutter.diameter_mm = 10;
    cutter.flute_length_mm = 12;
    cutter.tip_angle_deg = lower(random);
    cutter.taper_angle_deg = upper(random);
    cutter.corner_radius_mm = 5 * share(random);
    try {
      require_valid(cutter);
    } catch (const std::invalid_argument&) {
      continue;
    }
    ++made;
    const SevenFigures c = seven_figures(cutter);
    const double a = cutter.tip_angle_deg * kDegree, b = cutter.taper_angle_deg * kDegree;
    // Distance of the centre from each line by points on the lines, not by normals: the least over
    // a dense walk is the perpendicular one within its step squared over twice the radius.
    double bottom = 1e300, side = 1e300;
    constexpr double kStep = 1e-3;
    for (double t = -10; t < 20; t += kStep) {
      bottom = std::min(
          bottom, std::hypot(t * std::cos(a) - c.centre_radius, t * std::sin(a) - c.centre_height));
      side = std::min(side, std::hypot(5 + t * std::sin(b) - c.centre_radius,
                                       5 * std::tan(a) + t * std::cos(b) - c.centre_height));
    }
    const double walk = kStep * kStep / 8 / cutter.corner_radius_mm + 1e-9;
    CHECK(bottom == Approx(cutter.corner_radius_mm).margin(walk));
    CHECK(side == Approx(cutter.corner_radius_mm).margin(walk));
    // Inside both: above the bottom line, nearer the axis than the side.
    CHECK(c.centre_height > c.centre_radius * std::tan(a));
    CHECK(c.centre_radius < 5 + (c.centre_height - 5 * std::tan(a)) * std::tan(b));
  }
  CHECK(made > 200);
}
