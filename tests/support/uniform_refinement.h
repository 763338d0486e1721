#pragma once

#include <optional>

#include "model/part/cage.h"

namespace limitgauge::tests {

/// One uniform Catmull-Clark step of a whole cage, written from OpenSubdiv's published rules
/// (uniform creasing, sharpness falling by one a step, the sharper rule blended in by what is left
/// of it) and sharing nothing with the libraries. Child faces stand in the order of the corners of
/// the faces, each beginning with the corner that it keeps. Under BoundaryRule::none boundaries are
/// refined like edge_only.
model::Cage refine_uniformly(const model::Cage& cage);

/// The limit positions of all vertices of a cage of quads by the limit masks; that of a dart by
/// iterating the rules of its ring. Empty where sharpness is still to be used up.
std::vector<std::optional<model::Vec3>> limit_positions(const model::Cage& cage);

/// What shapes the surface at a vertex of a cage. `count` is the number of edges of an interior
/// vertex, and of faces of another.
struct VertexClass {
  enum class Kind { interior, boundary, crease, dart, corner, semi_sharp } kind = Kind::interior;
  int count = 4;
};
std::vector<VertexClass> vertex_classes(const model::Cage& cage);

}  // namespace limitgauge::tests
