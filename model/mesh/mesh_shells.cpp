#include "model/mesh/mesh_shells.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <limits>
#include <map>
#include <numeric>
#include <utility>

#include "model/base/tolerance.h"
#include "model/geometry/box_tree.h"

namespace limitgauge::model {
namespace {

using Triangle = std::array<std::uint32_t, 3>;

class Groups {
 public:
  explicit Groups(std::size_t count) : parent_(count) {
    std::iota(parent_.begin(), parent_.end(), 0U);
  }
  std::uint32_t of(std::uint32_t v) {
    while (parent_[v] != v) v = parent_[v] = parent_[parent_[v]];
    return v;
  }
  void join(std::uint32_t a, std::uint32_t b) {
    a = of(a), b = of(b);
    (a < b ? parent_[b] : parent_[a]) = std::min(a, b);
  }

 private:
  std::vector<std::uint32_t> parent_;
};

/// Whether each shell has an edge of one triangle.
std::vector<bool> open_shells(const TriangleMesh& mesh, const MeshShells& all) {
  struct Use {
    std::uint32_t low, high, triangle;
    auto operator<=>(const Use&) const = default;
  };
  std::vector<Use> uses;
  uses.reserve(3 * mesh.triangles.size());
  for (std::uint32_t i = 0; i < mesh.triangles.size(); ++i)
    for (int k = 0; k < 3; ++k) {
      const auto [low, high] = std::minmax(mesh.triangles[i][k], mesh.triangles[i][(k + 1) % 3]);
      if (low != high) uses.push_back({low, high, i});
    }
  std::sort(uses.begin(), uses.end());
  std::vector<bool> open(all.shells.size());
  for (std::size_t begin = 0, end = 0; begin < uses.size(); begin = end) {
    while (end < uses.size() && uses[end].low == uses[begin].low &&
           uses[end].high == uses[begin].high)
      ++end;
    if (end == begin + 1) open[all.of_triangle[uses[begin].triangle]] = true;
  }
  return open;
}

Vec3 middle_of(const TriangleMesh& mesh, std::size_t t) {
  const Triangle& c = mesh.triangles[t];
  return (mesh.vertices[c[0]] + mesh.vertices[c[1]] + mesh.vertices[c[2]]) / 3;
}

/// Which shells lie about a place, by how often a ray from there leaves them more than it enters.
class ShellRays {
 public:
  ShellRays(const TriangleMesh& mesh, const MeshShells& all) : mesh_(mesh), all_(all) {
    std::vector<Box3> boxes(mesh.triangles.size());
    for (std::size_t i = 0; i < boxes.size(); ++i)
      for (const std::uint32_t v : mesh.triangles[i]) boxes[i].add(mesh.vertices[v]);
    constexpr std::uint32_t kLeaf = 8;
    tree_ = box_tree(boxes, kLeaf);
  }

  /// Those of positive volume, by two of three rays: one may run through an edge.
  std::vector<std::uint32_t> around(const Vec3& p) const {
    constexpr std::array<Vec3, 3> kRays = {
        {{0.311, 0.173, 0.934}, {-0.547, 0.729, 0.411}, {0.823, -0.457, -0.338}}};
    std::map<std::uint32_t, int> times;
    for (const Vec3& ray : kRays)
      for (const auto& [shell, count] : leaves(p, ray))
        if (count == 1 && all_.shells[shell].volume_mm3 > 0) ++times[shell];
    std::vector<std::uint32_t> shells;
    for (const auto& [shell, count] : times)
      if (count >= 2) shells.push_back(shell);
    return shells;
  }

 private:
  std::map<std::uint32_t, int> leaves(const Vec3& p, const Vec3& ray) const {
    std::map<std::uint32_t, int> counts;
    nearest_first(
        tree_.nodes, [&](const BoxNode& node) { return meets(node.box, p, ray) ? 0.0 : 1.0; },
        [](double bound) { return bound > 0; },
        [&](const BoxNode& leaf) {
          for (std::uint32_t k = leaf.first; k < leaf.first + leaf.count; ++k)
            if (const int side = crossed(mesh_.triangles[tree_.order[k]], p, ray))
              counts[all_.of_triangle[tree_.order[k]]] += side;
        });
    return counts;
  }
  static bool meets(const Box3& box, const Vec3& p, const Vec3& ray) {
    double from = 0, to = std::numeric_limits<double>::infinity();
    for (int axis = 0; axis < 3; ++axis) {
      const double a = (box.low[axis] - p[axis]) / ray[axis];
      const double b = (box.high[axis] - p[axis]) / ray[axis];
      from = std::max(from, std::min(a, b)), to = std::min(to, std::max(a, b));
    }
    return from <= to;
  }
  /// 1 where the ray comes out through the triangle's front, −1 where it goes in.
  int crossed(const Triangle& t, const Vec3& p, const Vec3& ray) const {
    const Vec3 a = mesh_.vertices[t[0]] - p, b = mesh_.vertices[t[1]] - p,
               c = mesh_.vertices[t[2]] - p;
    const double u = dot(ray, cross(b, c)), v = dot(ray, cross(c, a)), w = dot(ray, cross(a, b));
    if (!((u > 0 && v > 0 && w > 0) || (u < 0 && v < 0 && w < 0))) return 0;
    const double volume = dot(a, cross(b, c));
    const int side = u > 0 ? 1 : -1;
    return volume * side > 0 ? side : 0;
  }

