#pragma once

#include <optional>
#include <span>

#include "model/base/run_control.h"
#include "verifier/cells/surface_cells.h"
#include "verifier/cutter/removed_space.h"
#include "verifier/gate/verify.h"

namespace limitgauge::verifier {

/// The second instrument (nominal → actual): rays along the normals of S into the simulated stock.
struct RayFigures {
  double gouge_mm = 0;          ///< longest run inwards through what was removed
  double uncut_mm = 0;          ///< longest run outwards through material, at reachable samples
  double largest_error_mm = 0;  ///< bound on the error of a run's end
  std::size_t rays = 0;
};

struct RayRequest {
  double allowance_mm = 0;
  /// Rays asked at most; of more samples every second one, every third and so on is.
  std::size_t most_rays = 30'000;
  /// What no run may be longer than, where it is known: `high` of the certified figures.
  std::optional<double> gouge_bound_mm, uncut_bound_mm;
};

/// What is asked for each ray. `raw` is the outside of the raw stock alone.
struct RayScene {
  const SurfaceCells& cells;
  const RemovedSpace& removed;
  const RemovedSpace& raw;
  const StockProbe& probe;
  double limit_mm = 0;  ///< no run is followed further
  /// Passes whose cuts are held against the certificate and are no gouge (StageCheck).
  std::span<const FinerPass> finer_passes = {};
};

/// From s + a·n: outwards where there is material, else inwards. Ends where S is crossed again.
struct RayReading {
  double uncut_mm = 0, gouge_mm = 0;
  double error_mm = 0;
};

/// One ray, at `point` of S with the unit normal `normal`. The analytic distance δ must have the
/// probe's sign all along the run, and be zero at its end: otherwise InstrumentDisagreement with
/// the place and both readings. Nothing is read where the raw stock does not cover s + a·n.
RayReading read_ray(const RayScene& scene, const model::Vec3& point, const model::Vec3& normal,
                    double allowance_mm);

/// Reads the samples of `field`. Uncut counts at reachable samples only, so that what stands over a
/// place out of reach is not charged to its neighbours; gouge only where S has one normal, since
/// the shortest over the normals of a crease, a corner or a rim counts there. Throws
/// InstrumentDisagreement as read_ray does, and where a run is longer than `request` allows.
RayFigures read_rays(const RayScene& scene, const DeviationField& field, const RayRequest& request,
                     const model::RunControl& control);

}  // namespace limitgauge::verifier
