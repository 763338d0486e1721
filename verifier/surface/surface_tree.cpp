#include "verifier/surface/surface_tree.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "model/base/chunks.h"
#include "verifier/tolerance.h"

namespace limitgauge::verifier {

using model::Vec3;

namespace {

/// A chunk of the patches that are measured.
constexpr std::size_t kPatchesAtOnce = 16;

/// Which child of a square holds (u, v), and where in it.
int step_into_child(double& u, double& v) {
  const bool right = u >= 0.5, upper = v >= 0.5;
  u = 2 * u - (right ? 1 : 0);
  v = 2 * v - (upper ? 1 : 0);
  return upper ? (right ? 2 : 3) : (right ? 1 : 0);
}

SurfaceSample sample_of(const Bezier& shape, double u, double v, double scale) {
  const BezierJet j = jet(shape, u, v);
  const double second = scale * scale;
  return {j.position,     j.du * scale,   j.dv * scale,  normalized(cross(j.du, j.dv)),
          j.duu * second, j.duv * second, j.dvv * second};
}

}  // namespace

ParameterSquare child_square(const ParameterSquare& s, int k) {
  const double half = s.size / 2;
  return {s.patch, s.u + (k == 1 || k == 2 ? half : 0), s.v + (k >= 2 ? half : 0), half};
}

SurfaceSample SurfaceTree::evaluate(int patch, double u, double v) const {
  const Node* node = &parts_.nodes[parts_.roots[patch]];
  double scale = 1;
  for (; node->kind == Node::Kind::inner; scale *= 2)
    node = &parts_.nodes[node->child[step_into_child(u, v)]];
  switch (node->kind) {
    case Node::Kind::speck:
      return at_speck(parts_.specks[node->index]);
    case Node::Kind::chain:
      return in_chain(parts_.chains[node->index], u, v, scale);
    default:
      return sample_of(parts_.pieces[node->index].shape, u, v, scale);
  }
}

SurfaceSample SurfaceTree::at_speck(const Speck& s) const {
  return {s.position, s.tangent_u, s.tangent_v, s.normal, {}, {}, {}, true, s.plane};
}

SurfaceSample SurfaceTree::in_chain(const PlacedChain& placed, double u, double v,
                                    double scale) const {
  const ChainStep& step = *placed.chain.step;
  // How deep it goes is known before anything is worked out: many ask for the vertex itself.
  int levels = 0, child = step.corner();
  for (; levels < placed.chain.levels && child == step.corner(); ++levels, scale *= 2)
    child = step_into_child(u, v);
  if (child == step.corner()) return at_speck(parts_.specks[placed.speck]);
  std::vector<Vec3> points = step.refined(placed.chain.points);
  for (int level = 1; level < levels; ++level) points = step.refined(step.inner(points));
  return sample_of(step.piece(child, points), u, v, scale);
}

void SurfaceTree::add_pieces(const PlacedChain& placed, std::vector<Piece>& out) {
  const ChainStep& step = *placed.chain.step;
  std::vector<Piece> beyond;  // come after those of the levels within
  std::vector<Vec3> points = placed.chain.points;
  ParameterSquare square = placed.square;
  for (int level = 0; level < placed.chain.levels; ++level) {
    const std::vector<Vec3> refined = step.refined(points);
    for (int k = 0; k < step.corner(); ++k)
      out.push_back({step.piece(k, refined), child_square(square, k)});
    for (int k = 3; k > step.corner(); --k)
      beyond.push_back({step.piece(k, refined), child_square(square, k)});
    points = step.inner(refined);
    square = child_square(square, step.corner());
  }
  out.insert(out.end(), beyond.rbegin(), beyond.rend());
}

void SurfaceTree::add_pieces(std::int32_t at, std::vector<Piece>& out) const {
  const Node& node = parts_.nodes[at];
  if (node.kind == Node::Kind::piece) out.push_back(parts_.pieces[node.index]);
  if (node.kind == Node::Kind::chain) add_pieces(parts_.chains[node.index], out);
  if (node.kind == Node::Kind::inner)
    for (const std::int32_t child : node.child) add_pieces(child, out);
}

std::vector<Piece> SurfaceTree::pieces_of(int patch) const {
  std::vector<Piece> out;
  if (has_surface(patch)) add_pieces(parts_.roots[patch], out);
  return out;
}

std::span<const Speck> SurfaceTree::specks_of(int patch) const {
  const auto patch_of = [](const Speck& s) { return s.square.patch; };
  return {std::ranges::lower_bound(parts_.specks, patch, {}, patch_of),
          std::ranges::upper_bound(parts_.specks, patch, {}, patch_of)};
}

std::vector<Piece> SurfaceTree::pieces_beyond(int patch, double omitted_mm) const {
  std::vector<Piece> pieces = pieces_of(patch);
  const std::span<const Speck> specks = specks_of(patch);
  std::erase_if(pieces, [&](const Piece& piece) {
    return std::any_of(specks.begin(), specks.end(), [&](const Speck& s) {
      return control_radius(piece.shape, s.position) < omitted_mm;
    });
  });
  return pieces;
}

std::size_t SurfaceTree::bent_pieces_about_vertices() const {
  std::size_t count = 0;
  for (const PlacedChain& placed : parts_.chains) {
    const std::size_t valence = placed.chain.step->valence();
    if (valence > 3) count += 3 * static_cast<std::size_t>(placed.chain.levels) * (valence - 3);
  }
  return count;
}

std::size_t SurfaceTree::memory_bytes() const {
  std::size_t bytes = parts_.nodes.capacity() * sizeof(Node) +
                      parts_.pieces.capacity() * sizeof(Piece) +
                      parts_.specks.capacity() * sizeof(Speck);
  for (const PlacedChain& placed : parts_.chains)
    bytes += sizeof(placed) - sizeof(VertexChain) + placed.chain.memory_bytes();
  return bytes;
}

namespace {

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
  void see(const Vec3& p) { best_ = std::max(best_, sign_ * p[axis_]); }
  bool may_be_beyond(const Vec3& p) const {
    return sign_ * p[axis_] > best_ + kExtremeTolerance_mm;
  }

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

model::Box3 exact_bounding_box(const SurfaceTree& tree, const model::RunControl& control) {
  model::Box3 box;
  std::vector<Maximum> sides;
  for (int axis = 0; axis < 3; ++axis)
    for (const double sign : {-1.0, 1.0}) sides.emplace_back(axis, sign);
  const auto see = [&](const model::Box3& of) {
    for (Maximum& side : sides) side.see(of.low), side.see(of.high);
  };
  const auto reaches_beyond = [&](const model::Box3& of) {
    return std::any_of(sides.begin(), sides.end(), [&](const Maximum& side) {
      return side.may_be_beyond(of.low) || side.may_be_beyond(of.high);
    });
  };
  const auto patches = static_cast<std::size_t>(tree.patch_count());
  std::vector<model::Box3> corners(patches), controls(patches);
  model::parallel_chunks(patches, kPatchesAtOnce, control, [&](std::size_t begin, std::size_t end) {
    for (std::size_t patch = begin; patch < end; ++patch)
      for (const Piece& p : tree.pieces_of(static_cast<int>(patch))) {
        for (const int k : {0, 3, 12, 15}) corners[patch].add(p.shape.control(k));
        controls[patch].add(control_box(p.shape));
      }
  });
  // Corners first: a good start makes the search short.
  bool any = false;
  for (const model::Box3& of_patch : corners)
    if (!of_patch.empty()) any = true, see(of_patch);
  if (!any) return box;
  for (const Speck& s : tree.specks()) see({s.position, s.position});
  for (std::size_t patch = 0; patch < patches; ++patch) {
    control.check();
    if (corners[patch].empty() || !reaches_beyond(controls[patch])) continue;
    for (const Piece& p : tree.pieces_of(static_cast<int>(patch)))
      for (Maximum& side : sides) side.search(p.shape);
  }
  for (int axis = 0; axis < 3; ++axis) {
    box.low[axis] = -sides[2 * axis].best();
    box.high[axis] = sides[2 * axis + 1].best();
  }
  return box;
}

double surface_area_mm2(const SurfaceTree& tree, const model::RunControl& control) {
  std::vector<std::vector<double>> areas(static_cast<std::size_t>(tree.patch_count()));
  // Each by itself, and then in their order: the same sum for any number of threads.
  const auto each_patch = [&](const auto& measure) {
    model::parallel_chunks(areas.size(), kPatchesAtOnce, control,
                           [&](std::size_t begin, std::size_t end) {
                             for (std::size_t patch = begin; patch < end; ++patch)
                               measure(tree.pieces_of(static_cast<int>(patch)), areas[patch]);
                           });
    double sum = 0;
    for (const auto& of_patch : areas)
      for (const double area : of_patch) sum += area;
    return sum;
  };
  const double total = each_patch([](const std::vector<Piece>& pieces, std::vector<double>& area) {
    for (const Piece& p : pieces) area.push_back(area_mm2(p.shape));
  });
  return each_patch([&](const std::vector<Piece>& pieces, std::vector<double>& area) {
    for (std::size_t k = 0; k < pieces.size(); ++k)
      if (area[k] > kAreaLost * total)
        area[k] = refined_area(pieces[k].shape, area[k], kAreaStep * total, 0);
  });
}

}  // namespace limitgauge::verifier
