#include "verifier/surface/sector.h"

#include <algorithm>
#include <optional>

namespace limitgauge::verifier {

using model::Index;
using model::Vec3;

namespace {

template <class Fits>
std::optional<Star::Wedge> wedge_with(const Star& star, Fits&& fits) {
  const auto at = std::find_if(star.wedges.begin(), star.wedges.end(), fits);
  return at == star.wedges.end() ? std::nullopt : std::optional(*at);
}

/// Clockwise from face 0 up to a sharp edge, or once around.
Star::Wedge first_wedge(const Neighbourhood& n, const Star& star, int k) {
  Star::Wedge first{0, k};
  while (n.sharpness_after(first.face, first.corner) <= 0) {
    const Index edge = n.next(first.face, first.corner);
    const auto before =
        wedge_with(star, [&](const Star::Wedge& w) { return n.prev(w.face, w.corner) == edge; });
    if (!before || before->face == 0) break;
    first = *before;
  }
  return first;
}

}  // namespace

Sector sector_of(const Neighbourhood& n, const Star& star, int k) {
  const Star::Wedge first = first_wedge(n, star, k);
  Sector s;
  s.vertex = n.corner(0, k);
  s.full_turn = n.sharpness_after(first.face, first.corner) <= 0;
  for (std::optional<Star::Wedge> w = first; w;) {
    if (w->face == 0) s.own = s.faces();
    s.edge.push_back(n.next(w->face, w->corner));
    s.face.push_back(n.corner(w->face, (w->corner + 2) % 4));
    const Index edge = n.prev(w->face, w->corner);
    const bool end = n.sharpness_before(w->face, w->corner) > 0;
    if (end) s.edge.push_back(edge);
    const auto after = end ? std::nullopt : wedge_with(star, [&](const Star::Wedge& c) {
      return n.next(c.face, c.corner) == edge;
    });
    w = after && after->face != first.face ? after : std::nullopt;
  }
  return s;
}

Vec3 weighted_sum(const Neighbourhood& n, const Sector& s, const RingWeights& w) {
  Vec3 sum = n.points[s.vertex] * w.vertex;
  for (std::size_t i = 0; i < w.edge.size(); ++i) sum += n.points[s.edge[i]] * w.edge[i];
  for (std::size_t i = 0; i < w.face.size(); ++i) sum += n.points[s.face[i]] * w.face[i];
  return sum;
}

}  // namespace limitgauge::verifier
