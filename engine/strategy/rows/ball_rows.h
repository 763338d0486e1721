#pragma once

#include <cstddef>
#include <vector>

#include "engine/strategy/locations/ball_sections.h"
#include "engine/strategy/rows/drive_rows.h"
#include "engine/strategy/stage_path.h"
#include "model/base/run_control.h"

namespace limitgauge::engine::strategy {

/// One drive plane and the path of the ball's centre in it.
struct CentreRow {
  double across_mm = 0;
  Envelope centre;
};

/// The rows in the planes at `across_mm` (ascending).
std::vector<CentreRow> rows_at(const BallSections& sections, const std::vector<double>& across_mm,
                               const model::RunControl& control);
/// Places of rows `step_mm` apart over the surface and the ball's reach at both sides, as the paper
/// counts planes.
std::vector<double> even_rows(const BallSections& sections, double step_mm);

/// Rows as far apart as leave cusps of at most `cut.scallop_mm`, never farther than `cut.step_mm`.
///
/// Rows at the largest step are tried first; the cusp between two of them, which grows with the
/// square of their distance, says how far apart rows may be there: slope and curvature across the
/// rows are thus taken as they are. Rows are then placed greedily, and each cusp is measured again:
/// where one is too high another row is put in its middle.
///
/// Towards walls along the rows no distance is small enough: rows are never closer than
/// `kClosestShare` of the largest step, and what stands there is left to other passes.
inline constexpr double kClosestShare = 0.1;
std::vector<CentreRow> scallop_rows(const BallSections& sections, const CutOptions& cut,
                                    const model::RunControl& control);

/// Height along the surface's normal of what stands between two neighbouring rows of a ball whose
/// centre keeps `reach_mm` from the surface; `middle` is the row half-way between them. At places
/// along the middle row: the point in which the ball there touches the surface, and how far it is
/// from both rows.
double cusp_between(const CentreRow& left, const CentreRow& middle, const CentreRow& right,
                    double reach_mm);

/// Of the tolerance: what leaving out points may move a row by, and what its centre may be moved by
/// afterwards.
struct RowShares {
  double reduction = kRowReductionShare, bow = 0;
};

/// Rows of a ball cutter: in each drive plane the upper envelope of the sections of the offset
/// surface and of what the ball rolls over at rims.
///
/// Error budget, in shares of the stage's tolerance t: twice a quarter for the offset mesh, a tenth
/// for the facets of rims (BallSections), twice a fifth for leaving out points (least_links). A
/// point of the path is within t / 5 of one of the envelope, whose mesh is within t / 4 of the
/// exact offset surface, and the distance from the part changes by no more than the way moved. The
/// centre keeps farther away by both: the ball never goes below the allowance surface, and what it
/// can reach it leaves by at most t more than its rows' distance does. Where the finish model is no
/// finer than t / 4 it leaves more, by what that lacks.
///
/// `shares`: what leaving out points may move a row by, another share than a fifth; and what the
/// centre may be moved by afterwards, which it keeps away from the surface too. `most_points`
/// bounds the memory of the sections (BallSections) and changes nothing of the rows.
DriveRows make_ball_rows(const surface::PatchModel& model, const StageRequest& request,
                         const model::RunControl& control, const RowShares& shares = {},
                         std::size_t most_points = kMostStripPoints);

}  // namespace limitgauge::engine::strategy
