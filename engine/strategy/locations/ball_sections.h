#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <span>
#include <vector>

#include "engine/strategy/locations/envelope.h"
#include "engine/strategy/rows/drive_rows.h"
#include "engine/strategy/stage_path.h"
#include "engine/surface/patch_model.h"
#include "engine/surface/section/section_strips.h"
#include "model/base/run_control.h"

namespace limitgauge::engine::strategy {

/// Share of a stage's tolerance by which leaving out points may move a row.
inline constexpr double kRowReductionShare = 0.2;
/// Points of the grids that are held at a time while rows are cut: 24 bytes each, so 13 MB, as much
/// as the finish model of a plate of 10,000 faces. Parts within it are sampled once; a grid of
/// others is made twice, whatever the bound, and smaller strips give threads less to do at a time.
inline constexpr std::size_t kMostStripPoints = std::size_t{1} << 19;

/// All that a ball's centre must stay above, ready to be cut by drive planes: the surface moved out
/// by the ball's radius and the allowance, and what the ball rolls over at rims.
///
/// The centre keeps farther away by what the offset mesh may lack (a quarter of the stage's
/// tolerance, or more where the model is no finer) and by what leaving out points of rows may take
/// (`reduction_mm`): nothing of that cuts into the surface. Facets of rims lie outside what they
/// stand for, by a tenth of the tolerance at most.
///
/// Grids are made strip by strip, `most_points` at a time or as many as one plane needs; where all
/// have no more they are made once and stay (surface::SectionStrips). Paths do not depend on it.
class BallSections {
 public:
  /// `model` must outlive this.
  BallSections(const surface::PatchModel& model, const StageRequest& request,
               const DriveFrame& frame, double reduction_mm, const model::RunControl& control,
               std::size_t most_points = kMostStripPoints);

  double reach_mm() const { return reach_; }  ///< of the centre from the surface
  /// Extent of the surface across the rows.
  double low_mm() const { return low_; }
  double high_mm() const { return high_; }
  const std::vector<int>& sampling_intervals() const { return intervals_; }

  /// Takes the path of plane number `plane`. Called once a plane, from any thread.
  using Take = std::function<void(std::size_t plane, Envelope envelope)>;
  /// The gouge-free paths of the centre in the planes at `across_mm` (ascending), one by one, so
  /// that few are held at a time: s is the place along the row. Returns the most points of grids
  /// that were held at a time.
  std::size_t each_envelope(std::span<const double> across_mm, const model::RunControl& control,
                            const Take& take) const;
  /// All of them.
  std::vector<Envelope> envelopes(std::span<const double> across_mm,
                                  const model::RunControl& control) const;
  /// How planes at `across_mm` are dealt with.
  std::vector<surface::SectionStrips::Strip> strips(std::span<const double> across_mm) const {
    return sections_->strips(across_mm);
  }

 private:
  void measure(const surface::PatchModel& model, const DriveFrame& frame);

  double reach_, low_ = 0, high_ = 0;
  std::vector<int> intervals_;
  std::optional<surface::SectionStrips> sections_;
};

}  // namespace limitgauge::engine::strategy
