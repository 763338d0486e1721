#include "verifier/surface/surface_tree.h"

#include <algorithm>
#include <map>

namespace limitgauge::verifier {

using model::Vec3;

SurfaceSample SurfaceTree::evaluate(int patch, double u, double v) const {
  const Node* node = &nodes_[roots_[patch]];
  double scale = 1;
  while (node->kind == Node::Kind::inner) {
    const bool right = u >= 0.5, upper = v >= 0.5;
    u = 2 * u - (right ? 1 : 0);
    v = 2 * v - (upper ? 1 : 0);
    scale *= 2;
    node = &nodes_[node->child[upper ? (right ? 2 : 3) : (right ? 1 : 0)]];
  }
  if (node->kind == Node::Kind::speck) {
    const Speck& s = specks_[node->index];
    return {s.position, s.tangent_u, s.tangent_v, s.normal, {}, {}, {}, true, s.plane};
  }
  const BezierJet j = jet(pieces_[node->index].shape, u, v);
  const double second = scale * scale;
  return {j.position,     j.du * scale,   j.dv * scale,  normalized(cross(j.du, j.dv)),
          j.duu * second, j.duv * second, j.dvv * second};
}

std::vector<const Piece*> SurfaceTree::pieces_beyond(double omitted_mm) const {
  std::map<int, std::vector<Vec3>> specks;
  for (const Speck& s : specks_) specks[s.square.patch].push_back(s.position);
  std::vector<const Piece*> beyond;
  for (const Piece& piece : pieces_) {
    const auto near = specks.find(piece.square.patch);
    if (near == specks.end() ||
        std::none_of(near->second.begin(), near->second.end(),
                     [&](const Vec3& p) { return control_radius(piece.shape, p) < omitted_mm; }))
      beyond.push_back(&piece);
  }
  return beyond;
}

}  // namespace limitgauge::verifier
