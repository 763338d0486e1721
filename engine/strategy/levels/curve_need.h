#pragma once

#include <vector>

#include "engine/strategy/raster/isoline.h"
#include "engine/strategy/raster/slope_mask.h"

namespace limitgauge::engine::strategy {

/// Over which cells of a raster curves are wanted, and which gaps between two stretches of one
/// curve may be cut with them (see BridgeRule): how long they are, mm, and how much of that is over
/// cells that are touched.
struct CurveNeed {
  CellMask cells;
  double bridged_mm = 0;
  CellMask touched;
  double repeated_mm = 0;
};

/// The mask with all cells no more than `cells` columns and rows from one of it.
CellMask widened(const CellMask& mask, int cells);

/// What of a curve, known between the nodes of the raster, has to be followed so that all of it
/// over the cells wanted and all gaps that may be cut are followed: the line itself where that is
/// all of it, open stretches otherwise. The cells of `near` are those wanted, widened by as many as
/// the line may be off by.
std::vector<Isoline> needed_stretches(const Isoline& line, const CurveNeed& near);

}  // namespace limitgauge::engine::strategy
