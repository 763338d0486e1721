#include <algorithm>
#include <atomic>
#include <map>
#include <optional>
#include <stdexcept>
#include <tuple>

#include "model/base/chunks.h"
#include "model/part/target_mesh.h"
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

/// Patches that are built one after the other: chains among them share their steps.
constexpr std::size_t kFacesAtOnce = 64;
/// Of the time: the rest goes into the box and the area.
constexpr double kBuiltShare = 0.3, kBoxShare = 0.6;

double spread(std::span<const Vec3> points) {
  model::Box3 box;
  for (const Vec3& p : points) box.add(p);
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
std::optional<VertexLimit::Tangents> tangents_nearby(const std::optional<Bezier>& piece, int k) {
  if (!piece) return std::nullopt;
  const BezierJet j = jet(*piece, k == 1 || k == 2 ? 1 : 0, k >= 2 ? 1 : 0);
  return VertexLimit::Tangents{j.du, j.dv, TangentPlane::none};
}

}  // namespace

namespace {

/// Of a triangle, the quad at each corner: the corner at (0, 0), then round by the middle of the
/// edge ahead, the centroid and the middle of the edge behind.
std::array<Bezier, 3> corner_quads(const std::array<Vec3, 3>& p) {
  const Vec3 centroid = (p[0] + p[1] + p[2]) / 3;
  std::array<Bezier, 3> out;
  for (int k = 0; k < 3; ++k) {
    const Vec3 ahead = (p[k] + p[(k + 1) % 3]) / 2, behind = (p[(k + 2) % 3] + p[k]) / 2;
    for (int j = 0; j < 4; ++j)
      for (int i = 0; i < 4; ++i) {
        const double u = i / 3.0, v = j / 3.0;
        out[k].set(4 * j + i,
                   (p[k] * (1 - u) + ahead * u) * (1 - v) + (behind * (1 - u) + centroid * u) * v);
      }
  }
  return out;
}

}  // namespace

/// Builds the trees of patches that follow each other.
class SurfaceTreeBuilder {
 public:
  using Parts = SurfaceTree::Parts;
  using Node = SurfaceTree::Node;
  explicit SurfaceTreeBuilder(double model_size) : model_size_(model_size) {}

  /// The square's patch is counted from the first one of the parts.
  void add_patch(const Neighbourhood& n) {
    const ParameterSquare whole{static_cast<int>(parts_.roots.size()), 0, 0, 1};
    const std::int32_t root = build(n, whole, 0, {});
    parts_.roots.push_back(root);
  }
  void add_hole() { parts_.roots.push_back(-1); }
  void add_face(const CageNeighbourhoods& neighbourhoods, Index f, std::size_t corners);
  Parts take() { return std::move(parts_); }

 private:
  std::int32_t build(const Neighbourhood& n, const ParameterSquare& square, int depth,
                     Approach approach) {
    if (const auto shape = regular_piece(n)) {
      parts_.pieces.push_back({*shape, square});
      return add(Node::Kind::piece, parts_.pieces.size() - 1);
    }
    const auto corner = lone_corner(n);
    if (corner && ends(n.points, depth)) return add_speck(n, *corner, square, approach);
    // Tangents come from the largest neighbourhood that gives them: the direction is the same at
    // every level, and differences of tiny neighbourhoods lose digits.
    if (corner && approach.steps == 0) approach.tangents = vertex_limit(n, *corner).tangents;
    if (corner)
      if (auto step = step_of(n, *corner))
        return add_chain(n, std::move(step), square, depth, approach);
    const std::vector<Neighbourhood> children = refine(n);
    if (corner && approach.steps == kTangentSteps && !approach.tangents)
      approach.tangents = tangents_nearby(regular_piece(children[(*corner + 2) & 3]), *corner);
    if (corner) ++approach.steps;
    const std::int32_t here = add(Node::Kind::inner, 0);
    for (int k = 0; k < 4; ++k) {
      const std::int32_t child = build(children[k], child_square(square, k), depth + 1,
                                       corner == k ? approach : Approach{});
      parts_.nodes[here].child[k] = child;
    }
    return here;
  }

  bool ends(std::span<const Vec3> points, int depth) const {
    return depth >= kDeepest || spread(points) <= kSmallestPiece * model_size_;
  }

  /// The same for all neighbourhoods with the same faces and sharpness.
  std::shared_ptr<const ChainStep> step_of(const Neighbourhood& n, int corner) {
    Net net{corner, n.offsets, n.corners, n.edge_sharpness, n.vertex_sharpness};
    const auto known = steps_.find(net);
    if (known != steps_.end()) return known->second;
    return steps_.emplace(std::move(net), ChainStep::of(n, corner)).first->second;
  }

  std::int32_t add_chain(const Neighbourhood& n, std::shared_ptr<const ChainStep> step,
                         ParameterSquare square, int depth, Approach approach) {
    const int corner = step->corner();
    SurfaceTree::PlacedChain placed{{std::move(step), n.points, 0}, square, 0};
    VertexChain& chain = placed.chain;
    Neighbourhood last = n;
    for (; !ends(last.points, depth); ++depth, ++chain.levels, ++approach.steps) {
      const std::vector<Vec3> refined = chain.step->refined(last.points);
      if (approach.steps == kTangentSteps && !approach.tangents)
        approach.tangents = tangents_nearby(chain.step->piece((corner + 2) & 3, refined), corner);
      last.points = chain.step->inner(refined);
      square = child_square(square, corner);
    }
    keep_speck(last, corner, square, approach);
    placed.speck = static_cast<std::int32_t>(parts_.specks.size()) - 1;
    parts_.chains.push_back(std::move(placed));
    return add(Node::Kind::chain, parts_.chains.size() - 1);
  }

