#include "verifier/stock/mesh_outside.h"

#include <algorithm>
#include <cmath>

#include "model/geometry/box_tree.h"
#include "verifier/tolerance.h"

namespace limitgauge::verifier {
namespace {

using model::Vec3;

/// Where more triangles matter to a cell than the plane across the way to the nearest can tell, it
/// is left to smaller cells to look at them.
constexpr int kMostTriangles = 400;
/// Cells further from the mesh than so many of their radii are well bounded by one triangle.
constexpr double kFar = 8;

double least_along(const Bezier& cell, const Vec3& g) {
  double least = std::numeric_limits<double>::infinity();
  for (int k = 0; k < 16; ++k)
    least = std::min(least, g.x * cell.x[k] + g.y * cell.y[k] + g.z * cell.z[k]);
  return least;
}

double most_along(const Triangle& t, const Vec3& g) {
  return std::max({dot(g, t[0]), dot(g, t[1]), dot(g, t[2])});
}

double most_along(const model::Box3& box, const Vec3& g) {
  const Vec3 half = box.size() * 0.5;
  return dot(box.centre(), g) + half.x * std::abs(g.x) + half.y * std::abs(g.y) +
         half.z * std::abs(g.z);
}

Bezier moved(Bezier cell, const Vec3& by) {
  for (int k = 0; k < 16; ++k) cell.x[k] += by.x, cell.y[k] += by.y, cell.z[k] += by.z;
  return cell;
}

/// The better of two planes that have the triangle on one side: by how much the cell is at least on
/// the other.
double plane_between(const Bezier& cell, const Vec3& centre, const Triangle& t) {
  double best = -std::numeric_limits<double>::infinity();
  const auto look = [&](const Vec3& g) {
    best = std::max(best, least_along(cell, g) - most_along(t, g));
  };
  Vec3 n = normalized(cross(t[1] - t[0], t[2] - t[0]));
  if (dot(n, centre - t[0]) < 0) n = -n;
  if (length_squared(n) > 0) look(n);
  const Vec3 to = centre - nearest_on_triangle(t, centre);
  const double far = length(to);
  // Over the inner part of the triangle that is its normal once more.
  if (far > 0 && dot(to, n) < (1 - kSameDirection) * far) look(to / far);
  return best;
}

}  // namespace

MeshOutside::MeshOutside(const model::TriangleMesh& mesh)
    : tree_(std::make_shared<const TriangleTree>(mesh)), side_(*tree_) {}

MeshOutside MeshOutside::beyond(double mm) const {
  MeshOutside out = *this;
  out.beyond_mm_ += mm;
  return out;
}

BodyDistance MeshOutside::signed_by(const TriangleTree::Foot& foot, const Vec3& p,
                                    bool inside) const {
  const double sign = inside || foot.distance_mm <= kOnMesh_mm ? 1 : -1;
  const Triangle& t = tree_->triangles()[foot.triangle];
  const Vec3 inwards = foot.distance_mm > kMeshWay_mm
                           ? (p - foot.point) * (sign / foot.distance_mm)
                           : -normalized(cross(t[1] - t[0], t[2] - t[0]));
  return {sign * foot.distance_mm + beyond_mm_, inwards, 0};
}

BodyDistance MeshOutside::distance(const Vec3& p) const {
  return signed_by(*tree_->nearest(p), p, side_.inside(p));
}

std::optional<BodyDistance> MeshOutside::distance_up_to(const Vec3& p, double limit_mm) const {
  if (!side_.inside(p)) {
    const BodyDistance d = signed_by(*tree_->nearest(p), p, false);
    return d.value <= limit_mm ? std::optional(d) : std::nullopt;
  }
  if (limit_mm < beyond_mm_) return std::nullopt;
  const auto foot = tree_->nearest(p, limit_mm - beyond_mm_);
  return foot ? std::optional(signed_by(*foot, p, true)) : std::nullopt;
}

/// Proof that all of `cell` moved by `move` is inside (or outside) the mesh, and how far from it at
/// least; `away` leads away from what is nearest.
std::optional<double> MeshOutside::clearance(const Bezier& cell, const Vec3& move, double radius_mm,
                                             const Vec3& away, bool inside) const {
  const Bezier there = moved(cell, move);
  const Vec3 centre = middle(there);
  if (side_.inside(centre) != inside) return std::nullopt;
  const double nearest = tree_->nearest(centre)->distance_mm, base = least_along(there, away);
  // What is further from the middle comes no nearer to the cell than `nearest`.
  const double reach = (nearest + radius_mm) * (nearest + radius_mm);
  double least = nearest - kOnMesh_mm;
  int looks = 0;
  model::nearest_first(
      tree_->nodes(),
      [&](const model::BoxNode& node) {
        const bool beyond = base - most_along(node.box, away) >= least;
        return beyond ? std::numeric_limits<double>::infinity()
                      : distance_squared(node.box, centre);
      },
      [&](double bound) { return bound > reach || least <= 0 || looks > kMostTriangles; },
      [&](const model::BoxNode& leaf) {
        for (std::uint32_t k = leaf.first; k < leaf.first + leaf.count; ++k) {
          const Triangle& t = tree_->triangles()[k];
          const double across = base - most_along(t, away);
          if (across >= least) continue;
          ++looks;
          least = std::min(least, std::max(across, plane_between(there, centre, t)));
        }
      });
  return least > 0 && looks <= kMostTriangles ? std::optional(least) : std::nullopt;
}

double MeshOutside::lower(const Bezier& cell, const Vec3& middle, const BodyDistance& d) const {
  const double here = d.value - beyond_mm_;
  const double radius = control_radius(cell, middle), plain = here - radius;
  const double t = std::max(0.0, radius - here);
  const auto inside = clearance(cell, d.gradient * t, radius, d.gradient, true);
  return beyond_mm_ + (inside ? std::max(plain, *inside - t) : plain);
}

double MeshOutside::upper(const Bezier& cell, const Vec3& middle, const BodyDistance& d) const {
  const double radius = control_radius(cell, middle), here = d.value - beyond_mm_;
  double best = d.value + radius;
  if (here > 0) {
    std::array<double, 16> at{};
    values(cell, at);
    best = std::min(best, *std::max_element(at.begin(), at.end()));
  }
  if (here > kFar * radius) return best;
  const double t = std::max(0.0, radius + here);
  const auto outside = clearance(cell, d.gradient * -t, radius, -d.gradient, false);
  return outside ? std::min(best, beyond_mm_ + t - *outside) : best;
}

void MeshOutside::values(const Bezier& cell, std::array<double, 16>& out) const {
  const Triangle& t = tree_->triangles()[tree_->nearest(middle(cell))->triangle];
  for (int k = 0; k < 16; ++k) {
    const Vec3 p = cell.control(k);
    out[k] = beyond_mm_ + model::distance(p, nearest_on_triangle(t, p));
  }
}

}  // namespace limitgauge::verifier
