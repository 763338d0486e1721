#pragma once

#include <array>
#include <span>

#include "verifier/surface/bezier.h"

namespace limitgauge::verifier {

/// The runs of definition 2 start on S and go along its normals, so a search over S asks what is at
/// s + t·n(s) for all s of a cell at once. A cell seen that way, for any t:
///
///   |s + t·n(s) − (s + t·(n₀ + A·(s − m)))| ≤ |t|·remainder    for every s of the cell,
///
/// with m the cell's middle, n₀ the normal there and A a linear map of the tangent plane, which
/// turns the normal as the surface does. s + t·(n₀ + A·(s − m)) is affine in s, so the cell moved
/// that way lies in the hull of its control points moved that way, and the remainder shrinks with
/// the square of the cell's size (proof: CERTIFICATE.md, section 3b). Of a sharp edge, whose
/// normals fan out at every point, n₀ + x·`fan` for some x of −1 to 1 stands in place of n₀.
struct OffsetCell {
  Bezier shape;
  model::Vec3 middle;
  model::Vec3 normal;                    ///< n₀, a unit vector; zero where there is none
  std::array<model::Vec3, 3> turning{};  ///< the columns of A, per mm
  model::Vec3 fan;                       ///< across n₀; zero but of a sharp edge
  double remainder = 0;                  ///< at most 2: two unit vectors
  double spread_rad = 0;                 ///< every normal of the cell is this near to n₀

  /// A·w: how the normal turns from the middle to a place w away.
  model::Vec3 turned(const model::Vec3& w) const {
    return turning[0] * w.x + turning[1] * w.y + turning[2] * w.z;
  }
  /// The same from the middle to a control point, and to one side of the fan or the other: the
  /// hull of all control points with their turns is that of the cell with all its normals.
  model::Vec3 turned_to(int k) const {
    return turned(shape.control(k) - middle) + fan * ((k / 4) * (2.0 / 3) - 1);
  }
  /// The control points moved by t along the normals, but for |t|·remainder.
  Bezier moved(double t_mm) const;
  model::Vec3 moved_middle(double t_mm) const { return middle + normal * t_mm; }
};
/// The cell as another frame has it: what is proven of one holds of the other, but for rounding.
OffsetCell turned(OffsetCell cell, const model::Pose& pose);

/// Of a cell of S with the normals S_u × S_v, of which some may vanish; a `vertex_normal` that is
/// not zero stands for all of them.
OffsetCell offset_cell(const Bezier& cell, const model::Vec3& vertex_normal);
/// Of a point or a curve (control points that do not depend on v) all of whose normals lie within
/// `spread_rad` of the unit vector `normal`.
OffsetCell offset_cell(const Bezier& cell, const model::Vec3& normal, double spread_rad);
/// The same of normals that are positive combinations of `normals`, as they fan out across a curve
/// from `from` to `to`.
OffsetCell offset_cell(const Bezier& cell, const model::Vec3& normal, const model::Vec3& from,
                       const model::Vec3& to, std::span<const model::Vec3> normals);

}  // namespace limitgauge::verifier
