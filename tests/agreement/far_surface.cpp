#include "tests/agreement/far_surface.h"

#include <opensubdiv/far/primvarRefiner.h>
#include <opensubdiv/far/topologyDescriptor.h>
#include <opensubdiv/far/topologyRefinerFactory.h>

#include <map>
#include <memory>
#include <stdexcept>

namespace limitgauge::tests {
namespace {

namespace Far = OpenSubdiv::Far;
namespace Sdc = OpenSubdiv::Sdc;
using model::Cage;
using model::Index;
using model::Vec3;

/// A position as PrimvarRefinerReal<double> combines it.
struct Primvar {
  Vec3 p;
  void Clear() { p = {}; }
  void AddWithWeight(const Primvar& other, double weight) { p += other.p * weight; }
};

Sdc::Options options_of(const Cage& cage) {
  using Rule = Sdc::Options;
  Sdc::Options options;
  switch (cage.boundary) {
    case model::BoundaryRule::none:
      options.SetVtxBoundaryInterpolation(Rule::VTX_BOUNDARY_NONE);
      break;
    case model::BoundaryRule::edge_only:
      options.SetVtxBoundaryInterpolation(Rule::VTX_BOUNDARY_EDGE_ONLY);
      break;
    case model::BoundaryRule::edge_and_corner:
      options.SetVtxBoundaryInterpolation(Rule::VTX_BOUNDARY_EDGE_AND_CORNER);
      break;
  }
  return options;
}

/// The tags of a cage in the arrays that a descriptor points to.
struct TagArrays {
  std::vector<int> face_sizes, crease_pairs, corner_vertices;
  std::vector<float> crease_weights, corner_weights;

  explicit TagArrays(const Cage& cage) {
    for (Index f = 0; f < cage.face_count(); ++f)
      face_sizes.push_back(static_cast<int>(cage.face(f).size()));
    for (const auto& c : cage.creases) {
      crease_pairs.insert(crease_pairs.end(), c.vertices.begin(), c.vertices.end());
      crease_weights.push_back(static_cast<float>(c.sharpness));
    }
    for (const auto& c : cage.corners) {
      corner_vertices.push_back(c.vertex);
      corner_weights.push_back(static_cast<float>(c.sharpness));
    }
  }
};

std::unique_ptr<Far::TopologyRefiner> refined(const Cage& cage, int levels) {
  const TagArrays tags(cage);
  Far::TopologyDescriptor d;
  d.numVertices = static_cast<int>(cage.vertices.size());
  d.numFaces = cage.face_count();
  d.numVertsPerFace = tags.face_sizes.data();
  d.vertIndicesPerFace = cage.face_corners.data();
  d.numCreases = static_cast<int>(tags.crease_weights.size());
  d.creaseVertexIndexPairs = tags.crease_pairs.data();
  d.creaseWeights = tags.crease_weights.data();
  d.numCorners = static_cast<int>(tags.corner_weights.size());
  d.cornerVertexIndices = tags.corner_vertices.data();
  d.cornerWeights = tags.corner_weights.data();
  d.numHoles = static_cast<int>(cage.holes.size());
  d.holeIndices = cage.holes.data();
  using Factory = Far::TopologyRefinerFactory<Far::TopologyDescriptor>;
  std::unique_ptr<Far::TopologyRefiner> refiner(
      Factory::Create(d, Factory::Options(Sdc::SCHEME_CATMARK, options_of(cage))));
  if (!refiner) throw std::runtime_error("OpenSubdiv refuses the cage " + cage.name);
  Far::TopologyRefiner::UniformOptions uniform(levels);
  uniform.fullTopologyInLastLevel = true;  // the rules at its vertices are asked for
  refiner->RefineUniform(uniform);
  return refiner;
}

using Primvars = std::vector<Primvar>;

/// One step of Far's refinement, from the vertices of `level` − 1 to those of `level`.
Primvars interpolated(const Far::TopologyRefiner& refiner, int level, const Primvars& from) {
  Primvars next(refiner.GetLevel(level).GetNumVertices());
  Primvar* to = next.data();
  Far::PrimvarRefinerReal<double>(refiner).Interpolate(level, from.data(), to);
  return next;
}

/// The quads around an interior vertex as a cage of their own: vertex 0, then the rest. What comes
/// of such a star in one refinement does not depend on anything outside.
Cage star_at(const Far::TopologyLevel& level, const Primvars& at, Index v) {
  std::map<Index, Index> number = {{v, 0}};
  Cage star;
  star.vertices.push_back(at[v].p);
  const auto faces = level.GetVertexFaces(v);
  const auto corner = level.GetVertexFaceLocalIndices(v);
  for (int f = 0; f < faces.size(); ++f) {
    std::vector<Index> face;
    for (int k = 0; k < 4; ++k) {
      const Index w = level.GetFaceVertices(faces[f])[(corner[f] + k) % 4];
      if (number.try_emplace(w, static_cast<Index>(star.vertices.size())).second)
        star.vertices.push_back(at[w].p);
      face.push_back(number.at(w));
    }
    star.add_face(face);
  }
  for (const Index e : level.GetVertexEdges(v)) {
    const auto ends = level.GetEdgeVertices(e);
    if (const float s = level.GetEdgeSharpness(e); s > 0)
      star.creases.push_back({{0, number.at(ends[0] == v ? ends[1] : ends[0])}, s});
  }
  return star;
}

/// The limit of vertex 0 of a star by Far's refinement alone. Its limit mask takes the end of a
/// crease for a smooth vertex and a vertex of valence two for a sharp one, so it is exact at
/// neither.
Vec3 limit_by_refinement(const Cage& star) {
  const auto refiner = refined(star, 1);
  const Far::TopologyLevel& level = refiner->GetLevel(0);
  Primvars at;
  for (const Vec3& p : star.vertices) at.push_back({p});
  for (int step = 0; step < 100; ++step) {  // a star shrinks to 0.6545 at most: below any rounding
    const Primvars next = interpolated(*refiner, 1, at);
    at[0] = next[level.GetVertexChildVertex(0)];
    for (const Index e : level.GetVertexEdges(0)) {
      const auto ends = level.GetEdgeVertices(e);
      at[ends[0] == 0 ? ends[1] : ends[0]] = next[level.GetEdgeChildVertex(e)];
    }
    for (Index f = 0; f < star.face_count(); ++f)
      at[star.face(f)[2]] = next[level.GetFaceChildVertex(f)];
  }
  return at[0].p;
}

bool has_exact_mask(const Far::TopologyLevel& level, Index v) {
  return level.GetVertexRule(v) != Sdc::Crease::RULE_DART &&
         (level.GetVertexEdges(v).size() > 2 || level.IsVertexBoundary(v));
}

struct Limits {
  Primvars positions;
  int without_mask = 0;  ///< how many of them had to be found by further refinement
};

/// Limit positions of the vertices of the last level.
Limits limits_of(const Far::TopologyRefiner& refiner, const Cage& cage) {
  Primvars now;
  for (const Vec3& p : cage.vertices) now.push_back({p});
  for (int level = 1; level <= refiner.GetMaxLevel(); ++level)
    now = interpolated(refiner, level, now);
  Limits limits{Primvars(now.size()), 0};
  Primvar* to = limits.positions.data();
  Far::PrimvarRefinerReal<double>(refiner).Limit(now.data(), to);
  const auto& last = refiner.GetLevel(refiner.GetMaxLevel());
  for (Index v = 0; v < last.GetNumVertices(); ++v) {
    if (has_exact_mask(last, v)) continue;
    limits.positions[v].p = limit_by_refinement(star_at(last, now, v));
    ++limits.without_mask;
  }
  return limits;
}

/// A refined quad: the square [u, u + size] × [v, v + size] of a patch. Corner 0 is its low one.
struct Tile {
  int patch = 0;
  double u = 0, v = 0, size = 1;

