#include "verifier/gate/stock_rays.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "model/base/chunks.h"
#include "verifier/cells/surface_crossing.h"
#include "verifier/tolerance.h"

namespace limitgauge::verifier {
namespace {

using model::Vec3;

/// Finer than a verdict shows them: two instruments are held against each other.
std::string fine_place_text(const Vec3& p) {
  char text[96];
  std::snprintf(text, sizeof text, "(%.4f, %.4f, %.4f)", p.x, p.y, p.z);
  return text;
}
std::string fine_length_text(double mm) {
  char text[64];
  std::snprintf(text, sizeof text, "%.6f mm", mm);
  return text;
}

[[noreturn]] void disagree(const Vec3& p, const std::string& what, double analytic_mm,
                           const std::string& voxel) {
  throw InstrumentDisagreement("the two instruments disagree at " + fine_place_text(p) + ": " +
                               what + ": analytic instrument " + fine_length_text(analytic_mm) +
                               ", voxel instrument " + voxel);
}

/// A run of the probe, and what the analytic instrument says along it.
struct CheckedRun {
  Vec3 from, along;
  double length_mm = 0;
  bool grazes = false;  ///< keeps to the cut surface itself, whose two sides are both there
};

/// The simulated stock is cut by the paths' own moves.
double agreement_of(const RemovedSpace& removed) {
  return kAgreement_mm + removed.from_moves_mm();
}

/// How much of a run is more than the chords of arcs are off: the end of one that goes along a wall
/// which an arc runs along is not.
double sure_mm(const RemovedSpace& removed, const CheckedRun& run, double side, FarPasses& far) {
  constexpr int kMostSteps = 200;
  const double unsure_mm = agreement_of(removed);
  const double least_step_mm = std::max(unsure_mm, run.length_mm / kMostSteps);
  double t = run.length_mm;
  while (t > 0) {
    const Nearest nearest = removed.nearest(run.from + run.along * t, {}, &far);
    const double sure = side * nearest.distance.value - unsure_mm;
    if (sure > 0) return std::min(run.length_mm, t + least_step_mm);
    t -= least_step_mm;
  }
  return 0;
}

/// A run that is no longer than the chords of arcs are off counts as it is.
CheckedRun surely(const RemovedSpace& removed, CheckedRun run, double side, FarPasses& far) {
  if (run.length_mm <= removed.from_moves_mm())
    run.grazes = false;
  else if (!run.grazes)
    run.length_mm = sure_mm(removed, run, side, far);
  return run;
}

/// δ > 0 in material. Half way, nearer to both ends, and at the end itself.
CheckedRun checked(const RemovedSpace& removed, const Vec3& from, const Vec3& along,
                   const StockProbe::Run& run, std::optional<BodyRef>& hint, FarPasses& far) {
  CheckedRun out{from, along, run.length_mm, false};
  const double side = run.material ? 1 : -1;
  const double agreement_mm = agreement_of(removed);
  // A short run has no room for more than its middle says.
  constexpr double kShort_mm = 0.02;
  constexpr double kParts[] = {0.5, 0.125, 0.875};
  const std::size_t parts = run.length_mm < kShort_mm ? 1 : std::size(kParts);
  for (std::size_t k = 0; k < parts; ++k) {
    const Vec3 p = from + along * (kParts[k] * run.length_mm);
    const Nearest nearest = removed.nearest(p, hint, &far);
    hint = nearest.body;
    const double delta = nearest.distance.value;
    if (side * delta < -agreement_mm)
      disagree(p, "distance from what was removed", delta,
               run.material ? "material" : "no material");
    if (k == 0) out.grazes = std::abs(delta) <= agreement_mm;
  }
  if (!run.ends) return out;
  const Vec3 end = from + along * run.length_mm;
  const Nearest nearest = removed.nearest(end, hint, &far);
  if (std::abs(nearest.distance.value) > run.error_mm + agreement_mm)
    disagree(end, "distance of the simulated stock's surface from the cut surface",
             nearest.distance.value, fine_length_text(run.error_mm));
  if (removed.from_moves_mm() > 0) out = surely(removed, out, side, far);
  return out;
}

/// How far the run stays in what the raw stock was: beyond, nothing was removed.
double within_raw_mm(const RemovedSpace& raw, const CheckedRun& run) {
  constexpr int kMostSteps = 200;
  double t = 0;
  for (int step = 0; step < kMostSteps && t < run.length_mm; ++step) {
    const double inside = raw.nearest(run.from + run.along * t).distance.value;
    if (inside < -kAgreement_mm) return t;
    t += std::max(inside, kAgreement_mm);
  }
  return std::min(t, run.length_mm);
}

/// Outwards from the allowance surface: no further than to the next crossing of S.
double outwards_mm(const RayScene& scene, const CheckedRun& run, const Vec3& point,
                   double allowance_mm) {
  if (run.grazes) return 0;
  return next_crossing_mm(scene.cells, point, run.along, Way::outwards, allowance_mm,
                          allowance_mm + run.length_mm) -
         allowance_mm;
}

/// Inwards: the crossing at the place itself is not the next one.
double inwards_mm(const RayScene& scene, const CheckedRun& run, const Vec3& point,
                  double allowance_mm) {
  if (run.grazes) return 0;
  const double length = within_raw_mm(scene.raw, run);
  if (length <= allowance_mm) return length;
  return allowance_mm +
         next_crossing_mm(scene.cells, point, -run.along, Way::inwards, 0, length - allowance_mm);
}

/// Whether the run ends at what a pass cut whose gouges do not count.
bool ends_at_finer(const RayScene& scene, const CheckedRun& run) {
  if (scene.finer_passes.empty()) return false;
  const auto body = scene.removed.nearest(run.from + run.along * run.length_mm).body;
  return std::ranges::any_of(scene.finer_passes,
                             [&](const FinerPass& finer) { return finer.pass == body.pass; });
}

/// The figure of all rays, with the place of the longest run.
struct Longest {
  double length_mm = 0;
  Vec3 at;
  void take(double mm, const Vec3& place) {
    if (mm > length_mm) length_mm = mm, at = place;
  }
};

void require_within(const Longest& run, const std::optional<double>& bound_mm, double error_mm,
                    const char* what) {
  if (bound_mm && run.length_mm > *bound_mm + error_mm + kAgreement_mm)
    disagree(run.at, what, *bound_mm, fine_length_text(run.length_mm));
}

/// A sample on the side of a patch where S has a crease, a corner or its rim.
bool has_many_normals(const SurfaceFeatures& features, const SurfacePlace& place) {
  const bool left = place.u <= 0, right = place.u >= 1, low = place.v <= 0, high = place.v >= 1;
  if (!left && !right && !low && !high) return false;
  const PatchFeatures& patch = features.of(place.patch);
  const auto sharp = [](SurfaceFeature f) {
    return f != SurfaceFeature::smooth && f != SurfaceFeature::extraordinary_vertex;
  };
  if ((low && sharp(patch.sides[0])) || (right && sharp(patch.sides[1])) ||
      (high && sharp(patch.sides[2])) || (left && sharp(patch.sides[3])))
    return true;
  const auto corner = [&](bool here, int k) {
    return here && (sharp(patch.corners[k]) || patch.open[k]);
  };
  return corner(left && low, 0) || corner(right && low, 1) || corner(right && high, 2) ||
         corner(left && high, 3);
}

RayReading reading_of(const RayScene& scene, const Vec3& point, const Vec3& normal,
                      double allowance_mm, std::optional<BodyRef>& hint, FarPasses& far) {
  const Vec3 start = point + normal * allowance_mm;
  if (scene.raw.nearest(start).distance.value < -kAgreement_mm) return {};
  // Most runs are short, and of the others the start's side decides on the way.
  constexpr double kLook_mm = 0.1;
  StockProbe::Run run = scene.probe.run(start, normal, std::min(kLook_mm, scene.limit_mm));
  if (run.material && !run.ends) run = scene.probe.run(start, normal, scene.limit_mm);
  if (run.material) {
    const CheckedRun way = checked(scene.removed, start, normal, run, hint, far);
    return {outwards_mm(scene, way, point, allowance_mm), 0, run.error_mm};
  }
  run = scene.probe.run(start, -normal, scene.limit_mm);
  if (run.material) return {};  // the start is on the cut surface, on either side of it
  const CheckedRun way = checked(scene.removed, start, -normal, run, hint, far);
  const double gouge = ends_at_finer(scene, way) ? 0 : inwards_mm(scene, way, point, allowance_mm);
  return {0, gouge, run.error_mm};
}

}  // namespace

RayReading read_ray(const RayScene& scene, const Vec3& point, const Vec3& normal,
                    double allowance_mm) {
  std::optional<BodyRef> hint;
  FarPasses far;
  return reading_of(scene, point, normal, allowance_mm, hint, far);
}

RayFigures read_rays(const RayScene& scene, const DeviationField& field, const RayRequest& request,
                     const model::RunControl& control) {
  const std::size_t most = std::max<std::size_t>(request.most_rays, 1);
  const std::size_t stride = std::max<std::size_t>((field.samples.size() + most - 1) / most, 1);
  RayFigures figures;
  figures.rays = (field.samples.size() + stride - 1) / stride;
  std::vector<RayReading> read(figures.rays);
  constexpr std::size_t kChunk = 256;
  model::parallel_chunks(read.size(), kChunk, control, [&](std::size_t begin, std::size_t end) {
    std::optional<BodyRef> hint;
    FarPasses far;
    for (std::size_t i = begin; i < end; ++i) {
      const DeviationField::Sample& s = field.samples[i * stride];
      read[i] = reading_of(scene, s.place.point, s.normal, request.allowance_mm, hint, far);
    }
  });
  Longest gouge, uncut;
  for (std::size_t i = 0; i < read.size(); ++i) {
    const DeviationField::Sample& s = field.samples[i * stride];
    figures.largest_error_mm = std::max(figures.largest_error_mm, read[i].error_mm);
    if (s.reachable) uncut.take(read[i].uncut_mm, s.place.point);
    if (!has_many_normals(scene.cells.features(), s.place))
      gouge.take(read[i].gouge_mm, s.place.point);
  }
  require_within(gouge, request.gouge_bound_mm, figures.largest_error_mm, "longest gouge");
  require_within(uncut, request.uncut_bound_mm, figures.largest_error_mm, "longest uncut");
  figures.gouge_mm = gouge.length_mm;
  figures.uncut_mm = uncut.length_mm;
  return figures;
}

}  // namespace limitgauge::verifier
