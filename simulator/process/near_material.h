#pragma once

#include <span>
#include <vector>

#include "simulator/grid/lattice.h"
#include "simulator/stock/material.h"
#include "simulator/sweep/near_moves.h"

namespace limitgauge::simulator {

/// Cubes of `edge` cells with a margin about them, in voxels.
struct NearCubes {
  int edge;
  double margin;
};

/// The exact material, prepared for many questions in one place after the other: what can matter
/// there is gathered once for a block of cells and handed down to smaller and smaller cubes. What
/// it answers does not depend on the places before.
class NearMaterial {
 public:
  /// For questions about single cells.
  NearMaterial(const Material& material, const Lattice& lattice);
  /// For others: cubes from large to small, edges powers of two.
  NearMaterial(const Material& material, const Lattice& lattice, std::span<const NearCubes> cubes);

  /// Turns to the cell whose lowest corner is voxel `cell`. Quick where cells follow each other in
  /// the order of visited cubes.
  void turn_to(const Index3& cell);
  /// As Material::sample; quick in the smallest cube about the cell and its margin: of the first
  /// constructor's two cells and a quarter of a voxel.
  MaterialSample sample(const model::Vec3& p, SurfaceMaker guess) const;
  MaterialSample sample_of(SurfaceMaker maker, const model::Vec3& p) const {
    return material_.sample_of(maker, p);
  }

 private:
  struct Level {
    NearCubes cubes;
    bool ready = false;
    Index3 corner{};
    Cube cube{};
    RawSample raw{};                 // in its middle
    std::vector<NearMoves> moves{};  // by pass
    bool only_raw = false;           // no move of any pass matters in the cube
    bool holds(const Index3& cell) const;
  };
  void prepare(Level& level, const Level* wider);
  MaterialSample sample_in(const Level& level, const model::Vec3& p, SurfaceMaker guess) const;

  const Material& material_;
  Lattice lattice_;
  std::vector<Level> levels_;
  std::size_t last_ = 0;  // of levels_, the smallest that is of the place turned to
};

}  // namespace limitgauge::simulator
