#pragma once

#include <array>

#include "verifier/bezier.h"

namespace limitgauge::verifier {

/// The runs of definition 2 start on S and go along its normals, so a search over S asks what is at
/// s + t·n(s) for all s of a cell at once. A cell seen that way, for any t:
///
///   |s + t·n(s) − (s + t·(n₀ + A·(s − m)))| ≤ |t|·remainder    for every s of the cell,
///
/// with m the cell's middle, n₀ the normal there and A a linear map of the tangent plane, which
/// turns the normal as the surface does. s + t·(n₀ + A·(s − m)) is affine in s, so the cell moved
/// that way lies in the hull of its control points moved that way, and the remainder shrinks with
/// the square of the cell's size (proof: CERTIFICATE.md, section 3b).
struct OffsetCell {
  Bezier shape;
  model::Vec3 middle;
  model::Vec3 normal;                    ///< n₀, a unit vector; zero where there is none
  std::array<model::Vec3, 3> turning{};  ///< the columns of A, per mm
  double remainder = 0;                  ///< at most 2: two unit vectors
  double spread_rad = 0;                 ///< every normal of the cell is this near to n₀

  /// A·w: how the normal turns from the middle to a place w away.
  model::Vec3 turned(const model::Vec3& w) const {
    return turning[0] * w.x + turning[1] * w.y + turning[2] * w.z;
  }
  /// The control points moved by t along the normals, but for |t|·remainder.
  Bezier moved(double t_mm) const;
  model::Vec3 moved_middle(double t_mm) const { return middle + normal * t_mm; }
};

/// Of a cell of S with the normals S_u × S_v, of which some may vanish; a `vertex_normal` that is
/// not zero stands for all of them.
OffsetCell offset_cell(const Bezier& cell, const model::Vec3& vertex_normal);
/// Of a point or a curve (control points that do not depend on v) all of whose normals lie within
/// `spread_rad` of the unit vector `normal`.
OffsetCell offset_cell(const Bezier& cell, const model::Vec3& normal, double spread_rad);

}  // namespace limitgauge::verifier
