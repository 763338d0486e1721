#include "verifier/cells/cell_halves.h"

namespace limitgauge::verifier {

CellHalves::Part::Part(const SurfaceCell& of)
    : cell(&of), middle(verifier::middle(of.shape)), radius_mm(control_radius(of.shape, middle)) {}

CellHalves::CellHalves(const SurfaceCells& cells)
    : cells_(cells), place_(cells.cells().size(), kNone) {}

CellHalves::Part& CellHalves::whole(std::uint32_t index) {
  std::uint32_t& place = place_[index];
  if (place == kNone) {
    place = static_cast<std::uint32_t>(wholes_.size());
    wholes_.emplace_back(cells_.cells()[index]);
    known_.push_back(index);
  }
  return wholes_[place];
}

std::array<CellHalves::Part, 2>& CellHalves::halves_of(Part& part) {
  if (!part.halves) {
    if (used_ == blocks_.size() * kBlock)
      blocks_.push_back(std::make_unique_for_overwrite<Halves[]>(kBlock));
    Halves& halves = blocks_[used_ / kBlock][used_ % kBlock];
    ++used_;
    halves.cells = halved(*part.cell);
    for (int k = 0; k < 2; ++k) halves.parts[k] = Part(halves.cells[k]);
    part.halves = &halves;
  }
  return part.halves->parts;
}

void CellHalves::forget() {
  for (const std::uint32_t index : known_) place_[index] = kNone;
  known_.clear(), wholes_.clear();
  used_ = 0;
}

}  // namespace limitgauge::verifier
