#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "engine/surface/finish_model.h"
#include "model/base/run_control.h"
#include "model/part/cutter.h"
#include "model/part/stock.h"
#include "model/part/toolpath.h"

namespace limitgauge::engine::strategy {

enum class Strategy { contour, zigzag, steep_shallow, rest };
/// How rows follow each other: to and fro, or each cut the same way after a retract or link.
enum class RowPattern { zigzag, one_way };
/// Which side of the cutter the material is on, for a spindle that turns clockwise seen from above:
/// climb leaves the part on the right of the cutter's way.
enum class CutDirection { either, climb, conventional };
/// How a cutter gets down into standing material.
enum class Entry { plunge, ramp, helix };

/// What a leaning axis leans from: the setup's Z, or the normal of the surface.
enum class LeanFrom { vertical, surface };

/// How a ball's axis leans along its rows (leaning_axis).
struct ToolLean {
  double lead_deg = 0;  ///< along the feed: positive leans the way that the tool goes
  double tilt_deg = 0;  ///< across the rows: positive to the left of the rows' direction
  LeanFrom from = LeanFrom::vertical;
};

/// How one stage is to be cut; lengths mm, angles degrees, feeds mm/min.
struct CutOptions {
  Strategy strategy = Strategy::zigzag;
  RowPattern pattern = RowPattern::zigzag;
  CutDirection direction = CutDirection::either;
  /// Level distance of a contour, distance of the drive planes of a zigzag; largest one where
  /// `scallop_mm` is given.
  double step_mm = 0;
  /// Largest cusp that may stand between neighbouring passes, along the normal of the surface:
  /// rows come closer where the cutter and the surface ask for it.
  std::optional<double> scallop_mm;
  /// Direction of the rows from +X, counter-clockwise; 90: drive planes perpendicular to X.
  double angle_deg = 90;
  /// steep_shallow: slope of the surface from which contours cut it, from the horizontal.
  double steep_angle_deg = 45;
  /// steep_shallow and rest: how far the passes of a region reach beyond it; empty: two steps.
  std::optional<double> overlap_mm;
  double overlap_or_default_mm() const { return overlap_mm.value_or(2 * step_mm); }
  bool boundary_pass = false;  ///< a pass along the outline of the part after the rows
  double tolerance_mm = 0;  ///< the path may leave the exact cutter location surface by this much
  double feed_mm_min = 0, plunge_feed_mm_min = 0, link_feed_mm_min = 0;
  Entry entry = Entry::ramp;
  double ramp_angle_deg = 3;  ///< of ramps and helices, from the horizontal
  /// Zigzag of a ball: its axis leans, as plan_leaning() has it. Empty: the tool stands along +Z.
  std::optional<ToolLean> lean = std::nullopt;
};

/// One stage as asked for; lengths mm.
struct StageRequest {
  CutOptions cut;
  model::Cutter cutter;
  double allowance_mm = 0;     ///< material left along the normal of the limit surface
  double clearance_mm = 0;     ///< height of rapids above the stock
  double floor_z_mm = 0;       ///< lowest tip height that the stage may use
  double rapid_mm_min = 5000;  ///< what a retract is weighed with
  model::Stock stock;          ///< raw stock of the job
  /// rest: boxes that hold all the material to be cut again; none: nothing is left to cut.
  std::vector<model::Box3> regions;
};

/// A stage's toolpath and the figures of the paper's Tables 2 and 3.
struct StagePath {
  model::Toolpath path;
  int planes = 0;                                            ///< section planes or levels
  int sampling_interval_min = 1, sampling_interval_max = 1;  ///< equation 10
  std::vector<int> sampling_intervals;                       ///< the same, one a patch
  double seconds = 0;
  std::size_t memory_bytes = 0;  ///< of the toolpath
  /// Of a tool that leans: how it stands along the path; empty: along +Z.
  std::optional<model::ToolAxes> axes = std::nullopt;
};

/// The intervals of all patches and their extremes.
void set_intervals(StagePath& stage, std::vector<int> intervals);

}  // namespace limitgauge::engine::strategy
