#pragma once

#include <array>

#include "model/geometry/interval.h"
#include "model/geometry/pose.h"
#include "model/geometry/vec3.h"

namespace limitgauge::verifier {

/// A bicubic Bézier patch over [0, 1]²; control point (i, j) stands at index 4·j + i, i along u.
/// Coordinates are kept apart so that a loop over the sixteen points runs in vector registers.
struct Bezier {
  std::array<double, 16> x{}, y{}, z{};

  model::Vec3 control(int k) const { return {x[k], y[k], z[k]}; }
  void set(int k, const model::Vec3& p) { x[k] = p.x, y[k] = p.y, z[k] = p.z; }
};

/// Position and derivatives at a parameter, in mm and mm per unit of parameter.
struct BezierJet {
  model::Vec3 position, du, dv, duu, duv, dvv;
};

/// The Bézier form of the uniform bicubic B-spline piece with control points `grid` (index 4·j +
/// i).
Bezier from_bspline(const std::array<model::Vec3, 16>& grid);
model::Vec3 point(const Bezier& b, double u, double v);
/// S_u × S_v at a parameter, of length one; zero where that vanishes.
model::Vec3 unit_normal(const Bezier& b, double u, double v);
/// The control points along the four sides, one after the other all round.
inline constexpr int kSidesRound[4][4] = {
    {0, 1, 2, 3}, {3, 7, 11, 15}, {15, 14, 13, 12}, {12, 8, 4, 0}};
/// The point at (1/2, 1/2).
model::Vec3 middle(const Bezier& b);
BezierJet jet(const Bezier& b, double u, double v);
/// The halves [0, 1/2] and [1/2, 1] in u, or in v (de Casteljau).
std::array<Bezier, 2> split_u(const Bezier& b);
std::array<Bezier, 2> split_v(const Bezier& b);
/// The chords of the two inner rows of control points along u, added, and those along v.
struct InnerChords {
  model::Vec3 u, v;
};
InnerChords inner_chords(const Bezier& b);
/// Whether the sides along u are at least as long, from corner to corner, as those along v.
bool longer_in_u(const Bezier& b);
/// The longest distance from the first to the last control point along u, and along v.
double extent_u(const Bezier& b);
double extent_v(const Bezier& b);
/// The halves of the longer way, by longer_in_u.
std::array<Bezier, 2> halved(const Bezier& b);
/// By how much at most a linear function of this gradient changes from one control point to another
/// of a row along u, and of one along v: a bound on what halving along them can narrow.
struct Change {
  double u = 0, v = 0;

  double most() const { return u > v ? u : v; }
};
Change change_of(const Bezier& b, const model::Vec3& gradient);
/// The part of `b` over [u0, u1] × [v0, v1], reparametrised to [0, 1]².
Bezier restrict(const Bezier& b, double u0, double u1, double v0, double v1);
/// Area by Gauss-Legendre quadrature, five points a side: exact to rounding where the patch is
/// small against its bends.
double area_mm2(const Bezier& b);
/// Box of the control points; contains the patch.
model::Box3 control_box(const Bezier& b);
/// The patch moved.
Bezier shifted(Bezier b, const model::Vec3& by);
/// The patch as another frame has it.
Bezier turned(Bezier b, const model::Pose& pose);
/// Least and greatest base + g·P over the control points.
model::Interval control_range(const Bezier& b, double base, const model::Vec3& g);
/// Greatest distance from `centre` to a control point: every point of the patch is within it.
double control_radius(const Bezier& b, const model::Vec3& centre);

}  // namespace limitgauge::verifier
