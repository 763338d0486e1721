#pragma once

#include "model/part/cage.h"

namespace limitgauge::engine::surface {

/// How a vertex moves under one refinement (OpenSubdiv's rules).
enum class VertexRule { smooth, dart, crease, corner };

inline bool is_sharp(double sharpness) {
  return sharpness > 0;
}
inline bool is_infinite(double sharpness) {
  return sharpness >= model::kInfiniteSharpness;
}

/// Sharpness of the children of an edge or vertex: one less, infinite stays.
inline double child_sharpness(double sharpness) {
  if (is_infinite(sharpness)) return sharpness;
  return sharpness > 1 ? sharpness - 1 : 0.0;
}

/// The rule of a vertex of the given own sharpness with `sharp_edges` sharp edges.
inline VertexRule vertex_rule(double own_sharpness, int sharp_edges) {
  if (is_sharp(own_sharpness) || sharp_edges > 2) return VertexRule::corner;
  if (sharp_edges == 2) return VertexRule::crease;
  return sharp_edges == 1 ? VertexRule::dart : VertexRule::smooth;
}

}  // namespace limitgauge::engine::surface