  const TriangleMesh& mesh_;
  const MeshShells& all_;
  BoxTree tree_;
};

/// The triangles of each shell, one shell's after the other.
struct ShellTriangles {
  std::vector<std::size_t> first;
  std::vector<std::uint32_t> order;

  explicit ShellTriangles(const MeshShells& all)
      : first(all.shells.size() + 1), order(all.of_triangle.size()) {
    for (const std::uint32_t shell : all.of_triangle) ++first[shell + 1];
    std::partial_sum(first.begin(), first.end(), first.begin());
    std::vector<std::size_t> next(first.begin(), first.end() - 1);
    for (std::uint32_t i = 0; i < all.of_triangle.size(); ++i)
      order[next[all.of_triangle[i]]++] = i;
  }
  /// Some of a shell's, all over it.
  std::vector<std::uint32_t> some_of(std::uint32_t shell) const {
    constexpr std::size_t kSome = 7;
    const std::size_t count = first[shell + 1] - first[shell], some = std::min(kSome, count);
    std::vector<std::uint32_t> out;
    for (std::size_t k = 0; k < some; ++k) out.push_back(order[first[shell] + k * count / some]);
    return out;
  }
};

/// Whether one body is about all places of the shell that are looked at.
bool is_cavity(const TriangleMesh& mesh, const std::vector<std::uint32_t>& some,
               const ShellRays& rays) {
  std::vector<std::uint32_t> around_all;
  bool first = true;
  for (const std::uint32_t t : some) {
    const std::vector<std::uint32_t> around = rays.around(middle_of(mesh, t));
    std::vector<std::uint32_t> both;
    std::ranges::set_intersection(around_all, around, std::back_inserter(both));
    around_all = first ? around : both;
    first = false;
  }
  return !around_all.empty();
}

}  // namespace

bool Shell::encloses_volume() const {
  const double d = length(box.size());
  return std::abs(volume_mm3) > kLeastVolumeShare * d * d * d;
}

MeshShells shells_of(const TriangleMesh& mesh) {
  Groups groups(mesh.vertices.size());
  for (const Triangle& t : mesh.triangles) groups.join(t[0], t[1]), groups.join(t[0], t[2]);
  constexpr std::uint32_t kNone = UINT32_MAX;
  std::vector<std::uint32_t> shell_of(mesh.vertices.size(), kNone);
  MeshShells all;
  all.of_triangle.reserve(mesh.triangles.size());
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
    const Triangle& t = mesh.triangles[i];
    std::uint32_t& shell = shell_of[groups.of(t[0])];
    if (shell == kNone) {
      shell = static_cast<std::uint32_t>(all.shells.size());
      all.shells.push_back({i, {}, 0});
    }
    all.of_triangle.push_back(shell);
    Shell& s = all.shells[shell];
    for (const std::uint32_t v : t) s.box.add(mesh.vertices[v]);
    const Vec3& o = mesh.vertices[mesh.triangles[s.first_triangle][0]];
    s.volume_mm3 +=
        dot(mesh.vertices[t[0]] - o, cross(mesh.vertices[t[1]] - o, mesh.vertices[t[2]] - o)) / 6;
  }
  return all;
}

std::optional<std::uint32_t> inside_out_shell(const TriangleMesh& mesh, const MeshShells& of) {
  const auto may_be = [](const Shell& s) { return s.volume_mm3 < 0 && s.encloses_volume(); };
  // Most meshes have none, and are not looked at more closely.
  if (std::ranges::none_of(of.shells, may_be)) return std::nullopt;
  const std::vector<bool> is_open = open_shells(mesh, of);
  const ShellTriangles triangles(of);
  const ShellRays rays(mesh, of);
  for (std::uint32_t k = 0; k < of.shells.size(); ++k)
    if (may_be(of.shells[k]) && !is_open[k] && !is_cavity(mesh, triangles.some_of(k), rays))
      return k;
  return std::nullopt;
}

}  // namespace limitgauge::model
