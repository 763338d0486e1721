#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "model/base/run_control.h"
#include "model/geometry/vec3.h"
#include "model/mesh/triangle_mesh.h"
#include "model/part/cage.h"
#include "verifier/surface/bezier.h"
#include "verifier/surface/sharp_lines.h"
#include "verifier/surface/surface_features.h"
#include "verifier/surface/surface_sample.h"
#include "verifier/surface/vertex_chain.h"

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

/// One quadtree a patch, down to pieces and specks. About an irregular vertex, where one step of
/// refinement is like the next, only what the first one starts from is kept (VertexChain).
class SurfaceTree {
 public:
  /// Throws model::Interrupted when `control` asks to stop.
  explicit SurfaceTree(const model::Cage& cage, const model::RunControl& control = {});
  /// The facets of a mesh as they are: three patches a triangle, one a corner, as of a face of
  /// three corners of a cage; each is the bilinear quad of the corner, the middles of the edges
  /// beside it and the centroid.
  explicit SurfaceTree(const model::TriangleMesh& mesh, const model::RunControl& control = {});

  int patch_count() const { return static_cast<int>(parts_.roots.size()); }
  /// Whether it is made of the facets of a mesh: its pieces are flat, and whole patches.
  bool is_faceted() const { return is_faceted_; }
  bool has_surface(int patch) const { return parts_.roots[patch] >= 0; }
  SurfaceSample evaluate(int patch, double u, double v) const;
  /// All pieces of a patch, always in the same order.
  std::vector<Piece> pieces_of(int patch) const;
  /// The pieces but for those that lie within `omitted_mm` of a speck of their patch, which can
  /// stand for them.
  std::vector<Piece> pieces_beyond(int patch, double omitted_mm) const;
  /// By patch.
  const std::vector<Speck>& specks() const { return parts_.specks; }
  std::span<const Speck> specks_of(int patch) const;
  const model::Box3& bounding_box() const { return bounding_box_; }
  double area_mm2() const { return area_mm2_; }
  const SurfaceFeatures& features() const { return features_; }
  const SharpLines& sharp_lines() const { return sharp_lines_; }
  std::size_t memory_bytes() const;
  /// How many pieces pieces_of() works out about irregular vertices, of all patches, each as often
  /// as more than three faces meet at its vertex: about three the curvature tends to nothing, and
  /// the more there are, the faster it grows.
  std::size_t bent_pieces_about_vertices() const;

 private:
  friend class SurfaceTreeBuilder;
  struct Node {
    enum class Kind : std::uint8_t { inner, piece, chain, speck } kind = Kind::inner;
    std::array<std::int32_t, 4> child{};  ///< of an inner node: at (0,0), (1,0), (1,1), (0,1)
    std::int32_t index = 0;               ///< of the piece, the chain or the speck
  };
  /// Its square, and the speck at its end.
  struct PlacedChain {
    VertexChain chain;
    ParameterSquare square;
    std::int32_t speck = 0;
  };
  /// Of some patches that follow each other.
  struct Parts {
    std::vector<std::int32_t> roots;  ///< by patch; negative where there is no surface
    std::vector<Node> nodes;
    std::vector<Piece> pieces;
    std::vector<Speck> specks;
    std::vector<PlacedChain> chains;
    void append(Parts&& more);
  };
  /// Features, lines, box and area of what `parts_` holds.
  void complete(const model::Cage& cage, const model::RunControl& control);
  void add_pieces(std::int32_t node, std::vector<Piece>& out) const;
  static void add_pieces(const PlacedChain& placed, std::vector<Piece>& out);
  SurfaceSample in_chain(const PlacedChain& placed, double u, double v, double scale) const;
  SurfaceSample at_speck(const Speck& speck) const;
  Parts parts_;
  SurfaceFeatures features_;
  SharpLines sharp_lines_;
  model::Box3 bounding_box_;
  double area_mm2_ = 0;
  bool is_faceted_ = false;
};

/// The square of child `k` of a square.
ParameterSquare child_square(const ParameterSquare& s, int k);

/// Extremes of the surface itself in x, y and z, to 1e-10 mm, by branch and bound on the pieces.
model::Box3 exact_bounding_box(const SurfaceTree& tree, const model::RunControl& control);
/// Sum over the pieces by Gauss-Legendre quadrature: each is quartered until the same quadrature
/// over its quarters differs by no more than kAreaStep of the whole area.
double surface_area_mm2(const SurfaceTree& tree, const model::RunControl& control);

}  // namespace limitgauge::verifier
