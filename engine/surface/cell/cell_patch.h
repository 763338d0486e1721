#pragma once

#include <array>
#include <vector>

#include "engine/surface/cell/corner_ring.h"
#include "engine/surface/cell/limit_patch.h"

namespace limitgauge::engine::surface {

/// Where edge `c` of a patch lies in the padded array: from corner c to corner c + 1.
struct PatchSide {
  int base = 0;     ///< index of corner c
  int along = 0;    ///< to the next point of the edge
  int outward = 0;  ///< to the strip across the edge
};

/// A point in single precision, as the paper stores them.
struct FloatPoint {
  float x = 0, y = 0, z = 0;
  FloatPoint() = default;
  FloatPoint(const Vec3& p)
      : x(static_cast<float>(p.x)), y(static_cast<float>(p.y)), z(static_cast<float>(p.z)) {}
  operator Vec3() const { return {x, y, z}; }
};

/// Bytes of CELL at a depth as the paper counts them (section 8.1): the arrays A_c and A_e,
/// ((2^n + 1)² + 4 (2^n + 1)) points of `point_bytes` each (12 in single precision).
std::size_t cell_bytes_counted(int depth, std::size_t point_bytes);
/// Bytes of the same points in a half-edge structure as the paper counts them: (2^n + 1)² points
/// with 22 pointers of 8 bytes each.
std::size_t half_edge_bytes_counted(int depth, std::size_t point_bytes);

/// CELL, inner layer (paper section 3): the control points of one subdivision surface patch at
/// some depth. The array A_c of (2^depth + 1)² points is stored with a border one point wide; its
/// four sides are the strips A_e of the neighbours. Its four corners are not used: corners refine
/// through their rings A_v. Patches refine independently of each other. `Point` is what is
/// stored; sums are made in double precision.
template <class Point>
class BasicCellPatch {
 public:
  /// Depth 0 of the quad `face`, whose half-edges give the four sides in order.
  BasicCellPatch(const OuterMesh& mesh, Index face);

  /// The cell at corner `c` of this patch as a patch of its own, at depth 0: so that a corner whose
  /// surface bends more and more refines without the rest. Needs depth 1 or more, and no
  /// semi-sharp tags.
  BasicCellPatch corner_cell(int c) const;

  /// Figure 3: corners by their rings, sides by A_c and A_e, the interior by A_c; then the strips.
  void refine();
  int depth() const { return depth_; }
  int cells() const { return 1 << depth_; }
  /// Depth from which no semi-sharp tag is left, so that limit masks hold.
  int smallest_limit_depth() const;
  LimitPatch limit() const;

  /// Control point (u, v), -1 to cells() + 1; a border point exists where has_border says so.
  Vec3 control(int u, int v) const { return net_[at(u, v)]; }
  bool has_border(int side) const { return !open_[side]; }
  /// Whether the surface has a crease along `side` at this depth (boundaries included).
  bool sharp_side(int side) const { return is_sharp(sharpness_[side]); }
  const CornerRing& ring(int corner) const { return rings_[corner]; }
  /// As allocated: the padded array, the patch itself and its rings.
  std::size_t memory_bytes() const { return memory_bytes_of(sizeof(Point)); }
  /// The same with points of another size.
  std::size_t memory_bytes_of(std::size_t point_bytes) const;

 private:
  BasicCellPatch() = default;
  CornerRing ring_on_first_side(int c) const;
  CornerRing ring_inside(int c) const;
  CornerRing ring_on_last_side(int c) const;
  Vec3 from_corner(int c, int along, int inward) const;
  int width() const { return cells() + 3; }
  int at(int u, int v) const { return (v + 1) * width() + u + 1; }
  PatchSide side(int c, int cells) const;
  void refine_interior(std::vector<Point>& fine) const;
  void refine_side(int c, std::vector<Point>& fine) const;
  void refine_strip(int c, std::vector<Point>& fine) const;
  void place_corners(std::vector<Point>& net, int cells) const;
  void limit_interior(LimitPatch& limit) const;
  void limit_side(int c, LimitPatch& limit) const;
  void limit_corners(LimitPatch& limit) const;

  int depth_ = 0;
  std::vector<Point> net_;
  std::vector<CornerRing> rings_;  ///< four
  std::array<bool, 4> open_{};
  std::array<double, 4> sharpness_{};
};

extern template class BasicCellPatch<Vec3>;
extern template class BasicCellPatch<FloatPoint>;
using CellPatch = BasicCellPatch<Vec3>;
using FloatCellPatch = BasicCellPatch<FloatPoint>;

}  // namespace limitgauge::engine::surface
