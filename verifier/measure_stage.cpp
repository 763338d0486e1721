#include <algorithm>
#include <chrono>
#include <cmath>
#include <numbers>

#include "verifier/assembly.h"
#include "verifier/certificate.h"
#include "verifier/deviation_field.h"
#include "verifier/findings.h"
#include "verifier/reach_query.h"
#include "verifier/statistics.h"
#include "verifier/stock_readings.h"
#include "verifier/surface_tree.h"
#include "verifier/unavoidable.h"
#include "verifier/verify.h"

namespace limitgauge::verifier {
namespace {

/// Contact tolerance of reachability: a tenth of a micrometre, far below any gate.
constexpr double kContact_mm = 1e-4;

/// Width to which the unavoidable uncut is certified, where the verdict asks for no less.
constexpr double kUnavoidable_mm = 5e-3;

/// How finely the rim of what can be reached is resolved, and for how long. The contact of a flat
/// moves far as the normal turns, so its proofs take smaller cells. To a cutter as wide as the part
/// every cell is near every other, and of a drill's or an undercutting cutter's contacts no cell is
/// proven: then each is looked at once.
ReachOptions reach_effort(const CutterProfile& cutter, double area_mm2) {
  const double radius = cutter.rounding_mm + cutter.flat_mm;
  if (cutter.is_pointed() || cutter.undercuts()) return {0.05, 1};
  if (std::numbers::pi * radius * radius > area_mm2 / 2) return {0.05, 1};
  return {0.05, cutter.flat_mm > 0 ? std::size_t{250'000} : std::size_t{60'000}};
}

/// Where branch and bound starts: small enough that few moves matter to a cell, and no more than a
/// few hundred thousand cells on a large part.
double first_cell_radius_mm(const ReferenceSurface& surface) {
  constexpr double kSmall_mm = 0.3, kCells = 200'000;
  return std::max(kSmall_mm, std::sqrt(surface.area_mm2() / kCells));
}

CertificateRequest request_of(const StageCheck& check) {
  const double unlimited = std::numeric_limits<double>::infinity();
  return {check.allowance_mm, check.limits.has_gouge ? check.limits.gouge_mm : unlimited,
          check.limits.has_uncut ? check.limits.uncut_mm : unlimited, check.resolution_mm,
          check.largest_cell_count};
}

/// The deepest gouge of several bodies: the largest low, and the largest high.
void join_figures(StageDeviation& out, const Certificate& cutter,
                  const std::vector<BodySweep>& bodies) {
  out.gouge_mm = cutter.gouge_mm;
  out.uncut_mm = cutter.uncut_mm;
  out.cells = cutter.cells;
  out.reached_resolution = cutter.reached_resolution;
  out.bodies.push_back({0, "cutter", cutter.gouge_mm});
  for (const BodySweep& b : bodies) {
    const Certificate& c = b.certificate;
    out.gouge_mm.low = std::max(out.gouge_mm.low, c.gouge_mm.low);
    out.gouge_mm.high = std::max(out.gouge_mm.high, c.gouge_mm.high);
    out.cells += c.cells;
    out.reached_resolution = out.reached_resolution && c.reached_resolution;
    out.bodies.push_back({b.stage, b.body, c.gouge_mm});
  }
}

/// What findings are looked for in.
struct Measured {
  const SurfaceCells& cells;
  const RemovedSpace& space;
  const ReachQuery& reach;
  std::span<const Pass> passes;
  const StageCheck& check;
};

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

/// Findings on one side of one space; searched for only where something may exceed the threshold.
std::vector<Finding> findings_of(const Measured& m, const RemovedSpace& space, Side side,
                                 double threshold_mm, const Interval& figure,
                                 const std::optional<Witness>& witness, std::size_t first_stage,
                                 const std::string& body, bool& complete,
                                 const model::RunControl& control) {
  Exceedance found;
  if (figure.high > threshold_mm) {
    ExceedanceRequest request;
    request.side = side;
    request.allowance_mm = m.check.allowance_mm;
    request.threshold_mm = threshold_mm;
    request.slack_mm = m.check.resolution_mm;
    found = find_exceedance(m.cells, space, &m.reach, request, control);
  }
  complete = complete && found.complete;
  return gather_findings(found, witness, m.passes, first_stage, body);
}

void find_gouges(StageDeviation& out, const Measured& m, const Certificate& cutter,
                 const std::vector<BodySweep>& bodies, const model::RunControl& control) {
  const GateLimits& limits = m.check.limits;
  const double threshold = out.gouge_threshold_mm =
      finding_threshold_mm(limits.has_gouge, limits.gouge_mm, out.gouge_mm, m.check.resolution_mm);
  out.gouges = findings_of(m, m.space, Side::gouge, threshold, cutter.gouge_mm, cutter.gouge, 0,
                           "cutter", out.findings_complete, control);
  for (const BodySweep& b : bodies) {
    if (!b.space) continue;
    const auto more =
        findings_of(m, *b.space, Side::gouge, threshold, b.certificate.gouge_mm,
                    b.certificate.gouge, b.stage, b.body, out.findings_complete, control);
    out.gouges.insert(out.gouges.end(), more.begin(), more.end());
  }
  keep_deepest(out.gouges);
}

void find_leftovers(StageDeviation& out, const Measured& m, const Certificate& certificate,
                    const model::RunControl& control) {
  const GateLimits& limits = m.check.limits;
  out.uncut_threshold_mm =
      finding_threshold_mm(limits.has_uncut, limits.uncut_mm, out.uncut_mm, m.check.resolution_mm);
  out.uncuts = findings_of(m, m.space, Side::uncut, out.uncut_threshold_mm, certificate.uncut_mm,
                           certificate.uncut, 0, "cutter", out.findings_complete, control);
  keep_deepest(out.uncuts);
  name_passes(out.uncuts, m.space, m.passes, m.check.allowance_mm);
}

/// Certified with the positions that touch the reachable samples; it gates nothing.
Interval unavoidable_of(const SurfaceCells& cells, const ReachMap& proven,
                        const Reachability& search, const DeviationField& field,
                        const std::vector<model::Vec3>& tips, const model::Cutter& cutter,
                        const StageCheck& check, const model::RunControl& control) {
  std::vector<model::Vec3> free_tips;
  for (std::size_t i = 0; i < tips.size(); ++i)
    if (field.samples[i].reachable) free_tips.push_back(tips[i]);
  UnavoidableOptions options;
  options.resolution_mm = std::max(kUnavoidable_mm, check.resolution_mm);
  // No map says where these reach, so that all of S is open and every place has to be searched.
  if (search.profile().is_pointed() || search.profile().undercuts())
    options.largest_cell_count = 20'000, options.largest_point_count = 100,
    options.largest_square_count = 10'000;
  return unavoidable_uncut(cells, proven, search, free_tips, cutter, options, control).uncut_mm;
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
  const Reachability search(cells, cutter, check.allowance_mm, kContact_mm);
  const ReachMap proven =
      classify_reach(cells, search, reach_effort(cutter, surface.area_mm2()), control);
  const ReachQuery reach(search, proven);

  const CertificateRequest request = request_of(check);
  const Certificate certificate = certify(cells, space, &reach, request, control);
  const std::vector<BodySweep> bodies = certify_assemblies(cells, passes, request, control);
  StageDeviation out;
  out.resolution_mm = check.resolution_mm;
  join_figures(out, certificate, bodies);

  const VoxelFigures voxels =
      read_stock(cells, space, reach, certificate, readings, check, control);
  out.voxel_gouge_mm = voxels.gouge_mm;
  out.voxel_uncut_mm = voxels.uncut_mm;

  out.proven_reach = {proven.reachable_area_mm2(), proven.unreachable_area_mm2(),
                      proven.undecided_area_mm2()};
  out.field = sample_surface(surface, check.field_spacing_mm);
  const std::vector<model::Vec3> tips =
      measure_field(out.field, space, reach, passes, check.allowance_mm, control);
  out.unavoidable_uncut_mm =
      unavoidable_of(cells, proven, search, out.field, tips, passes.back().cutter, check, control);
  summarize_field(out, check.limits);

  const Measured measured{cells, space, reach, passes, check};
  find_gouges(out, measured, certificate, bodies, control);
  find_leftovers(out, measured, certificate, control);
  out.budget = budget_of(space, check, voxels);
  out.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  return out;
}

}  // namespace limitgauge::verifier
