#include "reports/page/mesh_reduction.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <span>
#include <unordered_map>
#include <vector>

namespace limitgauge::reports::page {
namespace {

using model::TriangleMesh;
using model::Vec3;
using Triangle = std::array<std::uint32_t, 3>;

/// Beyond this, triangles are gathered before edges are looked at: about 100 bytes each.
constexpr std::size_t kMostForEdges = 500'000;
/// How far planes may be from what stands for them, to begin with.
constexpr double kFlat_mm = 1e-3;
constexpr double kGrowth = 1.5;
constexpr int kMostSweeps = 80;
/// Cosine of how far a triangle may turn at once.
constexpr double kLeastTurnCosine = 0.3;

/// Sum of squared distances to planes, as a quadratic form of the point.
struct Quadric {
  double xx = 0, xy = 0, xz = 0, yy = 0, yz = 0, zz = 0, x = 0, y = 0, z = 0, c = 0;
  void add_plane(const Vec3& n, double d) {
    xx += n.x * n.x, xy += n.x * n.y, xz += n.x * n.z, yy += n.y * n.y, yz += n.y * n.z;
    zz += n.z * n.z, x += n.x * d, y += n.y * d, z += n.z * d, c += d * d;
  }
  void add(const Quadric& q) {
    xx += q.xx, xy += q.xy, xz += q.xz, yy += q.yy, yz += q.yz, zz += q.zz;
    x += q.x, y += q.y, z += q.z, c += q.c;
  }
  double at(const Vec3& p) const {
    return p.x * (xx * p.x + 2 * (xy * p.y + xz * p.z + x)) +
           p.y * (yy * p.y + 2 * (yz * p.z + y)) + p.z * (zz * p.z + 2 * z) + c;
  }
};

bool is_flat(const Triangle& t) {
  return t[0] == t[1] || t[1] == t[2] || t[2] == t[0];
}

/// Without vertices that no triangle names.
TriangleMesh compacted(const std::vector<Vec3>& vertices, const std::vector<Triangle>& triangles) {
  constexpr std::uint32_t kUnused = 0xffffffff;
  TriangleMesh out;
  std::vector<std::uint32_t> place(vertices.size(), kUnused);
  for (Triangle t : triangles) {
    for (std::uint32_t& v : t) {
      if (place[v] == kUnused) {
        place[v] = static_cast<std::uint32_t>(out.vertices.size());
        out.vertices.push_back(vertices[v]);
      }
      v = place[v];
    }
    out.triangles.push_back(t);
  }
  return out;
}

/// One vertex, the first, for all in a cube of `cell_mm`; triangles within a cube vanish.
TriangleMesh gathered(const TriangleMesh& mesh, double cell_mm) {
  const Vec3 low = bounding_box(mesh).low;
  std::unordered_map<std::uint64_t, std::uint32_t> first;
  std::vector<std::uint32_t> of(mesh.vertices.size());
  for (std::size_t i = 0; i < of.size(); ++i) {
    const Vec3 at = (mesh.vertices[i] - low) / cell_mm;
    const auto cell = [](double c) { return static_cast<std::uint64_t>(c); };
    const std::uint64_t key = (cell(at.x) << 42) | (cell(at.y) << 21) | cell(at.z);
    of[i] = first.try_emplace(key, static_cast<std::uint32_t>(i)).first->second;
  }
  std::vector<Triangle> kept;
  for (const Triangle& t : mesh.triangles)
    if (const Triangle to{of[t[0]], of[t[1]], of[t[2]]}; !is_flat(to)) kept.push_back(to);
  return compacted(mesh.vertices, kept);
}

/// Draws ends of edges into each other, sweep by sweep.
class EdgeReduction {
 public:
  explicit EdgeReduction(TriangleMesh mesh);
  TriangleMesh run(std::size_t most_triangles, const model::RunControl& control);

 private:
  void sweep(double most_mm2);
  void gather_fans();
  void try_edge(std::uint32_t a, std::uint32_t b, double most_mm2);
  bool can_draw(std::uint32_t from, std::uint32_t to) const;
  void draw(std::uint32_t from, std::uint32_t to);
  void drop_flat();
  std::span<const std::uint32_t> fan(std::uint32_t v) const {
    return {fans_.data() + fan_begin_[v], fan_begin_[v + 1] - fan_begin_[v]};
  }
  Vec3 cross_of(const Triangle& t) const {
    return cross(vertices_[t[1]] - vertices_[t[0]], vertices_[t[2]] - vertices_[t[0]]);
  }

