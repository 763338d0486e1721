#include "verifier/cells/cell_halves.h"

#include "tests/support/cages.h"
#include "tests/support/catch.h"
#include "verifier/surface/reference_surface.h"

namespace limitgauge::verifier {
namespace {

using namespace tests;

bool same(const Bezier& a, const Bezier& b) {
  return a.x == b.x && a.y == b.y && a.z == b.z;
}

/// Parts of a cell down to a depth that are not those which halving it makes.
int others(CellHalves& halves, CellHalves::Part& part, const SurfaceCell& cell, int depth) {
  int found = same(part.cell->shape, cell.shape) && part.cell->u == cell.u &&
                      part.cell->size_v == cell.size_v && part.middle == middle(cell.shape) &&
                      part.radius_mm == control_radius(cell.shape, part.middle)
                  ? 0
                  : 1;
  if (depth == 0) return found;
  const auto cells = halved(cell);
  for (int k = 0; k < 2; ++k)
    found += others(halves, halves.halves_of(part)[k], cells[k], depth - 1);
  return found;
}

}  // namespace

TEST_CASE("kept halves are those of the cell, before and after all were let go of",
          "[unit][cells]") {
  const ReferenceSurface surface(star_cage(5, 4));
  const SurfaceCells cells(surface.tree(), 0.8);
  CellHalves halves(cells);
  REQUIRE(cells.cells().size() > 20);
  for (int round = 0; round < 3; ++round) {
    // More than a block of them, other cells first each time, and each asked twice.
    for (std::uint32_t k = 0; k < 40; ++k) {
      const auto index = static_cast<std::uint32_t>((k * 7 + round) % cells.cells().size());
      CHECK(others(halves, halves.whole(index), cells.cells()[index], 4) == 0);
    }
    halves.forget();
  }
}

}  // namespace limitgauge::verifier
