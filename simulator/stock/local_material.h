#pragma once

#include <cstdint>
#include <vector>

#include "simulator/stock/material.h"

namespace limitgauge::simulator {

/// The material as seen from within one cube: of each pass those moves that may bound it there, so
/// that many points in the cube do not search all moves each. Lives as long as the material.
///
/// d_i is convex and 1-Lipschitz. With the depth D at the middle given by move j, which bends by
/// e_j over the cube, move i cannot bound the material in the cube of half edge h and half
/// diagonal r where d_i − D > min(2r, h·|g_i − g_j|₁ + e_j).
class LocalMaterial {
 public:
  LocalMaterial(const Material& material, const model::Vec3& middle, double half_edge_mm);

  /// Material::sample(), by all moves for a point outside the cube. Of several equal ones it may
  /// name another maker.
  MaterialSample sample(const model::Vec3& p, SurfaceMaker guess = {});

 private:
  bool contains(const model::Vec3& p) const;
  void take_pass(std::uint32_t pass, const MaterialSample& at_middle, double bend);

  const Material& material_;
  model::Vec3 middle_;
  double half_edge_, half_diagonal_;
  std::vector<SurfaceMaker> moves_;
  // The distance and its gradient at the middle: d_i lies above that plane.
  std::vector<double> distance_, gx_, gy_, gz_;
  std::vector<double> plane_;
  std::vector<std::uint32_t> slots_;
};

}  // namespace limitgauge::simulator
