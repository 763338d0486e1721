#include <algorithm>
#include <optional>
#include <stdexcept>

#include "verifier/surface/neighbourhood.h"
#include "verifier/surface/regular_piece.h"
#include "verifier/surface/surface_tree.h"
#include "verifier/surface/vertex_limit.h"
#include "verifier/tolerance.h"

namespace limitgauge::verifier {

using model::Index;
using model::Vec3;

namespace {

/// Bound on refinement: the slowest shrinking neighbourhood (valence 50, factor 0.654) is below
/// 1e-17 of its size by then; sharpness below ten is used up in the first ten levels.
constexpr int kDeepest = 110;
/// Where the masks give no plane, because the cage is folded flat at the vertex, it is read off the
/// surface this many refinements closer.
constexpr int kTangentSteps = 24;

ParameterSquare child_square(const ParameterSquare& s, int k) {
  const double half = s.size / 2;
  return {s.patch, s.u + (k == 1 || k == 2 ? half : 0), s.v + (k >= 2 ? half : 0), half};
}

double spread(const Neighbourhood& n) {
  model::Box3 box;
  for (const Vec3& p : n.points) box.add(p);
  return length(box.size());
}

/// What is known of the one irregular corner that a chain of ever smaller squares closes in on.
struct Approach {
  int steps = 0;  ///< refinements since it became the only irregular corner
  std::optional<VertexLimit::Tangents> tangents;
};

bool semi_sharp(double s) {
  return s > 0 && s < model::kInfiniteSharpness;
}

bool has_semi_sharp(const Neighbourhood& n, int k) {
  const Star star = star_of(n, n.corner(0, k));
  return semi_sharp(n.vertex_sharpness[n.corner(0, k)]) ||
         std::any_of(star.spokes.begin(), star.spokes.end(),
                     [](const Star::Spoke& s) { return semi_sharp(s.sharpness); });
}

/// The corner to close in on: the only irregular one, free of sharpness that is still to be used
/// up.
std::optional<int> lone_corner(const Neighbourhood& n) {
  std::optional<int> found;
  for (int f = 0; f < n.face_count(); ++f)
    if (n.size_of(f) != 4) return std::nullopt;
  for (int k = 0; k < 4; ++k) {
    if (!is_irregular_corner(n, k)) continue;
    if (found || has_semi_sharp(n, k)) return std::nullopt;
    found = k;
  }
  return found;
}

/// The tangent plane from the regular piece diagonally across, at its point nearest to corner `k`.
std::optional<VertexLimit::Tangents> tangents_nearby(const Neighbourhood& across, int k) {
  const auto piece = regular_piece(across);
  if (!piece) return std::nullopt;
  const BezierJet j = jet(*piece, k == 1 || k == 2 ? 1 : 0, k >= 2 ? 1 : 0);
  return VertexLimit::Tangents{j.du, j.dv, TangentPlane::none};
}

}  // namespace

/// Fills a SurfaceTree, patch by patch.
class SurfaceTreeBuilder {
 public:
  SurfaceTreeBuilder(SurfaceTree& tree, double model_size) : tree_(tree), model_size_(model_size) {}

  void add_patch(const Neighbourhood& n) {
    const ParameterSquare whole{static_cast<int>(tree_.roots_.size()), 0, 0, 1};
    const std::int32_t root = build(n, whole, 0, {});
    tree_.roots_.push_back(root);
  }
  void add_hole() { tree_.roots_.push_back(-1); }

 private:
  std::int32_t build(const Neighbourhood& n, const ParameterSquare& square, int depth,
                     Approach approach) {
    if (const auto shape = regular_piece(n)) {
      tree_.pieces_.push_back({*shape, square});
      return add(SurfaceTree::Node::Kind::piece, tree_.pieces_.size() - 1);
    }
    const auto corner = lone_corner(n);
    if (corner && (depth >= kDeepest || spread(n) <= kSmallestPiece * model_size_))
      return add_speck(n, *corner, square, approach);
    // Tangents come from the largest neighbourhood that gives them: the direction is the same at
    // every level, and differences of tiny neighbourhoods lose digits.
    if (corner && approach.steps == 0) approach.tangents = vertex_limit(n, *corner).tangents;
    const std::vector<Neighbourhood> children = refine(n);
    if (corner && approach.steps == kTangentSteps && !approach.tangents)
      approach.tangents = tangents_nearby(children[(*corner + 2) & 3], *corner);
    if (corner) ++approach.steps;
    const std::int32_t here = add(SurfaceTree::Node::Kind::inner, 0);
    for (int k = 0; k < 4; ++k) {
      const std::int32_t child = build(children[k], child_square(square, k), depth + 1,
                                       corner == k ? approach : Approach{});
      tree_.nodes_[here].child[k] = child;
    }
    return here;
  }

  std::int32_t add(SurfaceTree::Node::Kind kind, std::size_t index) {
    tree_.nodes_.push_back({kind, {}, static_cast<std::int32_t>(index)});
    return static_cast<std::int32_t>(tree_.nodes_.size()) - 1;
  }

  std::int32_t add_speck(const Neighbourhood& n, int corner, const ParameterSquare& square,
                         const Approach& approach) {
    Speck speck;
    speck.position = vertex_limit(n, corner).position;
    speck.square = square;
    if (const auto& t = approach.tangents) {
      speck.tangent_u = t->first, speck.tangent_v = t->second;
      speck.normal = normalized(cross(t->first, t->second));
      speck.plane = t->plane;
    }
    tree_.specks_.push_back(speck);
    return add(SurfaceTree::Node::Kind::speck, tree_.specks_.size() - 1);
  }

  SurfaceTree& tree_;
  double model_size_;
};

SurfaceTree::SurfaceTree(const model::Cage& cage) {
  const auto defects = model::find_defects(cage);
  if (!defects.empty()) throw std::invalid_argument(model::describe(defects.front()));
  model::Box3 box;
  for (const Vec3& p : cage.vertices) box.add(p);
  SurfaceTreeBuilder builder(*this, length(box.size()));
  const CageNeighbourhoods neighbourhoods(cage);
  for (Index f = 0; f < cage.face_count(); ++f) {
    const std::size_t corners = cage.face(f).size();
    const std::size_t patches = corners == 4 ? 1 : corners;
    if (!neighbourhoods.has_surface(f)) {
      for (std::size_t k = 0; k < patches; ++k) builder.add_hole();
    } else if (corners == 4) {
      builder.add_patch(neighbourhoods.of(f));
    } else {
      for (const Neighbourhood& n : refine(neighbourhoods.of(f))) builder.add_patch(n);
    }
  }
  features_ = SurfaceFeatures(cage);
  sharp_lines_ = SharpLines(cage);
  bounding_box_ = exact_bounding_box(*this);
  area_mm2_ = surface_area_mm2(*this);
}

}  // namespace limitgauge::verifier
