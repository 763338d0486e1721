#include "engine/surface/cell/cell_patch.h"

#include "tests/engine/cages.h"
#include "tests/support/catch.h"

using namespace limitgauge;
using namespace engine::surface;

namespace {

OuterMesh bumpy_mesh() {
  return make_outer_mesh(
      test::grid_cage(3, 10, [](double x, double y) { return 2 * x * x - y * x + 0.3 * y; }));
}

template <class Point>
BasicCellPatch<Point> refined_to(const OuterMesh& mesh, Index face, int depth) {
  BasicCellPatch<Point> patch(mesh, face);
  while (patch.depth() < depth) patch.refine();
  return patch;
}

}  // namespace

TEST_CASE("CELL is below a twelfth of half-edges from depth nine, as the paper counts",
          "[unit][surface][cell]") {
  // Section 8.1: points of 12 bytes; (12 + 4 * 12 / (2^n + 1)) / (12 + 176), limit 6.38 %.
  double last = 1;
  for (int depth = 0; depth <= 20; ++depth) {
    const double r = static_cast<double>(cell_bytes_counted(depth, 12)) /
                     static_cast<double>(half_edge_bytes_counted(depth, 12));
    CHECK(r == Approx(12.0 / 188 * (1 + 4 / (std::ldexp(1.0, depth) + 1))).epsilon(1e-12));
    CHECK(r < last);
    if (depth > 8) CHECK(r < 0.08);
    last = r;
  }
  CHECK(last == Approx(0.0638).margin(5e-5));
}

TEST_CASE("CELL allocates what the paper counts", "[unit][surface][cell]") {
  const OuterMesh mesh = bumpy_mesh();
  const auto single = refined_to<FloatPoint>(mesh, 4, 8);
  const double counted = static_cast<double>(cell_bytes_counted(8, sizeof(FloatPoint)));
  // Four unused corners and the rings of nine points in double precision come on top.
  CHECK(static_cast<double>(single.memory_bytes()) > counted);
  CHECK(static_cast<double>(single.memory_bytes()) < 1.005 * counted);
}

TEST_CASE("single precision loses roundings only", "[unit][surface][cell]") {
  const OuterMesh mesh = bumpy_mesh();
  const auto single = refined_to<FloatPoint>(mesh, 0, 6);
  const auto exact = refined_to<Vec3>(mesh, 0, 6);
  for (int v = 0; v <= exact.cells(); ++v)
    for (int u = 0; u <= exact.cells(); ++u)
      // Coordinates below 32 mm are rounded by 2^-20 at most, once a level, and averaged.
      CHECK(distance(single.control(u, v), exact.control(u, v)) < 6 * std::ldexp(2.0, -20));
}

TEST_CASE("neighbours that differ by many depths meet in their points",
          "[property][surface][cell]") {
  const OuterMesh mesh = bumpy_mesh();
  // To rounding here: the model copies the points of the lower half-edge. Faces 0 and 1 share side
  // 1 of the one and side 3 of the other, in opposite directions.
  for (const int coarse : {1, 3, 5})
    for (const int finer_by : {1, 4, 6}) {
      const LimitPatch a = refined_to<Vec3>(mesh, 0, coarse).limit();
      const LimitPatch b = refined_to<Vec3>(mesh, 1, coarse + finer_by).limit();
      for (int t = 1; t < a.cells(); ++t) {
        const int other = (a.cells() - t) << finer_by;
        CHECK(distance(a.points[a.side_index(1, t)], b.points[b.side_index(3, other)]) < 1e-13);
      }
    }
}
