#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "model/part/cage.h"

namespace limitgauge::verifier {

/// What the limit surface is like at a place. Semi-sharp creases and corners are smooth in the
/// limit.
enum class SurfaceFeature : std::uint8_t {
  smooth,                ///< inside a patch, or where patches join smoothly
  extraordinary_vertex,  ///< smooth, inner vertex of a valence other than 4
  crease,                ///< on an infinitely sharp edge: two tangent planes
  boundary,              ///< where the surface ends
  corner,                ///< infinitely sharp vertex, end of several creases, or corner of the rim
  dart                   ///< the one end of a crease in smooth surface
};
const char* name(SurfaceFeature feature);

/// Features along the sides of one patch: side k runs from corner k to corner k + 1; the corners
/// stand at (u, v) = (0, 0), (1, 0), (1, 1), (0, 1).
struct PatchFeatures {
  std::array<SurfaceFeature, 4> sides{};    ///< smooth, crease or boundary
  std::array<SurfaceFeature, 4> corners{};  ///< any
  std::array<bool, 4> open{};               ///< the surface does not go all round the corner
};

/// The features of all patches of a cage, numbered as ReferenceSurface numbers them. Holes, and the
/// faces that BoundaryRule::none leaves out, end the surface as a boundary does.
class SurfaceFeatures {
 public:
  SurfaceFeatures() = default;
  explicit SurfaceFeatures(const model::Cage& cage);
  const PatchFeatures& of(int patch) const { return patches_[patch]; }

 private:
  std::vector<PatchFeatures> patches_;
};

}  // namespace limitgauge::verifier
