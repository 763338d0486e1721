#include "verifier/surface/vertex_limit.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "verifier/surface/ring_modes.h"
#include "verifier/tolerance.h"

namespace limitgauge::verifier {
namespace {

using model::Vec3;
using std::numbers::pi;
using Tangents = VertexLimit::Tangents;

bool spans_a_plane(const Tangents& t) {
  return length(cross(t.first, t.second)) > kParallel * length(t.first) * length(t.second);
}

/// One corner of face 0 and its sector.
class VertexSide {
 public:
  VertexSide(const Neighbourhood& n, const Star& star, int k)
      : n_(n), k_(k), sector_(sector_of(n, star, k)), faces_(sector_.faces()) {}

  VertexLimit smooth() const;
  VertexLimit dart() const;
  VertexLimit crease(const Vec3& end0, const Vec3& end1) const;
  VertexLimit corner() const;

 private:
  Vec3 vertex() const { return n_.points[sector_.vertex]; }
  Vec3 edge(int i) const { return n_.points[sector_.edge[i]]; }
  Vec3 face(int i) const { return n_.points[sector_.face[i]]; }
  Vec3 sum(const RingWeights& w) const { return weighted_sum(n_, sector_, w); }
  Tangents first_two_waves(RingWeights (*wave)(int, int)) const {
    return {sum(wave(faces_, 2)), sum(wave(faces_, 1)), TangentPlane::off_creases};
  }
  Tangents spike() const;
  Tangents turning() const;
  std::optional<Tangents> corner_tangents() const;

  const Neighbourhood& n_;
  int k_;
  Sector sector_;
  int faces_;
};

VertexLimit VertexSide::smooth() const {
  const double n = faces_;
  Vec3 edges, faces;
  for (int i = 0; i < faces_; ++i) edges += edge(i), faces += face(i);
  const Vec3 position = (vertex() * (n * n) + edges * 4 + faces) / (n * (n + 5));
  if (faces_ == 2)
    return {position, Tangents{edge(0) - edge(1), face(0) - face(1), TangentPlane::none}};
  return {position, Tangents{sum(full_wave(faces_, 0)), sum(full_wave(faces_, n / 4))}};
}

VertexLimit VertexSide::dart() const {
  const DartModes modes = dart_modes(faces_);
  const Vec3 along = sum(modes.along), position = sum(modes.limit);
  if (faces_ == 2) return {position, Tangents{along, face(0) - face(1), TangentPlane::none}};
  return {position, Tangents{along, sum(full_wave(faces_, faces_ / 4.0))}};
}

VertexLimit VertexSide::crease(const Vec3& end0, const Vec3& end1) const {
  VertexLimit limit{(vertex() * 4 + end0 + end1) / 6, std::nullopt};
  const Vec3 along = edge(0) - edge(faces_);
  if (faces_ == 1)
    limit.tangents = Tangents{along, edge(0) + edge(1) - vertex() * 2};
  else if (faces_ <= 4)
    limit.tangents = Tangents{along, sum(crease_wave(faces_, 1))};
  else
    limit.tangents = first_two_waves(crease_wave);
  return limit;
}

/// The direction in which the point shrinks least comes first; it is the radius of every face, and
/// the wave that is antisymmetric about the face's diagonal its other direction. A flat spike is a
/// plane.
Tangents VertexSide::spike() const {
  const double middle = sector_.own + 0.5;
  const Vec3 radius = sum(full_lift(faces_));
  const bool two = faces_ == 2;
  const Vec3 across = two ? edge(1 - sector_.own) - edge(sector_.own)
                          : sum(full_wave(faces_, middle + faces_ / 4.0));
  const Tangents t{radius, across, TangentPlane::none};
  if (spans_a_plane(t) || two) return t;
  return {sum(full_wave(faces_, middle)), across, TangentPlane::everywhere};
}

/// Where the first wave (λ > 1/2) is followed by two directions with λ = 1/2. Their functions of
/// the parameters are x and y of a regular grid that is laid around the vertex from the first edge
/// on, a quarter turn a face.
Tangents VertexSide::turning() const {
  const double lambda = ring_eigenvalue(std::cos(pi / faces_));
  RingWeights values;
  for (int i = 0; i <= faces_; ++i)
    values.edge.push_back(i % faces_ == 0 ? 0 : std::sin(pi * i / faces_));
  for (int i = 0; i < faces_; ++i)
    values.face.push_back((values.edge[i] + values.edge[i + 1]) / (4 * lambda - 1));
  const Slopes f = diagonal_slopes(n_, k_, sector_, values, lambda);
  const Vec3 x = edge(0) - vertex();
  // In a slit of four faces y is the second wave; its weights times its values are 3.
  const Vec3 y = faces_ == 3 ? vertex() - edge(3) : sum(corner_wave(4, 2)) / 3;
  // f_next·(x, y)_prev − f_prev·(x, y)_next; (next, prev) is (x, y) turned by `own` quarters.
  const std::array<Vec3, 4> by_turn = {y * f.next - x * f.prev, -x * f.next - y * f.prev,
                                       x * f.prev - y * f.next, x * f.next + y * f.prev};
  return {sum(corner_wave(faces_, 1)), by_turn[sector_.own], TangentPlane::none};
}

std::optional<Tangents> VertexSide::corner_tangents() const {
  if (sector_.full_turn) return spike();
  const Vec3 first = edge(0) - vertex(), last = edge(faces_) - vertex();
  if (faces_ <= 2) return Tangents{first, last};
  const bool slit = sector_.slit();
  if (faces_ == 4 && !slit)
    return Tangents{first - last, sum(corner_wave(4, 1)), TangentPlane::off_creases};
  if (faces_ >= 5) return first_two_waves(corner_wave);
  const Tangents t = turning();
  if (spans_a_plane(t) || faces_ != 3) return t;
  return Tangents{sum(corner_wave(3, 2)), t.first, TangentPlane::none};
}

VertexLimit VertexSide::corner() const {
  return {vertex(), corner_tangents()};
}

}  // namespace

VertexLimit vertex_limit(const Neighbourhood& n, int k) {
  const Star star = star_of(n, n.corner(0, k));
  std::vector<Vec3> sharp_ends;
  for (const Star::Spoke& s : star.spokes)
    if (s.sharpness > 0) sharp_ends.push_back(n.points[s.end]);
  const VertexSide side(n, star, k);
  VertexLimit limit = n.vertex_sharpness[n.corner(0, k)] > 0 || sharp_ends.size() > 2
                          ? side.corner()
                      : sharp_ends.size() == 2 ? side.crease(sharp_ends[0], sharp_ends[1])
                      : sharp_ends.size() == 1 ? side.dart()
                                               : side.smooth();
  if (limit.tangents && !spans_a_plane(*limit.tangents)) limit.tangents.reset();
  return limit;
}

}  // namespace limitgauge::verifier
