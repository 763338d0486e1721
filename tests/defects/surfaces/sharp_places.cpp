#include "tests/defects/surfaces/sharp_places.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>

namespace limitgauge::tests::defects {
namespace {

using model::Vec3;

/// Normals that differ by less are those of one tangent plane: in radians.
constexpr double kSamePlane = 1e-7;
/// Parameters this near to a side lie on it.
constexpr double kOnSide = 1e-12;

Place on_side(int patch, int side, double along) {
  switch (side) {
    case 0:
      return {patch, along, 0};
    case 1:
      return {patch, 1, along};
    case 2:
      return {patch, 1 - along, 1};
    default:
      return {patch, 0, 1 - along};
  }
}
Place at_corner(int patch, int corner) {
  return on_side(patch, corner, 0);
}

/// The side that a place lies on and how far along; none inside the patch.
struct OnSide {
  int side = 0;
  double along = 0;
};
std::optional<OnSide> side_of(const Place& p) {
  if (p.v <= kOnSide) return OnSide{0, p.u};
  if (p.u >= 1 - kOnSide) return OnSide{1, p.v};
  if (p.v >= 1 - kOnSide) return OnSide{2, 1 - p.u};
  if (p.u <= kOnSide) return OnSide{3, 1 - p.v};
  return std::nullopt;
}

Vec3 between(const Vec3& a, const Vec3& b, double t) {
  const double angle = std::acos(std::clamp(dot(a, b), -1.0, 1.0)), s = std::sin(angle);
  if (s < 1e-9) return a;
  return normalized(a * (std::sin((1 - t) * angle) / s) + b * (std::sin(t * angle) / s));
}

}  // namespace

SharpPlaces::SharpPlaces(const model::Cage& cage, const SampledSurface& surface)
    : surface_(surface) {
  for (model::Index f = 0; f < cage.face_count(); ++f)
    quads_only_ = quads_only_ && cage.face(f).size() == 4;
  if (!quads_only_) return;
  link(cage);
  sample_edges();
}

void SharpPlaces::link(const model::Cage& cage) {
  around_.resize(cage.vertices.size());
  across_.resize(static_cast<std::size_t>(cage.face_count()));
  std::map<std::pair<model::Index, model::Index>, SideRef> half_edges;
  for (model::Index f = 0; f < cage.face_count(); ++f) {
    const auto face = cage.face(f);
    for (int k = 0; k < 4; ++k) {
      corners_.push_back(face[k]);
      if (!surface_.surface().has_surface(f)) continue;
      around_[face[k]].push_back({f, k});
      half_edges[{face[k], face[(k + 1) % 4]}] = {f, k};
    }
  }
  for (const auto& [ends, ref] : half_edges) {
    const auto other = half_edges.find({ends.second, ends.first});
    if (other != half_edges.end()) across_[ref.patch][ref.side] = other->second;
  }
}

std::vector<Place> SharpPlaces::same_places(const Place& place) const {
  const auto on = quads_only_ ? side_of(place) : std::nullopt;
  if (!on) return {place};
  const bool first = on->along <= kOnSide, last = on->along >= 1 - kOnSide;
  if (first || last) {
    const int corner = first ? on->side : (on->side + 1) % 4;
    std::vector<Place> out;
    for (const CornerRef& c : around_[corners_[static_cast<std::size_t>(place.patch) * 4 + corner]])
      out.push_back(at_corner(c.patch, c.corner));
    return out;
  }
  const SideRef& other = across_[place.patch][on->side];
  if (other.patch < 0) return {place};
  return {place, on_side(other.patch, other.side, 1 - on->along)};
}

std::vector<Place> SharpPlaces::beside(const Place& place) const {
  constexpr double kAtCorner = 1e-5, kAside = 1e-6;
  const auto snapped = [](double p) {
    return std::abs(p - std::round(p)) < kAtCorner ? std::round(p) : p;
  };
  const Place corner{place.patch, snapped(place.u), snapped(place.v)};
  std::vector<Place> out = {place};
  if (corner.u != std::round(corner.u) || corner.v != std::round(corner.v)) return out;
  for (const Place& p : same_places(corner))
    for (const auto& [u, v] : {std::pair{0.0, 0.0}, {kAside, 0.0}, {0.0, kAside}, {kAside, kAside}})
      out.push_back({p.patch, std::abs(p.u - u), std::abs(p.v - v)});
  return out;
}

/// True where no face rises over the tangent plane of another: the material is convex there, as far
/// as the tangent planes tell.
bool SharpPlaces::convex_between(const std::vector<Place>& places) const {
  constexpr double kInto = 1e-3, kLevel = 1e-6;
  for (const Place& a : places) {
    const auto at = surface_.at(a);
    for (const Place& b : places)
      for (const auto& [u, v] :
           {std::pair{0.5, 0.5}, {0.1, 0.5}, {0.9, 0.5}, {0.5, 0.1}, {0.5, 0.9}}) {
        const Place inner{b.patch, b.u + (u - b.u) * kInto, b.v + (v - b.v) * kInto};
        const Vec3 way = surface_.at(inner).position - at.position;
        if (length(way) == 0) continue;
        const double bend = length(way);  // the surface's own curvature, of second order
        if (dot(at.normal, normalized(way)) > kLevel + bend) return false;
      }
  }
  return true;
}

SharpPlaces::Span SharpPlaces::span_at(const Place& place) const {
  Span out;
  const std::vector<Place> places = same_places(place);
  for (const Place& p : places) {
    const Vec3 n = surface_.at(p).normal;
    const bool known = std::any_of(out.faces.begin(), out.faces.end(),
                                   [&](const Vec3& o) { return distance(o, n) < kSamePlane; });
    if (!known) out.faces.push_back(n);
  }
  if (out.faces.size() > 1) out.convex = convex_between(places);
  return out;
}

std::vector<Vec3> SharpPlaces::fan(const Place& place, int count) const {
  const Span span = span_at(place);
  std::vector<Vec3> out = span.faces;
  if (span.faces.size() < 2 || !span.convex) return out;
  // All arcs between two faces' normals, and between each arc and a third.
  const std::size_t n = span.faces.size();
  for (std::size_t a = 0; a < n; ++a)
    for (std::size_t b = a + 1; b < n; ++b)
      for (int k = 1; k < count; ++k) {
        const Vec3 on_arc = between(span.faces[a], span.faces[b], static_cast<double>(k) / count);
        out.push_back(on_arc);
        for (std::size_t c = b + 1; c < n; ++c)
          for (int m = 1; m < count; ++m)
            out.push_back(between(on_arc, span.faces[c], static_cast<double>(m) / count));
      }
  return out;
}

void SharpPlaces::sample_edges() {
  for (const SampledSurface::Grid& grid : surface_.grids())
    for (int side = 0; side < 4; ++side) {
      const SideRef& other = across_[grid.patch][side];
      // Each edge once; its ends belong to the edges around them as well, which does no harm.
      if (other.patch < grid.patch) continue;
      for (int k = 0; k <= grid.steps; ++k) {
        const Place place = on_side(grid.patch, side, static_cast<double>(k) / grid.steps);
        if (span_at(place).faces.size() > 1) samples_.push_back(place);
      }
    }
}

}  // namespace limitgauge::tests::defects
