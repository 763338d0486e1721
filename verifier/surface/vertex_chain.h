#pragma once

#include <array>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "verifier/surface/refinement.h"
#include "verifier/surface/regular_piece.h"

namespace limitgauge::verifier {

/// A refinement that gives back the faces and the sharpness it began with, but closer to the one
/// irregular corner of face 0: from there on it is the same one again and again. The other three
/// children are polynomials.
class ChainStep {
 public:
  /// Where the children of `n` are not like that, none.
  static std::shared_ptr<const ChainStep> of(const Neighbourhood& n, int corner);

  int corner() const { return corner_; }
  /// Faces about the irregular vertex.
  std::size_t valence() const { return star_of(net_, net_.corner(0, corner_)).wedges.size(); }
  /// Faces and sharpness of all levels, without points.
  const Neighbourhood& net() const { return net_; }
  /// All points of the next level.
  std::vector<model::Vec3> refined(std::span<const model::Vec3> points) const {
    return step_.points(points);
  }
  /// Of `refined`: the polynomial over child `k`, which is not at the corner.
  Bezier piece(int k, std::span<const model::Vec3> refined) const {
    return piece_of(grids_[static_cast<std::size_t>(k)], refined);
  }
  /// Of `refined`: the points round the child at the corner.
  std::vector<model::Vec3> inner(std::span<const model::Vec3> refined) const;

 private:
  explicit ChainStep(const Neighbourhood& n, int corner) : step_(n), corner_(corner) {}

  Refinement step_;
  Neighbourhood net_;
  int corner_;
  std::vector<model::Index> inner_;
  std::array<RegularGrid, 4> grids_;  ///< their points are those of `refined`
};

/// The levels about an irregular vertex, kept as their first one's points: what they hold is worked
/// out when it is asked for, and is the same to the bit every time.
struct VertexChain {
  std::shared_ptr<const ChainStep> step;
  std::vector<model::Vec3> points;
  int levels = 0;  ///< of pieces; a speck lies within the last
  std::size_t memory_bytes() const { return sizeof(*this) + points.capacity() * sizeof(points[0]); }
};

}  // namespace limitgauge::verifier
