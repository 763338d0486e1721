#include "verifier/cells/offset_cell.h"

#include "tests/support/cages.h"
#include "tests/support/catch.h"
#include "verifier/cells/surface_cells.h"
#include "verifier/surface/reference_surface.h"

namespace limitgauge::verifier {

using namespace tests;
using model::Vec3;

TEST_CASE("normals lie within the remainder of their linear map", "[property]") {
  const model::Cage cage = GENERATE(star_cage(7, 5), star_cage(3, 4), trough_cage(10, 0.05));
  const ReferenceSurface surface(cage);
  int turned = 0;
  for (const double size_mm : {1.5, 0.4}) {
    const SurfaceCells cells(surface.tree(), size_mm);
    for (const SurfaceCell& cell : cells.cells()) {
      const OffsetCell o = offset_cell(cell.shape, {});
      // Normals of less than a micrometre beside irregular vertices are rounding: another stands
      // in.
      if (o.remainder >= 1 || length(cell.vertex_normal) > 0) continue;
      turned += length(o.turning[0]) + length(o.turning[1]) + length(o.turning[2]) > 0;
      double most = 0;
      for (double s = 0; s <= 1; s += 0.125)
        for (double t = 0; t <= 1; t += 0.125) {
          const BezierJet j = jet(cell.shape, s, t);
          const Vec3 n = normalized(cross(j.du, j.dv)), w = j.position - o.middle;
          const Vec3 map = o.normal + o.turning[0] * w.x + o.turning[1] * w.y + o.turning[2] * w.z;
          most = std::max(most, distance(n, map));
        }
      CHECK(most <= o.remainder + 1e-12);
    }
  }
  CHECK(turned > 100);
}

}  // namespace limitgauge::verifier