  std::int32_t add(Node::Kind kind, std::size_t index) {
    parts_.nodes.push_back({kind, {}, static_cast<std::int32_t>(index)});
    return static_cast<std::int32_t>(parts_.nodes.size()) - 1;
  }

  std::int32_t add_speck(const Neighbourhood& n, int corner, const ParameterSquare& square,
                         const Approach& approach) {
    keep_speck(n, corner, square, approach);
    return add(Node::Kind::speck, parts_.specks.size() - 1);
  }

  void keep_speck(const Neighbourhood& n, int corner, const ParameterSquare& square,
                  const Approach& approach) {
    Speck speck;
    speck.position = vertex_limit(n, corner).position;
    speck.square = square;
    if (const auto& t = approach.tangents) {
      speck.tangent_u = t->first, speck.tangent_v = t->second;
      speck.normal = normalized(cross(t->first, t->second));
      speck.plane = t->plane;
    }
    parts_.specks.push_back(speck);
  }

  using Net = std::tuple<int, std::vector<Index>, std::vector<Index>, std::vector<double>,
                         std::vector<double>>;
  Parts parts_;
  std::map<Net, std::shared_ptr<const ChainStep>> steps_;
  double model_size_;
};

void SurfaceTreeBuilder::add_face(const CageNeighbourhoods& neighbourhoods, Index f,
                                  std::size_t corners) {
  const std::size_t patches = corners == 4 ? 1 : corners;
  if (!neighbourhoods.has_surface(f)) {
    for (std::size_t k = 0; k < patches; ++k) add_hole();
  } else if (corners == 4) {
    add_patch(neighbourhoods.of(f));
  } else {
    for (const Neighbourhood& n : refine(neighbourhoods.of(f))) add_patch(n);
  }
}

void SurfaceTree::Parts::append(Parts&& more) {
  const auto patch = static_cast<int>(roots.size());
  const auto node = static_cast<std::int32_t>(nodes.size()),
             piece = static_cast<std::int32_t>(pieces.size()),
             speck = static_cast<std::int32_t>(specks.size()),
             chain = static_cast<std::int32_t>(chains.size());
  for (std::int32_t& root : more.roots) root += root < 0 ? 0 : node;
  for (Node& n : more.nodes) {
    for (std::int32_t& child : n.child) child += node;
    n.index += n.kind == Node::Kind::piece   ? piece
               : n.kind == Node::Kind::chain ? chain
               : n.kind == Node::Kind::speck ? speck
                                             : 0;
  }
  for (Piece& p : more.pieces) p.square.patch += patch;
  for (Speck& s : more.specks) s.square.patch += patch;
  for (PlacedChain& c : more.chains) c.square.patch += patch, c.speck += speck;
  const auto add = [](auto& to, auto& from) {
    to.insert(to.end(), std::make_move_iterator(from.begin()), std::make_move_iterator(from.end()));
  };
  add(roots, more.roots), add(nodes, more.nodes), add(pieces, more.pieces);
  add(specks, more.specks), add(chains, more.chains);
  more = {};
}

SurfaceTree::SurfaceTree(const model::Cage& cage, const model::RunControl& control) {
  const auto defects = model::find_defects(cage);
  if (!defects.empty()) throw std::invalid_argument(model::describe(defects.front()));
  model::Box3 box;
  for (const Vec3& p : cage.vertices) box.add(p);
  const double size = length(box.size());
  const CageNeighbourhoods neighbourhoods(cage);
  const auto faces = static_cast<std::size_t>(cage.face_count());
  std::vector<Parts> parts(model::chunk_count(faces, kFacesAtOnce));
  std::atomic<std::size_t> built{0};
  model::parallel_chunks(faces, kFacesAtOnce, control, [&](std::size_t begin, std::size_t end) {
    SurfaceTreeBuilder builder(size);
    for (std::size_t f = begin; f < end; ++f) {
      control.check();
      const auto face = static_cast<Index>(f);
      builder.add_face(neighbourhoods, face, cage.face(face).size());
    }
    parts[begin / kFacesAtOnce] = builder.take();
    control.report(kBuiltShare * static_cast<double>(built += end - begin) /
                   static_cast<double>(faces));
  });
  for (Parts& part : parts) parts_.append(std::move(part));
  control.check();
  complete(cage, control);
}

SurfaceTree::SurfaceTree(const model::TriangleMesh& mesh, const model::RunControl& control)
    : is_faceted_(true) {
  const model::Cage cage = model::faceted_cage(mesh);
  const auto defects = model::find_defects(cage);
  if (!defects.empty()) throw std::invalid_argument(model::describe(defects.front()));
  for (const auto& triangle : mesh.triangles) {
    std::array<Vec3, 3> corners;
    for (int k = 0; k < 3; ++k) corners[k] = mesh.vertices[triangle[k]];
    for (const Bezier& shape : corner_quads(corners)) {
      const auto index = static_cast<std::int32_t>(parts_.pieces.size());
      parts_.pieces.push_back({shape, {index, 0, 0, 1}});
      parts_.nodes.push_back({Node::Kind::piece, {}, index});
      parts_.roots.push_back(index);
    }
  }
  control.check();
  complete(cage, control);
}

void SurfaceTree::complete(const model::Cage& cage, const model::RunControl& control) {
  features_ = SurfaceFeatures(cage);
  sharp_lines_ = SharpLines(cage);
  bounding_box_ = exact_bounding_box(*this, control);
  control.report(kBoxShare);
  area_mm2_ = surface_area_mm2(*this, control);
}

}  // namespace limitgauge::verifier
