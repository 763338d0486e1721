#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "app/job/job.h"
#include "model/geometry/vec3.h"

namespace limitgauge::app {

/// The figures that a job may leave to the program, as they were chosen for one run.
struct Settings {
  double voxel_mm = 0;
  /// A stage: widest certified interval asked for; of none where there is no design.
  std::vector<double> resolution_mm;
  std::vector<double> chord_error_mm;  ///< a stage: of a program's arcs as chords
  std::vector<double> floor_z_mm;      ///< a stage: lowest tip height; NaN for a program
  double contact_tolerance_mm = 0;     ///< contacts shallower than this are none
  double line_spacing_mm = 0;          ///< of the lines that removal is followed on
  std::size_t memory_limit_bytes = 0;  ///< that the run may take at its peak
  std::size_t stock_limit_bytes = 0;   ///< that the stock model may take of it, with its moves
};

/// Voxel "auto": ten times the tightest gouge or uncut limit of the job, kept within 0.05 and
/// 0.25 mm; 0.1 mm where nothing is limited. The certified intervals do not depend on it. Without a
/// design a fortieth of the smallest cutter's diameter, within 0.05 and 0.5 mm. In either case no
/// finer than five million voxels cover the surface of the stock.
double automatic_voxel_mm(const Job& job);
/// Floor of a stage that states none: the lowest point of the surface less the cutter's corner
/// radius, so that a ball can roll over the lowest edge down to its equator.
double automatic_floor_mm(const model::Cutter& cutter, const model::Box3& surface);
/// Largest distance between an arc of a program and its chords: a quarter of what the stage's
/// certified interval may be wide.
double chord_error_mm(double resolution_mm);

/// What must stand above the allowance surface for a rest stage to cut there: half of the stage's
/// uncut limit where it has one, else its tolerance.
double rest_threshold_mm(const JobStage& stage);

/// Stages before this one, of other setups, that had less to leave than it and whose own gate
/// limited gouge by that: what they took is no gouge of this stage.
std::vector<std::size_t> finer_stages(const Job& job, std::size_t index);

/// Within what near misses are looked for: as stated, and no less than tolerances may move a tool.
double near_miss_mm(const Job& job);

/// `memory_limit_bytes` is model::memory_limit_bytes() as it was when the run began: what the run
/// may take at its peak.
Settings choose_settings(const Job& job, const model::Box3& surface,
                         std::size_t memory_limit_bytes);
/// Every figure that the job did not state, and every convention, in words for the report.
std::vector<std::string> assumptions(const Job& job, const Settings& settings);

}  // namespace limitgauge::app
