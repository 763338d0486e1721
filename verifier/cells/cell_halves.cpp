#include "verifier/cells/cell_halves.h"

namespace limitgauge::verifier {

CellHalves::Part::Part(const SurfaceCell& of)
    : cell(&of), middle(verifier::middle(of.shape)), radius_mm(control_radius(of.shape, middle)) {}

CellHalves::Part& CellHalves::whole(std::uint32_t index) {
  return wholes_.try_emplace(index, cells_.cells()[index]).first->second;
}

std::array<CellHalves::Part, 2>& CellHalves::halves_of(Part& part) {
  if (!part.halves) {
    const std::array<SurfaceCell, 2> cells = halved(*part.cell);
    part.halves.reset(new Halves{cells, {Part(cells[0]), Part(cells[1])}});
    for (int k = 0; k < 2; ++k) part.halves->parts[k].cell = &part.halves->cells[k];
  }
  return part.halves->parts;
}

}  // namespace limitgauge::verifier
