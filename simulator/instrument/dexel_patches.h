#pragma once

#include <array>
#include <cstdint>

#include "simulator/instrument/dexel_sweep.h"

namespace limitgauge::simulator {

/// Where the lines of a tile stand.
struct DexelFrame {
  double x = 0, y = 0;    ///< of the first line, mm
  double dx = 0, dy = 0;  ///< spacings
};

/// A tile's lines in square patches, over each of which a plane lies that no line's material rises
/// above. A sweep whose lower side stays above the plane takes nothing from the patch: of the lines
/// under a cutter those are nearly all, once a pass beside has been there.
/// Proof: simulator/PROOFS.md, P5.
class DexelPatches {
 public:
  static constexpr int kEdge = 8;   ///< lines
  static constexpr int kASide = 4;  ///< patches
  static constexpr int kLines = kEdge * kASide;
  static constexpr std::size_t kPatches = std::size_t{kASide} * kASide;

  /// Nothing is known of any: the planes are at infinity.
  DexelPatches() { height_.fill(std::numeric_limits<double>::infinity()); }

  /// A bit for each patch from which the sweep may take something, x before y.
  std::uint32_t touched(const DexelSweep& sweep, const DexelFrame& frame) const;
  /// The material of a patch has become less: its plane stays where it is.
  void changed(std::size_t patch) { laid_ &= ~(1U << patch); }
  /// The material of a patch has become another one.
  void forget(std::size_t patch) {
    changed(patch);
    height_[patch] = std::numeric_limits<double>::infinity();
  }
  /// Lays the plane over the tops of the tile's lines, row by row, unless nothing has changed since
  /// it was laid; minus infinity without material.
  void lay(std::size_t patch, const double* tops, const DexelFrame& frame);

 private:
  using Numbers = std::array<double, kPatches>;
  Numbers height_;                 // of the plane in the patch's middle, mm
  Numbers slope_x_{}, slope_y_{};  // no unit
  std::uint32_t laid_ = 0;         // since the material changed
};

}  // namespace limitgauge::simulator
