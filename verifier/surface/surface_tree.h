#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "model/geometry/vec3.h"
#include "model/part/cage.h"
#include "verifier/surface/bezier.h"
#include "verifier/surface/sharp_lines.h"
#include "verifier/surface/surface_features.h"
#include "verifier/surface/surface_sample.h"

namespace limitgauge::verifier {

/// A square of a patch's parameters: [u, u + size] × [v, v + size].
struct ParameterSquare {
  int patch = 0;
  double u = 0, v = 0, size = 1;
};

/// A polynomial piece of the limit surface.
struct Piece {
  Bezier shape;
  ParameterSquare square;
};

/// What is left around an irregular vertex when refinement has reached double precision: the
/// surface over `square` is `position`.
struct Speck {
  model::Vec3 position, tangent_u, tangent_v, normal;
  TangentPlane plane = TangentPlane::everywhere;
  ParameterSquare square;
};

/// One quadtree a patch, down to pieces and specks.
class SurfaceTree {
 public:
  explicit SurfaceTree(const model::Cage& cage);

  int patch_count() const { return static_cast<int>(roots_.size()); }
  bool has_surface(int patch) const { return roots_[patch] >= 0; }
  SurfaceSample evaluate(int patch, double u, double v) const;
  const std::vector<Piece>& pieces() const { return pieces_; }
  const std::vector<Speck>& specks() const { return specks_; }
  /// The pieces but for those that lie within `omitted_mm` of a speck of their patch, which can
  /// stand for them.
  std::vector<const Piece*> pieces_beyond(double omitted_mm) const;
  const model::Box3& bounding_box() const { return bounding_box_; }
  double area_mm2() const { return area_mm2_; }
  const SurfaceFeatures& features() const { return features_; }
  const SharpLines& sharp_lines() const { return sharp_lines_; }

 private:
  friend class SurfaceTreeBuilder;
  struct Node {
    enum class Kind : std::uint8_t { inner, piece, speck } kind = Kind::inner;
    std::array<std::int32_t, 4> child{};  ///< of an inner node: at (0,0), (1,0), (1,1), (0,1)
    std::int32_t index = 0;               ///< of the piece or speck
  };
  std::vector<std::int32_t> roots_;  ///< by patch; negative where there is no surface
  std::vector<Node> nodes_;
  std::vector<Piece> pieces_;
  std::vector<Speck> specks_;
  SurfaceFeatures features_;
  SharpLines sharp_lines_;
  model::Box3 bounding_box_;
  double area_mm2_ = 0;
};

/// Extremes of the surface itself in x, y and z, to 1e-10 mm, by branch and bound on the pieces.
model::Box3 exact_bounding_box(const SurfaceTree& tree);
/// Sum over the pieces by Gauss-Legendre quadrature: each is quartered until the same quadrature
/// over its quarters differs by no more than kAreaStep of the whole area.
double surface_area_mm2(const SurfaceTree& tree);

}  // namespace limitgauge::verifier
