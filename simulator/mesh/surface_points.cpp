#include "simulator/mesh/surface_points.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "model/base/chunks.h"
#include "simulator/tolerance.h"

namespace limitgauge::simulator {
namespace {

using model::Vec3;

// Leaves whose points are held at a time, and those that one thread takes.
constexpr std::size_t kBatch = 2048, kLeaves = 32;

constexpr int kMostSteps = 24;

// The shortest step that brings both linearised values to zero; only the first one where the two
// gradients are too nearly parallel to say more.
Vec3 step_to_both(const MaterialSample& a, const MaterialSample& b) {
  const double aa = dot(a.gradient, a.gradient), bb = dot(b.gradient, b.gradient);
  const double ab = dot(a.gradient, b.gradient), det = aa * bb - ab * ab;
  if (det <= kSameLine * aa * bb) return a.gradient * (-a.value / aa);
  const double la = (b.value * ab - a.value * bb) / det;
  const double lb = (a.value * ab - b.value * aa) / det;
  return a.gradient * la + b.gradient * lb;
}

Vec3 step_to_three(const MaterialSample& a, const MaterialSample& b, const MaterialSample& c) {
  const Vec3 bc = cross(b.gradient, c.gradient);
  const double det = dot(a.gradient, bc);
  if (std::abs(det) < kSamePlane) return step_to_both(a, b);
  return (bc * a.value + cross(c.gradient, a.gradient) * b.value +
          cross(a.gradient, b.gradient) * c.value) *
         (-1 / det);
}

Vec3 step_to_all(std::span<const MaterialSample> s) {
  if (s.size() == 3) return step_to_three(s[0], s[1], s[2]);
  if (s.size() == 2) return step_to_both(s[0], s[1]);
  return s[0].gradient * (-s[0].value / dot(s[0].gradient, s[0].gradient));
}

// The makers met so far, the last one first; those that do not bind here are left out of a step.
class Makers {
 public:
  void meet(SurfaceMaker maker) {
    const auto end = known_.begin() + count_;
    auto at = std::find(known_.begin(), end, maker);
    if (at == end && count_ < known_.size()) ++count_, at = known_.begin() + count_ - 1;
    if (at == known_.end()) at = known_.end() - 1;
    *at = maker;
    std::rotate(known_.begin(), at, at + 1);
  }

  template <class Source>
  Vec3 step(const Source& material, const MaterialSample& now, const Vec3& p) const {
    std::array<MaterialSample, 3> binding{now};
    std::size_t n = 1;
    const Vec3 alone = now.gradient * -now.value;
    for (std::size_t k = 1; k < count_; ++k) {
      const MaterialSample s = material.sample_of(known_[k], p);
      // Would the plain step leave this maker's side of the surface?
      if (s.value + dot(s.gradient, alone) > 0) binding[n++] = s;
    }
    return n == 1 ? alone : step_to_all(std::span(binding).first(n));
  }

 private:
  std::array<SurfaceMaker, 3> known_{};
  std::size_t count_ = 0;
};

Vec3 shortened(const Vec3& step, double most) {
  const double l = length(step);
  return l > most ? step * (most / l) : step;
}

}  // namespace

Vec3 step_onto(std::span<const MaterialSample> samples) {
  return step_to_all(samples);
}

namespace {

/// `sample` is the material's, from wherever it is known.
template <class Source, class Sample>
StockPoint project(const Source& material, const Sample& sample, const Vec3& start, double voxel_mm,
                   SurfaceMaker& hint) {
  Vec3 p = start;
  MaterialSample now = sample(p, hint);
  StockPoint best{p, std::abs(now.value)};
  Makers makers;
  for (int step = 0; step < kMostSteps && best.residual_mm > kSurfacePoint_mm; ++step) {
    makers.meet(now.maker);
    p += shortened(makers.step(material, now, p), voxel_mm);
    now = sample(p, now.maker);
    if (std::abs(now.value) < best.residual_mm) best = {p, std::abs(now.value)};
  }
  hint = now.maker;
  return best;
}

}  // namespace

StockPoint project_to_surface(const Material& material, const Vec3& start, double voxel_mm,
                              SurfaceMaker& hint) {
  const auto sample = [&](const Vec3& p, SurfaceMaker guess) { return material.sample(p, guess); };
  return project(material, sample, start, voxel_mm, hint);
}

StockPoint project_to_surface(const NearMaterial& material, const Vec3& start, double voxel_mm,
                              SurfaceMaker& hint) {
  const auto sample = [&](const Vec3& p, SurfaceMaker guess) { return material.sample(p, guess); };
  return project(material, sample, start, voxel_mm, hint);
}

namespace {

// Cubes about the voxels of a leaf; the surface is less than two voxels away.
constexpr std::array<NearCubes, 3> kAboutLeaves{{{32, 2}, {8, 2}, {4, 2}}};

bool meets(const model::Box3& region, const Vec3& low, const Vec3& high) {
  for (int a = 0; a < 3; ++a)
    if (high[a] < region.low[a] || low[a] > region.high[a]) return false;
  return true;
}

// Which part of a leaf, by its place among the cubes of half its edge.
int part_of_leaf(const Index3& v) {
  constexpr int kHalf = kLeafEdge / 2;
  return (v[0] & kHalf ? 4 : 0) + (v[1] & kHalf ? 2 : 0) + (v[2] & kHalf ? 1 : 0);
}

// The points stand in the order of the voxels, but are looked for part by part.
std::vector<StockPoint> leaf_points(NearMaterial& material, const Lattice& lattice,
                                    const GridLeaves& leaves, std::size_t leaf,
                                    const model::Box3& region) {
  const IndexBox cube = cube_at(leaves.corner(leaf), kLeafEdge);
  if (!meets(region, lattice.point(cube.low), lattice.point(cube.high))) return {};
  std::vector<Index3> voxels = leaves.surface_voxels(leaf);
  std::erase_if(voxels, [&](const Index3& v) { return !region.contains(lattice.point(v)); });
  std::vector<StockPoint> points(voxels.size());
  SurfaceMaker hint;
  for (int part = 0; part < 8; ++part)
    for (std::size_t k = 0; k < voxels.size(); ++k) {
      if (part_of_leaf(voxels[k]) != part) continue;
      material.turn_to(voxels[k]);
      points[k] = project_to_surface(material, lattice.point(voxels[k]), lattice.voxel_mm, hint);
    }
  return points;
}

}  // namespace

void visit_points(const Material& material, const StockGrid& grid, const model::Box3& region,
                  const PointVisitor& visit, const model::RunControl& control) {
  const GridLeaves leaves(grid);
  for (std::size_t first = 0; first < leaves.size(); first += kBatch) {
    std::vector<std::vector<StockPoint>> points(std::min(kBatch, leaves.size() - first));
    model::parallel_chunks(
        points.size(), kLeaves, control, [&](std::size_t begin, std::size_t end) {
          NearMaterial near(material, grid.lattice(), kAboutLeaves);
          for (std::size_t i = begin; i < end; ++i)
            points[i] = leaf_points(near, grid.lattice(), leaves, first + i, region);
        });
    for (const auto& of_leaf : points)
      if (!of_leaf.empty()) visit(of_leaf);
    control.report(static_cast<double>(first + points.size()) / static_cast<double>(leaves.size()));
  }
}

}  // namespace limitgauge::simulator
