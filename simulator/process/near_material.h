#pragma once

#include <array>

#include "simulator/grid/lattice.h"
#include "simulator/stock/material.h"
#include "simulator/sweep/near_moves.h"

namespace limitgauge::simulator {

/// The exact material, prepared for many questions in one place after the other: what can matter
/// there is gathered once for a block of cells and handed down to smaller and smaller cubes. What
/// it answers does not depend on the places before.
class NearMaterial {
 public:
  NearMaterial(const Material& material, const Lattice& lattice);

  /// Turns to the cell whose lowest corner is voxel `cell`. Quick where cells follow each other in
  /// the order of visited cubes of 2, 4, 8 and 32 cells.
  void turn_to(const Index3& cell);
  /// As Material::sample; quick in the cell and a quarter of a voxel about it.
  MaterialSample sample(const model::Vec3& p, SurfaceMaker guess) const;
  MaterialSample sample_of(SurfaceMaker maker, const model::Vec3& p) const {
    return material_.sample_of(maker, p);
  }

 private:
  struct Level {
    int edge;       // cells
    double margin;  // voxels about them
    bool ready = false;
    Index3 corner{};
    Cube cube{};
    RawSample raw{};                 // in its middle
    std::vector<NearMoves> moves{};  // by pass
  };
  void prepare(Level& level, const Level* wider);
  MaterialSample sample_in(const Level& level, const model::Vec3& p, SurfaceMaker guess) const;

  const Material& material_;
  Lattice lattice_;
  std::array<Level, 4> levels_{Level{32, 1.0}, Level{8, 0.75}, Level{4, 0.5}, Level{2, 0.25}};
};

}  // namespace limitgauge::simulator
