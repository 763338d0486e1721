#include "verifier/surface/surface_features.h"

#include <algorithm>
#include <map>

#include "model/part/cage.h"
#include "verifier/surface/neighbourhood.h"

namespace limitgauge::verifier {
namespace {

using model::Index;

/// What meets at a vertex of the cage.
struct Meeting {
  int edges = 0, creases = 0, boundaries = 0;  ///< boundaries of the cage
  int faces = 0, surface_faces = 0;
  bool rim = false;  ///< an edge here ends the surface though the cage goes on
  bool sharp = false;

  bool open() const { return rim || boundaries > 0; }
};

/// A rim left by holes follows the patches' sides; it goes straight through a regular vertex that
/// keeps two faces.
SurfaceFeature feature_of(const Meeting& m) {
  if (m.sharp) return SurfaceFeature::corner;
  const int lines = m.creases + m.boundaries;
  if (m.rim) {
    const bool straight = lines == 0 && m.edges == 4 && m.surface_faces == 2;
    return straight ? SurfaceFeature::boundary : SurfaceFeature::corner;
  }
  if (lines > 2) return SurfaceFeature::corner;
  if (lines == 2) return m.boundaries > 0 ? SurfaceFeature::boundary : SurfaceFeature::crease;
  if (lines == 1) return SurfaceFeature::dart;
  return m.edges == 4 ? SurfaceFeature::smooth : SurfaceFeature::extraordinary_vertex;
}

class FeatureFinder {
 public:
  explicit FeatureFinder(const model::Cage& cage)
      : cage_(cage),
        neighbourhoods_(cage),
        side_(cage.face_corners.size(), SurfaceFeature::smooth),
        vertex_(cage.vertices.size()) {
    for (Index f = 0; f < cage.face_count(); ++f)
      for (const Index v : cage.face(f))
        ++vertex_[v].faces, vertex_[v].surface_faces += neighbourhoods_.has_surface(f);
    read_edges();
    for (const model::Corner& c : cage.corners)
      if (c.sharpness >= model::kInfiniteSharpness) vertex_[c.vertex].sharp = true;
    if (cage.boundary == model::BoundaryRule::edge_and_corner)
      for (Meeting& m : vertex_) m.sharp = m.sharp || (m.boundaries > 0 && m.faces == 1);
  }

  void add_patches(Index face, std::vector<PatchFeatures>& out) const {
    const Index first = cage_.face_offsets[face];
    const int n = cage_.face_offsets[face + 1] - first;
    if (n == 4) {
      PatchFeatures p;
      for (int k = 0; k < 4; ++k) p.sides[k] = side_[first + k], set_corner(p, k, first + k);
      out.push_back(p);
      return;
    }
    for (int k = 0; k < n; ++k) out.push_back(part_of_polygon(first, n, k));
  }

 private:
  void read_edges() {
    std::map<std::pair<Index, Index>, double> creases;
    for (const model::Crease& c : cage_.creases)
      creases[std::minmax(c.vertices[0], c.vertices[1])] = c.sharpness;
    model::for_each_edge(model::sorted_edge_uses(cage_), [&](std::span<const model::EdgeUse> uses) {
      const auto crease = creases.find({uses[0].low, uses[0].high});
      const bool sharp = crease != creases.end() && crease->second >= model::kInfiniteSharpness;
      const auto carrying = std::count_if(uses.begin(), uses.end(), [&](const auto& use) {
        return neighbourhoods_.has_surface(use.face);
      });
      const bool ends = carrying == 1;
      for (const model::EdgeUse& use : uses)
        side_[use.corner] = ends    ? SurfaceFeature::boundary
                            : sharp ? SurfaceFeature::crease
                                    : SurfaceFeature::smooth;
      for (const Index v : {uses[0].low, uses[0].high}) {
        Meeting& m = vertex_[v];
        ++m.edges;
        if (uses.size() == 1)
          ++m.boundaries;
        else if (sharp)
          ++m.creases;
        m.rim = m.rim || (ends && uses.size() > 1);
      }
    });
  }

  void set_corner(PatchFeatures& p, int k, Index corner) const {
    const Meeting& m = vertex_[cage_.face_corners[corner]];
    p.corners[k] = feature_of(m), p.open[k] = m.open();
  }

  /// The quad at corner k: along half of the edge ahead, through the polygon's centre, along half
  /// of the edge behind.
  PatchFeatures part_of_polygon(Index first, int n, int k) const {
    PatchFeatures p;
    const SurfaceFeature ahead = side_[first + k], behind = side_[first + (k + n - 1) % n];
    p.sides = {ahead, SurfaceFeature::smooth, SurfaceFeature::smooth, behind};
    set_corner(p, 0, first + k);
    p.corners[1] = ahead, p.open[1] = ahead == SurfaceFeature::boundary;
    p.corners[2] = SurfaceFeature::extraordinary_vertex;
    p.corners[3] = behind, p.open[3] = behind == SurfaceFeature::boundary;
    return p;
  }

  const model::Cage& cage_;
  CageNeighbourhoods neighbourhoods_;
  std::vector<SurfaceFeature> side_;  // beside cage.face_corners
  std::vector<Meeting> vertex_;
};

}  // namespace

const char* name(SurfaceFeature feature) {
  switch (feature) {
    case SurfaceFeature::extraordinary_vertex:
      return "extraordinary vertex";
    case SurfaceFeature::crease:
      return "crease";
    case SurfaceFeature::boundary:
      return "boundary";
    case SurfaceFeature::corner:
      return "corner";
    case SurfaceFeature::dart:
      return "dart";
    default:
      return "smooth";
  }
}

SurfaceFeatures::SurfaceFeatures(const model::Cage& cage) {
  const FeatureFinder finder(cage);
  for (Index f = 0; f < cage.face_count(); ++f) finder.add_patches(f, patches_);
}

}  // namespace limitgauge::verifier
