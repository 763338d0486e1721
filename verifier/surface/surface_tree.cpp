#include "verifier/surface/surface_tree.h"
#include "verifier/tolerance.h"

#include <algorithm>
#include <map>
#include <vector>

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

namespace {

using model::Vec3;
using Values = std::array<double, 16>;

double largest(const Values& c) {
  return *std::max_element(c.begin(), c.end());
}
double corner_max(const Values& c) {
  return std::max({c[0], c[3], c[12], c[15]});
}

/// Greatest value of one coordinate, times `sign`, over all pieces.
class Maximum {
 public:
  Maximum(int axis, double sign) : axis_(axis), sign_(sign) {}

  double best() const { return best_; }
  void see(double value) { best_ = std::max(best_, sign_ * value); }

  void search(const Bezier& b, int depth = 0) {
    Values c = axis_ == 0 ? b.x : axis_ == 1 ? b.y : b.z;
    for (double& value : c) value *= sign_;
    best_ = std::max(best_, corner_max(c));
    if (largest(c) <= best_ + kExtremeTolerance_mm || depth > 80) return;
    const auto halves = depth % 2 == 0 ? split_u(b) : split_v(b);
    for (const Bezier& half : halves) search(half, depth + 1);
  }

 private:
  int axis_;
  double sign_;
  double best_ = -std::numeric_limits<double>::infinity();
};

double extreme(const SurfaceTree& tree, int axis, double sign) {
  Maximum maximum(axis, sign);
  // Corners first: a good start makes the search short.
  for (const Piece& p : tree.pieces())
    for (const int k : {0, 3, 12, 15}) maximum.see(p.shape.control(k)[axis]);
  for (const Speck& s : tree.specks()) maximum.see(s.position[axis]);
  for (const Piece& p : tree.pieces()) maximum.search(p.shape);
  return sign * maximum.best();
}

double refined_area(const Bezier& b, double whole, double tolerance_mm2, int depth) {
  std::array<Bezier, 4> part;
  const auto [left, right] = split_u(b);
  const auto [l0, l1] = split_v(left);
  const auto [r0, r1] = split_v(right);
  part = {l0, l1, r0, r1};
  std::array<double, 4> areas{};
  double sum = 0;
  for (int k = 0; k < 4; ++k) sum += areas[k] = area_mm2(part[k]);
  if (std::abs(sum - whole) <= tolerance_mm2 || depth > 12) return sum;
  sum = 0;
  for (int k = 0; k < 4; ++k) sum += refined_area(part[k], areas[k], tolerance_mm2, depth + 1);
  return sum;
}

}  // namespace

model::Box3 exact_bounding_box(const SurfaceTree& tree) {
  model::Box3 box;
  if (tree.pieces().empty()) return box;
  for (int axis = 0; axis < 3; ++axis) {
    box.low[axis] = extreme(tree, axis, -1);
    box.high[axis] = extreme(tree, axis, 1);
  }
  return box;
}

double surface_area_mm2(const SurfaceTree& tree) {
  std::vector<double> rough;
  double total = 0;
  for (const Piece& p : tree.pieces()) total += rough.emplace_back(area_mm2(p.shape));
  double sum = 0;
  for (std::size_t k = 0; k < rough.size(); ++k)
    sum += refined_area(tree.pieces()[k].shape, rough[k], kAreaStep * total, 0);
  return sum;
}

}  // namespace limitgauge::verifier
