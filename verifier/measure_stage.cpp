#include <algorithm>
#include <chrono>
#include <cmath>

#include "verifier/certificate.h"
#include "verifier/deviation_field.h"
#include "verifier/findings.h"
#include "verifier/statistics.h"
#include "verifier/stock_readings.h"
#include "verifier/surface_tree.h"
#include "verifier/verify.h"

namespace limitgauge::verifier {
namespace {

/// Contact tolerance of reachability, for the certificate and for the sampled field: a tenth of a
/// micrometre where a verdict hangs on it, a micrometre for maps and areas.
constexpr double kContact_mm = 1e-4, kMapContact_mm = 1e-3;

/// Where branch and bound starts: small enough that few moves matter to a cell, and no more than a
/// few hundred thousand cells on a large part.
double first_cell_radius_mm(const ReferenceSurface& surface) {
  constexpr double kSmall_mm = 0.3, kCells = 200'000;
  return std::max(kSmall_mm, std::sqrt(surface.area_mm2() / kCells));
}

double finding_threshold_mm(bool limited, double limit_mm, const Interval& figure,
                            double resolution_mm) {
  return limited ? limit_mm : std::max(figure.low / 2, resolution_mm);
}

std::vector<UncertaintyTerm> budget_of(const RemovedSpace& space, const StageCheck& check,
                                       const VoxelFigures& voxels) {
  return {
      {"reference surface near irregular vertices", SurfaceCells::kOmitted_mm, true},
      {"rounding in double precision", kRounding_mm - SurfaceCells::kOmitted_mm, true},
      {"arcs stood for by chords", space.chord_error_mm(), true},
      {"width of the certified interval asked for", check.resolution_mm, true},
      {"contact tolerance of reachability", kContact_mm, true},
      {"stock points: residual after projection onto the swept surface", voxels.largest_error_mm,
       false},
      {"stock points: spacing, finer features are seen by the certificate only", check.voxel_mm,
       false},
  };
}

}  // namespace

StageDeviation measure_stage(const ReferenceSurface& surface, const model::Stock& raw_stock,
                             std::span<const Pass> passes, std::span<const StockReading> readings,
                             const StageCheck& check, const model::RunControl& control) {
  if (passes.empty()) throw std::invalid_argument("a stage needs the pass it is measured for");
  if (!(check.resolution_mm > 0)) throw std::invalid_argument("the resolution must be positive");
  const auto start = std::chrono::steady_clock::now();
  const SurfaceCells cells(surface.tree(), first_cell_radius_mm(surface));
  const RemovedSpace space(raw_stock, passes);
  const CutterProfile cutter(passes.back().cutter);
  const Reachability reachability(cells, cutter, check.allowance_mm, kContact_mm);
  const Reachability for_maps(cells, cutter, check.allowance_mm, kMapContact_mm);

  const double unlimited = std::numeric_limits<double>::infinity();
  const Certificate certificate =
      certify(cells, space, reachability,
              {check.allowance_mm, check.limits.has_gouge ? check.limits.gouge_mm : unlimited,
               check.limits.has_uncut ? check.limits.uncut_mm : unlimited, check.resolution_mm,
               check.largest_cell_count},
              control);
  StageDeviation out;
  out.gouge_mm = certificate.gouge_mm;
  out.uncut_mm = certificate.uncut_mm;
  out.cells = certificate.cells;
  out.reached_resolution = certificate.reached_resolution;
  out.resolution_mm = check.resolution_mm;

  const VoxelFigures voxels =
      read_stock(cells, space, reachability, certificate, readings, check, control);
  out.voxel_gouge_mm = voxels.gouge_mm;
  out.voxel_uncut_mm = voxels.uncut_mm;

  out.field = sample_surface(surface, check.field_spacing_mm);
  const std::vector<model::Vec3> tips =
      measure_field(out.field, space, for_maps, passes, check.allowance_mm, control);
  out.unavoidable_uncut_mm =
      unavoidable_uncut_mm(out.field, tips, passes.back().cutter, check.allowance_mm, control);
  summarize_field(out, check.limits);

  const GateLimits& limits = check.limits;
  out.gouges = find_clusters(
      out.field, Side::gouge,
      finding_threshold_mm(limits.has_gouge, limits.gouge_mm, out.gouge_mm, check.resolution_mm),
      certificate.gouge, passes, check.field_spacing_mm);
  out.uncuts = find_clusters(
      out.field, Side::uncut,
      finding_threshold_mm(limits.has_uncut, limits.uncut_mm, out.uncut_mm, check.resolution_mm),
      certificate.uncut, passes, check.field_spacing_mm);
  out.budget = budget_of(space, check, voxels);
  out.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  return out;
}

}  // namespace limitgauge::verifier
