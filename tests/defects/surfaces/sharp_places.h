#pragma once

#include <vector>

#include "model/part/cage.h"
#include "tests/defects/surfaces/sampled_surface.h"

namespace limitgauge::tests::defects {

/// N(s), the unit normals of S at its places: one where S is smooth and at an open boundary, and
/// all between the faces' along convex creases and at convex corners. Told by the exact normals of
/// the patches that meet, so semi-sharp creases count as smooth. Cages whose faces are not all
/// quads have no sharp places here.
class SharpPlaces {
 public:
  SharpPlaces(const model::Cage& cage, const SampledSurface& surface);

  /// Normals that span N(s): those of the faces that meet at `place`, all the same ones once.
  struct Span {
    std::vector<model::Vec3> faces;
    bool convex = true;  ///< all between them belong to N(s) too
  };
  Span span_at(const Place& place) const;
  /// The place, and if it is within a nanometre of a corner of its patch those beside that corner
  /// on all patches that meet there, on their edges too: what may be said of the corner holds
  /// there.
  std::vector<Place> beside(const Place& place) const;
  /// N(s) as a fan: of an edge `count` normals, of a corner about count²/2, else the faces' own.
  std::vector<model::Vec3> fan(const Place& place, int count) const;
  /// Samples along all sharp edges, their ends included, no further apart than the surface's.
  const std::vector<Place>& samples() const { return samples_; }

 private:
  struct SideRef {
    int patch = -1, side = 0;
  };
  struct CornerRef {
    int patch = 0, corner = 0;
  };
  std::vector<Place> same_places(const Place& place) const;
  bool convex_between(const std::vector<Place>& places) const;
  void link(const model::Cage& cage);
  void sample_edges();

  const SampledSurface& surface_;
  bool quads_only_ = true;
  std::vector<model::Index> corners_;           ///< four vertices a patch
  std::vector<std::vector<CornerRef>> around_;  ///< by vertex
  std::vector<std::array<SideRef, 4>> across_;  ///< the patch beyond each side
  std::vector<Place> samples_;
};

}  // namespace limitgauge::tests::defects
