#include "witness/star_limit.h"

#include <array>
#include <map>

namespace limitgauge::witness {
namespace {

using model::Cage;
using model::Index;
using model::Vec3;

/// The quads around a vertex as a cage of their own: vertex 0, the ends of its edges in their
/// order, then the faces' opposite corners. Beside a vertex of valence two, two faces have one
/// opposite corner; here each has its own.
Cage star_at(const Far::TopologyLevel& level, const Primvars& at, Index v) {
  Cage star;
  star.name = "star";
  star.vertices.push_back(at[v].p);
  std::map<Index, Index> end_of;  // by edge
  for (const Index e : level.GetVertexEdges(v)) {
    const auto ends = level.GetEdgeVertices(e);
    const auto end = static_cast<Index>(star.vertices.size());
    end_of[e] = end;
    star.vertices.push_back(at[ends[0] == v ? ends[1] : ends[0]].p);
    if (const float s = level.GetEdgeSharpness(e); s > 0) star.creases.push_back({{0, end}, s});
  }
  const auto faces = level.GetVertexFaces(v);
  const auto corner = level.GetVertexFaceLocalIndices(v);
  for (int f = 0; f < faces.size(); ++f) {
    const auto edges = level.GetFaceEdges(faces[f]);
    const auto opposite = static_cast<Index>(star.vertices.size());
    star.vertices.push_back(at[level.GetFaceVertices(faces[f])[(corner[f] + 2) % 4]].p);
    star.add_face(std::array<Index, 4>{0, end_of.at(edges[corner[f]]), opposite,
                                       end_of.at(edges[(corner[f] + 3) % 4])});
  }
  if (const float s = level.GetVertexSharpness(v); s > 0) star.corners.push_back({0, s});
  return star;
}

Index other_end(const Far::TopologyLevel& level, Index edge) {
  const auto ends = level.GetEdgeVertices(edge);
  return ends[0] == 0 ? ends[1] : ends[0];
}

/// The star of the same vertex one refinement on, by `far` of one level: the same faces, smaller.
Primvars next_positions(const FarRefinement& far, const Cage& star, const Primvars& at) {
  const Far::TopologyLevel& level = far.level(0);
  const Primvars refined = far.refined(at);
  Primvars next(at.size());
  next[0] = refined[level.GetVertexChildVertex(0)];
  for (const Index e : level.GetVertexEdges(0))
    next[other_end(level, e)] = refined[level.GetEdgeChildVertex(e)];
  for (Index f = 0; f < star.face_count(); ++f)
    next[star.face(f)[2]] = refined[level.GetFaceChildVertex(f)];
  return next;
}

/// Sharpness as Far has it one refinement on.
void take_sharpness(const FarRefinement& far, Cage& star) {
  const Far::TopologyLevel &now = far.level(0), &then = far.level(1);
  const Index vertex = now.GetVertexChildVertex(0);
  star.creases.clear();
  star.corners.clear();
  for (const Index e : now.GetVertexEdges(0)) {
    const Index child = then.FindEdge(vertex, now.GetEdgeChildVertex(e));
    if (const float s = then.GetEdgeSharpness(child); s > 0)
      star.creases.push_back({{0, other_end(now, e)}, s});
  }
  if (const float s = then.GetVertexSharpness(vertex); s > 0) star.corners.push_back({0, s});
}

Vec3 limit_by_mask(const FarRefinement& far, const Primvars& at, Index vertex) {
  const Primvars last = far.refined(at);
  Primvars limits(last.size());
  Primvar* to = limits.data();
  Far::PrimvarRefinerReal<double>(far.refiner()).Limit(last.data(), to);
  return limits[vertex].p;
}

}  // namespace

Vec3 star_limit(const FarRefinement& whole, const Primvars& positions, Index v) {
  Cage star = star_at(whole.last(), positions, v);
  Primvars at = control_points(star);
  FarRefinement far(star, 1);
  while (is_semi_sharp(far.level(0), 0)) {  // a sharpness is below 10 and falls by one
    at = next_positions(far, star, at);
    take_sharpness(far, star);
    far = FarRefinement(star, 1);
  }
  const Index child = far.level(0).GetVertexChildVertex(0);
  if (has_exact_mask(far.last(), child)) return limit_by_mask(far, at, child);
  for (int step = 0; step < kStarSteps; ++step) at = next_positions(far, star, at);
  return at[0].p;
}

}  // namespace limitgauge::witness
