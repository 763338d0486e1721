#include "tests/simulator/process/process_bench.h"

#include <algorithm>
#include <array>
#include <iterator>

namespace limitgauge::simulator::test {

using model::Box3;
using model::CutterType;
using model::TriangleMesh;
using model::Vec3;

TriangleMesh box_mesh(const Box3& box) {
  TriangleMesh mesh;
  for (int i = 0; i < 8; ++i)
    mesh.vertices.push_back({i & 1 ? box.high.x : box.low.x, i & 2 ? box.high.y : box.low.y,
                             i & 4 ? box.high.z : box.low.z});
  const std::uint32_t quads[6][4] = {{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4},
                                     {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}};
  for (const auto& q : quads) {
    mesh.triangles.push_back({q[0], q[1], q[2]});
    mesh.triangles.push_back({q[0], q[2], q[3]});
  }
  return mesh;
}

TriangleMesh tetrahedron(const std::array<Vec3, 4>& c) {
  TriangleMesh mesh{{c.begin(), c.end()}, {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {0, 3, 2}}};
  if (dot(cross(c[1] - c[0], c[2] - c[0]), c[3] - c[0]) < 0)
    for (auto& t : mesh.triangles) std::swap(t[1], t[2]);
  return mesh;
}

model::Fixture fixture(const std::string& name, const TriangleMesh& mesh) {
  return {name, name + ".stl", std::make_shared<const TriangleMesh>(mesh)};
}

std::vector<Finding> of_kind(const std::vector<Finding>& all, FindingKind kind) {
  std::vector<Finding> some;
  std::copy_if(all.begin(), all.end(), std::back_inserter(some),
               [kind](const Finding& f) { return f.kind == kind; });
  return some;
}

std::size_t count_of(const std::vector<Finding>& all, FindingKind kind) {
  return of_kind(all, kind).size();
}

double worst_of(const std::vector<Finding>& all, FindingKind kind) {
  double depth = -1;
  for (const Finding& f : of_kind(all, kind)) depth = std::max(depth, f.depth_mm);
  return depth;
}

Pass split(const Pass& pass, int pieces) {
  return changed(pass, [&](model::Toolpath& path) {
    const model::Toolpath whole = path;
    path.moves.clear();
    for (std::size_t i = 0; i < whole.moves.size(); ++i)
      for (int k = 1; k <= pieces; ++k) {
        path.moves.push_back(whole.moves[i]);
        if (k < pieces)
          path.moves.back().to =
              lerp(move_from(whole, i), whole.moves[i].to, static_cast<double>(k) / pieces);
      }
  });
}

StockModel block() {
  return {model::BoxStock{{-15, -10, -8}, {30, 20, 8}}, 0.25, std::size_t{1} << 30};
}

model::Cutter flat4(double flutes) {
  return cutter(CutterType::flat, 4, flutes);
}

model::Cutter ball4() {
  return cutter(CutterType::ball, 4, 20);
}

Pass slot(const model::Cutter& c, double depth) {
  return PathBuilder({-20, 0, -depth}).feed({20, 0, -depth}).pass(c);
}

ProcessLimits plain_limits(double near_miss_mm) {
  ProcessLimits limits;
  limits.tolerance_mm = kTolerance;
  limits.near_miss_mm = near_miss_mm;
  return limits;
}

std::vector<Finding> check(const StockModel& before, const Pass& pass, const ProcessLimits& limits,
                           unsigned threads) {
  return check_process(before, pass, limits, {threads});
}

}  // namespace limitgauge::simulator::test
