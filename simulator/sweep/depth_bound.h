#pragma once

#include <array>
#include <cstdint>

#include "simulator/stock/material.h"

namespace limitgauge::simulator {

/// The material at one moment of a pass: what stood before it, less what the moves of path index
/// below `end` swept.
struct MaterialAtMove {
  const Material* before = nullptr;
  const SweepIndex* pass = nullptr;  ///< null: nothing has cut it
  std::uint32_t end = 0;
};

/// What bounds the depth somewhere: a maker of the stock before, or a move of the pass itself.
struct Cover {
  bool of_pass = false;
  SurfaceMaker maker;  ///< of the pass: its slot
};

/// Depth in the material, its gradient, and by how much it may rise above its tangent.
struct Depth {
  double value = 0;
  model::Vec3 gradient;
  double bend = 0;
  Cover cover;
};

/// The depth at `p` under one cover alone, never less than the depth under all of them, with the
/// bend that holds where |δ_a| <= half_a and the depth is positive. For half = 0 it is the cover's
/// own; else it may be an upper bound where the cover is a mesh.
Depth depth_under(const MaterialAtMove& m, const Cover& cover, const model::Vec3& p,
                  const model::Vec3& half);
/// The cover that gives the depth at p, looking first at `guess`.
Cover cover_at(const MaterialAtMove& m, const model::Vec3& p, const Cover& guess);

/// Largest value of v·δ over the box |δ_a| <= half_a.
double support(const model::Vec3& half, const model::Vec3& v);
/// Upper bound of the depth over the part of a block where the convex distance s, `body` at the
/// block's middle, is not above zero (simulator/PROOFS.md, P2).
double depth_bound(const Depth& d, const SweptSample& body, const model::Vec3& half);

/// The same where two covers bound the depth together, which then lies below every mean of their
/// tangents: what two moves have cut that only just meet. Never more than `depth_bound` of `a`.
double depth_bound(const Depth& a, const Depth& b, const SweptSample& body,
                   const model::Vec3& half);

/// An axis-aligned block of a search in the material.
struct Block {
  model::Vec3 middle, half;
  double bound = 0;
  Cover cover;
};
/// The block cut in two across its longest edge.
std::array<Block, 2> halves(const Block& b);

/// Everything that a body may fill along a move.
model::Box3 swept_box(const CutterProfile& body, const SweptMove& move);
model::Box3 common(const model::Box3& a, const model::Box3& b);

}  // namespace limitgauge::simulator