  std::vector<Vec3> vertices_;
  std::vector<Triangle> triangles_;
  std::vector<Quadric> quadrics_;
  std::vector<char> touched_;  ///< in this sweep: its fan is no longer what it was
  std::vector<std::uint32_t> fan_begin_, fans_;
};

EdgeReduction::EdgeReduction(TriangleMesh mesh)
    : vertices_(std::move(mesh.vertices)),
      triangles_(std::move(mesh.triangles)),
      quadrics_(vertices_.size()) {
  for (const Triangle& t : triangles_) {
    const Vec3 normal = cross_of(t);
    const double size = length(normal);
    if (!(size > 0)) continue;
    const Vec3 n = normal / size;
    for (const std::uint32_t v : t) quadrics_[v].add_plane(n, -dot(n, vertices_[t[0]]));
  }
}

void EdgeReduction::gather_fans() {
  fan_begin_.assign(vertices_.size() + 1, 0);
  for (const Triangle& t : triangles_)
    for (const std::uint32_t v : t) ++fan_begin_[v + 1];
  for (std::size_t v = 0; v < vertices_.size(); ++v) fan_begin_[v + 1] += fan_begin_[v];
  fans_.resize(3 * triangles_.size());
  std::vector<std::uint32_t> at(fan_begin_.begin(), fan_begin_.end() - 1);
  for (std::size_t i = 0; i < triangles_.size(); ++i)
    for (const std::uint32_t v : triangles_[i]) fans_[at[v]++] = static_cast<std::uint32_t>(i);
}

/// No triangle of the fan may turn over or come to nothing.
bool EdgeReduction::can_draw(std::uint32_t from, std::uint32_t to) const {
  for (const std::uint32_t i : fan(from)) {
    Triangle t = triangles_[i];
    if (std::find(t.begin(), t.end(), to) != t.end()) continue;
    const Vec3 before = cross_of(t);
    std::replace(t.begin(), t.end(), from, to);
    const Vec3 after = cross_of(t);
    if (!(dot(before, after) > kLeastTurnCosine * length(before) * length(after))) return false;
  }
  return true;
}

void EdgeReduction::draw(std::uint32_t from, std::uint32_t to) {
  for (const std::uint32_t i : fan(from)) {
    for (const std::uint32_t v : triangles_[i]) touched_[v] = 1;
    std::replace(triangles_[i].begin(), triangles_[i].end(), from, to);
  }
  for (const std::uint32_t i : fan(to))
    for (const std::uint32_t v : triangles_[i]) touched_[v] = 1;
  quadrics_[to].add(quadrics_[from]);
}

void EdgeReduction::try_edge(std::uint32_t a, std::uint32_t b, double most_mm2) {
  if (touched_[a] || touched_[b]) return;
  Quadric both = quadrics_[a];
  both.add(quadrics_[b]);
  const double at_a = both.at(vertices_[a]), at_b = both.at(vertices_[b]);
  const auto [from, to] = at_b <= at_a ? std::pair(a, b) : std::pair(b, a);
  if (std::min(at_a, at_b) > most_mm2) return;
  if (can_draw(from, to)) return draw(from, to);
  if (std::max(at_a, at_b) <= most_mm2 && can_draw(to, from)) draw(to, from);
}

void EdgeReduction::drop_flat() {
  std::erase_if(triangles_, is_flat);
}

void EdgeReduction::sweep(double most_mm2) {
  gather_fans();
  touched_.assign(vertices_.size(), 0);
  for (std::size_t i = 0; i < triangles_.size(); ++i)
    for (int k = 0; k < 3; ++k) {
      const auto side = static_cast<std::size_t>(k);
      const std::uint32_t a = triangles_[i][side], b = triangles_[i][(side + 1) % 3];
      if (a < b) try_edge(a, b, most_mm2);
    }
  drop_flat();
}

TriangleMesh EdgeReduction::run(std::size_t most_triangles, const model::RunControl& control) {
  constexpr double kLeastGain = 0.03;
  double most_mm = kFlat_mm;
  bool flat = true;  // what is flat is thinned out however few triangles there are
  for (int k = 0; k < kMostSweeps && (flat || triangles_.size() > most_triangles); ++k) {
    control.check();
    const auto before = static_cast<double>(triangles_.size());
    sweep(most_mm * most_mm);
    if (before - static_cast<double>(triangles_.size()) > kLeastGain * before) continue;
    flat = false;
    most_mm *= kGrowth;
  }
  return compacted(vertices_, triangles_);
}

}  // namespace

TriangleMesh reduced(const TriangleMesh& mesh, std::size_t most_triangles,
                     const model::RunControl& control) {
  if (mesh.triangles.size() <= kMostForEdges)
    return EdgeReduction(mesh).run(most_triangles, control);
  // Two triangles a cell, or nearly.
  const double cell_mm = std::sqrt(2.5 * area_mm2(mesh) / static_cast<double>(kMostForEdges));
  return EdgeReduction(gathered(mesh, cell_mm)).run(most_triangles, control);
}

}  // namespace limitgauge::reports::page