  Tile child(int k) const {
    const double half = size / 2;
    return {patch, k == 1 || k == 2 ? u + half : u, k >= 2 ? v + half : v, half};
  }
  double corner_u(int k) const { return k == 1 || k == 2 ? u + size : u; }
  double corner_v(int k) const { return k >= 2 ? v + size : v; }
  /// Each parameter once a patch: the tile above or to the right has it, unless there is none.
  bool owns(int k) const {
    return (corner_u(k) == u || corner_u(k) == 1) && (corner_v(k) == v || corner_v(k) == 1);
  }
};

/// Far's child k of a quad lies at corner k and keeps its orientation; of an n-gon, it begins with
/// corner k.
class FarWalk {
 public:
  FarWalk(const Cage& cage, int levels)
      : refiner_(refined(cage, levels)), limits_(limits_of(*refiner_, cage)) {
    found_.vertices_without_mask = limits_.without_mask;
    const auto& base = refiner_->GetLevel(0);
    int patch = 0;
    for (Index f = 0; f < cage.face_count(); ++f) {
      const bool quad = cage.face(f).size() == 4;
      const int patches = quad ? 1 : static_cast<int>(cage.face(f).size());
      found_.has_surface.insert(found_.has_surface.end(), patches, !base.IsFaceHole(f));
      if (quad && !base.IsFaceHole(f)) descend(0, f, {patch});
      if (!quad && !base.IsFaceHole(f))
        for (int k = 0; k < patches; ++k) descend(1, base.GetFaceChildFaces(f)[k], {patch + k});
      patch += patches;
    }
  }
  const FarSurface& found() const { return found_; }

 private:
  void descend(int level, Index face, const Tile& tile) {
    const auto& at = refiner_->GetLevel(level);
    if (level < refiner_->GetMaxLevel()) {
      const auto children = at.GetFaceChildFaces(face);
      for (int k = 0; k < 4; ++k) descend(level + 1, children[k], tile.child(k));
      return;
    }
    for (int k = 0; k < 4; ++k)
      if (tile.owns(k))
        found_.points.push_back({tile.patch, tile.corner_u(k), tile.corner_v(k),
                                 limits_.positions[at.GetFaceVertices(face)[k]].p});
  }

  std::unique_ptr<Far::TopologyRefiner> refiner_;
  Limits limits_;
  FarSurface found_;
};

}  // namespace

FarSurface far_surface(const Cage& cage, int levels) {
  return FarWalk(cage, levels).found();
}

}  // namespace limitgauge::tests
