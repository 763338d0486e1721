#pragma once

#include <cstddef>
#include <vector>

#include "model/part/stock.h"
#include "model/part/toolpath.h"

namespace limitgauge::simulator {

using model::Pass;

/// What one move took away, from columns of material along Z. Heights are exact on each line; a
/// boundary between two lines is placed halfway, which is wrong by half a spacing at most.
struct MoveRemoval {
  double volume_mm3 = 0;
  double rate_mm3_min = 0;  ///< volume over the move's time at its feed rate; 0 where it has none
  /// Largest height of material removed in one column (axial engagement).
  double axial_mm = 0;
  /// Width, level and across the move's direction, between the outermost places where material was
  /// removed (radial engagement), to a spacing; of a vertical move the larger of the widths along x
  /// and y. Never more than the cutter's largest diameter.
  double radial_mm = 0;
};

/// Totals of one pass.
struct RemovalTotals {
  double volume_mm3 = 0;
  /// Largest removal rate over a stretch of feed moves at least ten spacings long, or of all moves
  /// between two rapids where those are shorter: the rate of a single short move is as rough as
  /// the few lines that it crosses are.
  double largest_rate_mm3_min = 0;
  std::size_t largest_rate_move = 0;                   ///< first of that stretch
  double largest_axial_mm = 0, largest_radial_mm = 0;  ///< of feed moves
  /// Feed moves that removed nothing from any line by more than rounding (1e-9 mm).
  double air_length_mm = 0, air_time_s = 0;
  double spacing_mm = 0;  ///< of the columns
};

struct Removal {
  std::vector<MoveRemoval> moves;  ///< one a move of the path
  RemovalTotals totals;
};

/// Totals of what the moves of `path` took.
RemovalTotals removal_totals(const model::Toolpath& path, const std::vector<MoveRemoval>& moves,
                             double spacing_mm);

/// The spacing of lines to use for these passes: the voxel, or more where that would need more than
/// four million lines, or more than 1.5e9 visits of lines by moves in any pass (some seconds); of
/// visits no spacing is wider than a fifth of the smallest cutter radius, with which a short move
/// visits some eighty lines. At most a twentieth of the stock's larger side. Linear in moves.
double removal_spacing_mm(double voxel_mm, const model::Stock& stock,
                          const std::vector<Pass>& passes);

/// Bytes of the work in hand while a pass is cut, whatever its length.
inline constexpr std::size_t kDexelWindowBytes = std::size_t{64} << 20;

/// Bytes that cutting a pass of so many moves takes: the stock before and after, what is kept for
/// each move, and the work in hand.
double removal_bytes(const model::Stock& stock, double spacing_mm, std::size_t moves);

}  // namespace limitgauge::simulator
