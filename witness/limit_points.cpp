#include "witness/limit_points.h"

#include <algorithm>
#include <cmath>

#include "witness/far_refinement.h"
#include "witness/star_limit.h"

namespace limitgauge::witness {
namespace {

using model::Cage;
using model::Index;
using model::Vec3;

/// A tangent, and the sum of its weights' sizes: so far it moves at most if the points move by one.
struct Tangent {
  Vec3 t;
  double weights = 0;
  void Clear() { *this = {}; }
  void AddWithWeight(const Primvar& point, double weight) {
    t += point.p * weight;
    weights += std::abs(weight);
  }
};
using Tangents = std::vector<Tangent>;

/// Far's tangents span the tangent plane at smooth interior vertices, on a boundary or a corner of
/// it where it is regular. Beside a crease they are those of one of its sides; at boundary vertices
/// of three and more faces they belong to rules of their own (Biermann, Levin and Zorin 2000), at
/// corners of more faces to the first of them.
bool has_exact_tangents(const Far::TopologyLevel& level, Index v) {
  if (!has_exact_mask(level, v)) return false;
  const auto rule = level.GetVertexRule(v);
  const int faces = level.GetVertexFaces(v).size();
  if (!level.IsVertexBoundary(v)) return rule == Sdc::Crease::RULE_SMOOTH;
  return faces == 1 || (faces == 2 && rule == Sdc::Crease::RULE_CREASE);
}

/// None where the tangents are parallel.
std::optional<LimitNormal> normal_of(const Tangent& a, const Tangent& b) {
  const Vec3 across = cross(a.t, b.t);
  const double area = length(across);
  if (!(area > 0)) return std::nullopt;
  return LimitNormal{across / area, (a.weights * length(b.t) + b.weights * length(a.t)) / area};
}

/// Everything at the vertices of the last level.
struct VertexLimits {
  Primvars positions;
  std::vector<std::optional<LimitNormal>> normals;
  enum class How : unsigned char { mask, refinement, left_out };
  std::vector<How> how;
};

void refine_stars(const FarRefinement& far, const Primvars& at, std::size_t most,
                  VertexLimits& limits) {
  std::vector<Index> stars;
  for (Index v = 0; v < far.last().GetNumVertices(); ++v) {
    const bool of_a_face = far.last().GetVertexFaces(v).size() > 0;
    if (of_a_face && !has_exact_mask(far.last(), v)) stars.push_back(v);
  }
  if (stars.empty()) return;
  const std::size_t stride = 1 + (stars.size() - 1) / std::max<std::size_t>(most, 1);
  for (std::size_t i = 0; i < stars.size(); ++i) {
    const Index v = stars[i];
    limits.how[v] = VertexLimits::How::left_out;
    if (most == 0 || i % stride != 0) continue;
    limits.how[v] = VertexLimits::How::refinement;
    limits.positions[v].p = star_limit(far, at, v);
  }
}

VertexLimits limits_of(const FarRefinement& far, const Primvars& at, std::size_t most_refined) {
  const std::size_t count = at.size();
  VertexLimits limits{Primvars(count), {}, {}};
  limits.normals.resize(count);
  limits.how.assign(count, VertexLimits::How::mask);
  Tangents first(count), second(count);
  Primvar* to = limits.positions.data();
  Tangent *to_first = first.data(), *to_second = second.data();
  Far::PrimvarRefinerReal<double>(far.refiner()).Limit(at.data(), to, to_first, to_second);
  for (std::size_t v = 0; v < count; ++v)
    if (has_exact_tangents(far.last(), static_cast<Index>(v)))
      limits.normals[v] = normal_of(first[v], second[v]);
  refine_stars(far, at, most_refined, limits);
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
  FarWalk(const Cage& cage, const FarRefinement& far, const VertexLimits& limits)
      : far_(far), limits_(limits) {
    const auto& base = far.level(0);
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
  LimitPoints take() { return std::move(found_); }

 private:
  void descend(int level, Index face, const Tile& tile) {
    const auto& at = far_.level(level);
    if (level < far_.levels()) {
      const auto children = at.GetFaceChildFaces(face);
      for (int k = 0; k < 4; ++k) descend(level + 1, children[k], tile.child(k));
      return;
    }
    for (int k = 0; k < 4; ++k)
      if (tile.owns(k)) add(tile, k, at.GetFaceVertices(face)[k]);
  }

  void add(const Tile& tile, int k, Index vertex) {
    const auto how = limits_.how[vertex];
    if (how == VertexLimits::How::left_out) {
      ++found_.left_out;
      return;
    }
    found_.points.push_back({tile.patch, tile.corner_u(k), tile.corner_v(k),
                             limits_.positions[vertex].p, how == VertexLimits::How::mask,
                             limits_.normals[vertex]});
  }

  const FarRefinement& far_;
  const VertexLimits& limits_;
  LimitPoints found_;
};

}  // namespace

LimitPoints limit_points(const Cage& cage, const PointOptions& options) {
  const FarRefinement far(cage, options.levels);
  const Primvars at = far.refined(control_points(cage));
  const VertexLimits limits = limits_of(far, at, options.most_refined);
  return FarWalk(cage, far, limits).take();
}

}  // namespace limitgauge::witness
