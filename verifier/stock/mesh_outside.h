#pragma once

#include <array>
#include <memory>
#include <optional>

#include "verifier/cutter/swept_body.h"
#include "verifier/stock/mesh_side.h"
#include "verifier/surface/bezier.h"

namespace limitgauge::verifier {

/// What lies outside a closed triangle mesh, the raw stock. Its signed distance d is the distance
/// to the nearest triangle, negative outside the mesh: it changes by no more than the way gone, and
/// is neither convex nor concave.
///
/// Bounds of d on a Bézier cell with control points P_k, middle m and radius r (CERTIFICATE.md,
/// section 3a, has the proofs): for a unit vector v, a length t ≥ 0, and the cell moved by t·v,
///   proven inside the mesh by μ   ⇒  d ≥ μ − t on the cell,
///   proven outside by μ           ⇒  d ≤ t − μ.
/// The moved cell is proven to lie on the side of its middle, μ away from the mesh, by one plane
/// for each triangle near it: dist(s, T) ≥ g·s − max over T of g·x for every unit vector g.
/// v goes straight to the nearest point of the mesh, and r beyond it: over a face of the mesh, or
/// over many small ones that bend little, both bounds are right to second order, whatever side of
/// the mesh S is on and where it crosses to and fro.
class MeshOutside {
 public:
  /// Throws as TriangleTree does.
  explicit MeshOutside(const model::TriangleMesh& mesh);

  /// The same of the mesh moved outwards by so much: less lies outside of it. d is greater by that.
  MeshOutside beyond(double mm) const;

  /// The gradient points into the mesh.
  BodyDistance distance(const model::Vec3& p) const;
  /// The same where it is not above `limit_mm`: fast for points deeper in the mesh than that.
  std::optional<BodyDistance> distance_up_to(const model::Vec3& p, double limit_mm) const;

  /// The first t in [0, limit_mm] at which p + t·ray, a unit vector, comes within `within_mm` > 0
  /// of the mesh: up to there it stays on the side of it that p is on. The limit where it never
  /// does.
  double same_side_up_to(const model::Vec3& p, const model::Vec3& ray, double limit_mm,
                         double within_mm) const {
    return tree_->first_near(p, ray, limit_mm, within_mm + beyond_mm_);
  }

  /// Bounds of d on `cell`, by what it is at its middle.
  double lower(const Bezier& cell, const model::Vec3& middle, const BodyDistance& d) const;
  double upper(const Bezier& cell, const model::Vec3& middle, const BodyDistance& d) const;
  /// At the control points, a convex function that is nowhere below d: the distance to the triangle
  /// that is nearest to the cell's middle.
  void values(const Bezier& cell, std::array<double, 16>& out) const;

 private:
  BodyDistance signed_by(const TriangleTree::Foot& foot, const model::Vec3& p, bool inside) const;
  std::optional<double> clearance(const Bezier& cell, const model::Vec3& move, double radius_mm,
                                  const model::Vec3& away, bool inside) const;

  std::shared_ptr<const TriangleTree> tree_;  // MeshSide points to it
  MeshSide side_;
  double beyond_mm_ = 0;
};

}  // namespace limitgauge::verifier
