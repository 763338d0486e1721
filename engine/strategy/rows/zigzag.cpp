#include "engine/strategy/rows/zigzag.h"

#include <algorithm>
#include <utility>

#include "engine/strategy/axes/leaning_axis.h"
#include "engine/strategy/axes/leaning_path.h"
#include "engine/strategy/linking/cut_pass.h"
#include "engine/strategy/rows/ball_rows.h"
#include "engine/strategy/rows/boundary_pass.h"
#include "engine/strategy/rows/sampled_rows.h"

namespace limitgauge::engine::strategy {
namespace {

/// Rows that lean take half of what leaving out points may else, for what the centre is off its way
/// while the axis turns: half of that in lean_path(), half at the control.
constexpr RowShares kLeaningShares = {0.1, 2 * kBowShare};
static_assert(kLeaningShares.reduction + kLeaningShares.bow <= kRowReductionShare);

/// All rows as one group, cut in any order; one-way rows that are to be climb or conventional
/// milled as a group each: what is still to be cut then lies on the right of each row, or on its
/// left.
std::vector<std::vector<CutPass>> row_groups(std::vector<DriveRow> rows,
                                             const StageRequest& request) {
  const bool sided =
      request.cut.pattern == RowPattern::one_way && request.cut.direction != CutDirection::either;
  if (sided && request.cut.direction == CutDirection::climb) std::reverse(rows.begin(), rows.end());
  std::vector<std::vector<CutPass>> groups(1);
  for (DriveRow& row : rows) {
    if (sided && !groups.back().empty()) groups.emplace_back();
    for (auto& run : row.runs) groups.back().push_back(row_pass(std::move(run), request));
  }
  return groups;
}

/// The places of rows that have some of the part under `narrow`.
void keep_over(const CutterLocations& narrow, DriveRow& row) {
  std::vector<std::vector<model::Vec3>> kept;
  for (const auto& run : row.runs) {
    kept.emplace_back();
    for (const model::Vec3& tip : run) {
      if (narrow.tip_z(tip.x, tip.y)) {
        kept.back().push_back(tip);
      } else if (!kept.back().empty()) {
        kept.emplace_back();
      }
    }
  }
  std::erase_if(kept, [](const auto& run) { return run.size() < 2; });
  row.runs = std::move(kept);
}

/// A ball that has rolled over a rim until its contact's normal is square to its axis would cut the
/// rim by its flutes: rows end where that may be.
void end_at_rims(const LimitLocations& limit, const StageRequest& request, DriveRows& rows) {
  const model::Vec3 axis = leaning_axis({0, 0, 1}, {1, 0, 0}, 1, *request.cut.lean);
  model::Cutter narrow = request.cutter;
  narrow.diameter_mm *= axis.z;
  narrow.corner_radius_mm *= axis.z;
  narrow.flute_length_mm = std::max(narrow.flute_length_mm, narrow.diameter_mm);
  narrow.shank.clear(), narrow.holder.clear();
  const CutterLocations under(surface::pieces(limit.sampler, 0), narrow, 0);
  for (DriveRow& row : rows.rows) keep_over(under, row);
}

}  // namespace

StagePath plan_zigzag(const surface::FinishModel& model, const StageRequest& request,
                      const model::RunControl& control) {
  const bool ball = request.cutter.type == model::CutterType::ball;
  const RowShares shares = request.cut.lean ? kLeaningShares : RowShares();
  DriveRows made;
  // Before there are cutter locations, which rows of a ball do not need: both take memory.
  if (ball) made = make_ball_rows(model.patches(), request, control, shares);
  const LimitLocations limit = limit_locations(model.patches(), request);
  if (!ball) made = make_sampled_rows(limit, request, control);
  if (request.cut.lean) end_at_rims(limit, request, made);
  StagePath stage;
  stage.planes = static_cast<int>(made.rows.size());
  set_intervals(stage, std::move(made.sampling_intervals));
  std::vector<std::vector<CutPass>> groups = row_groups(std::move(made.rows), request);
  if (request.cut.boundary_pass) groups.push_back(boundary_passes(limit, request, control));
  stage.path = link_passes(groups, limit.surface, request, control);
  return stage;
}

}  // namespace limitgauge::engine::strategy
