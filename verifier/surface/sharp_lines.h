#pragma once

#include <array>
#include <vector>

#include "model/part/cage.h"

namespace limitgauge::verifier {

/// A side of a patch, or where it is: sides as in PatchFeatures, from `from` to `to` of an edge of
/// the cage, 0 at its lower vertex and 1 at the other.
struct PatchSide {
  int patch = 0, side = 0;
  double from = 0, to = 1;
};

/// An infinitely sharp edge between two faces that carry the surface: the patches on its two sides,
/// each one, or two where the face is no quad.
struct SharpEdge {
  std::array<std::vector<PatchSide>, 2> sides;
};

/// A corner of a patch at a sharp vertex: corners as in PatchFeatures.
struct PatchCorner {
  int patch = 0, corner = 0;
};

/// Where normals of the limit surface jump: sharp edges, and the vertices where more than two of
/// them meet or that are sharp themselves, each with all patches around it.
struct SharpLines {
  std::vector<SharpEdge> edges;
  std::vector<std::vector<PatchCorner>> vertices;

  SharpLines() = default;
  explicit SharpLines(const model::Cage& cage);
};

}  // namespace limitgauge::verifier
