#pragma once

#include <vector>

#include "engine/strategy/locations/cutter_locations.h"
#include "engine/strategy/stage_path.h"
#include "engine/surface/offset_model.h"

namespace limitgauge::engine::strategy {

/// Share of a stage's tolerance given to the chord error of the limit mesh that cutter locations
/// rest on. The mesh counts twice: it may lie below the surface by its error, so the cutter keeps
/// that much more distance, and above it by as much again.
inline constexpr double kLimitMeshShare = 0.25;

/// The limit mesh of a stage and its cutter location surface, which alone holds the mesh's grids.
struct LimitLocations {
  CutterLocations surface;
  surface::OffsetSampler
      sampler;         ///< makes the grids of the limit mesh again where they are needed
  model::Box3 part;    ///< of the mesh
  double kept_mm = 0;  ///< distance kept from the mesh: allowance and chord error
  /// No contact of the tip's rounding or flat asks for a lower tip: below it only shank, holder or
  /// the flank of a taper touch anything.
  double lowest_contact_mm = 0;
};

/// Samples the limit surface for the tolerance of `request` and keeps its cutter clear of it by the
/// allowance and whatever chord error the mesh really has. `model` must outlive what is returned.
LimitLocations limit_locations(const surface::PatchModel& model, const StageRequest& request);

}  // namespace limitgauge::engine::strategy
