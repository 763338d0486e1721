#include <algorithm>
#include <utility>

#include "model/base/clock.h"
#include "model/base/memory.h"
#include "verifier/certificate/unavoidable.h"
#include "verifier/gate/findings.h"
#include "verifier/gate/finer_passes.h"
#include "verifier/gate/stage_pieces.h"
#include "verifier/gate/stage_scene.h"
#include "verifier/gate/stock_rays.h"
#include "verifier/gate/verify.h"
#include "verifier/reach/lowest_tip.h"
#include "verifier/reach/reach_entries.h"
#include "verifier/reach/reach_query.h"
#include "verifier/robust/tolerated_reach.h"
#include "verifier/robust/witness_rays.h"
#include "verifier/tolerance.h"

namespace limitgauge::verifier {
namespace {

/// What findings are looked for in.
struct Measured {
  const SurfaceCells& cells;
  const Spaces& spaces;
  const ReachQuery& reach;
  std::span<const Pass> passes;
  std::span<const AssemblySweep> parts;
  const StageCheck& check;
};

double finding_threshold_mm(bool limited, double limit_mm, const Interval& figure,
                            double resolution_mm) {
  return limited ? limit_mm : std::max(figure.low / 2, resolution_mm);
}

std::vector<UncertaintyTerm> budget_of(const RemovedSpace& space, const StageCheck& check,
                                       const StockProbe* probe, const RayFigures& rays) {
  std::vector<UncertaintyTerm> out{
      {"reference surface near irregular vertices", kOmitted_mm, true},
      {"rounding in double precision", kRounding_mm - kOmitted_mm, true},
      {"arcs stood for by chords", space.chord_error_mm(), true},
      {"width of the certified interval asked for", check.resolution_mm, true},
      {"contact tolerance of reachability", kContact_mm, true},
      {"faces along a normal that count as met by it", kBeside_mm, true},
      {"arcs stood for by wider chords in the simulated stock", probe ? space.from_moves_mm() : 0,
       false},
      {"rays into the stock: end of a run", rays.largest_error_mm, false},
      {"rays into the stock: between samples the certificate alone sees",
       probe ? check.field_spacing_mm : 0, false},
  };
  if (space.stock_blunt_mm() > 0)
    out.push_back({"edges of the stock, blunt by its voxels", space.stock_blunt_mm(), true});
  return out;
}

/// The second instrument, over the samples whose reach is known. No run is longer than the way
/// through S and the raw stock.
RayFigures ask_stock(const ReferenceSurface& surface, const model::Stock& raw_stock,
                     const RemovedSpace& raw, const Measured& m, const StockProbe* probe,
                     const DeviationField& field, const model::RunControl& control) {
  if (!probe) return {};
  model::Box3 box = model::bounding_box(raw_stock);
  box.add(surface.bounding_box());
  const RayScene scene{m.cells,
                       m.spaces.cut,
                       raw,
                       *probe,
                       length(box.size()) + m.check.allowance_mm,
                       m.check.finer_passes};
  RayRequest request;
  request.allowance_mm = m.check.allowance_mm;
  return read_rays(scene, field, request, control);
}

/// Cells of a group of them that are looked at for places beyond the threshold where none is known.
constexpr std::size_t kCellsOfDoubt = 2000;

/// Findings on one side of one space; searched for only where something may exceed the threshold.
std::vector<Finding> findings_of(const Measured& m, const RemovedSpace& space, Side side,
                                 double threshold_mm, const Certificate& certificate,
                                 bool& complete, const model::RunControl& control) {
  Exceedance found;
  if (certificate.figure_mm.high > threshold_mm) {
    ExceedanceRequest request;
    request.side = side;
    request.allowance_mm = m.check.allowance_mm;
    request.threshold_mm = threshold_mm;
    request.slack_mm = m.check.resolution_mm;
    // None is known where what is certified could not be narrowed: past a block that does not cover
    // the part, most often.
    if (!(certificate.figure_mm.low > threshold_mm)) request.largest_cell_count = kCellsOfDoubt;
    found = find_exceedance(m.cells, space, &m.reach, request, control);
  }
  complete = complete && found.complete;
  const bool of_stock = side == Side::missing_stock;
  std::vector<Finding> findings =
      gather_findings(found, certificate.witness, of_stock ? std::span<const Pass>{} : m.passes,
                      of_stock ? std::span<const AssemblySweep>{} : m.parts, space);
  keep_deepest(findings);
  return findings;
}

/// Certified figures of one stage.
struct Certificates {
  Certificate gouge, uncut, missing;
};

void find_places(StageDeviation& out, const Measured& m, const RemovedSpace& raw,
                 const Certificates& c, const model::RunControl& control) {
  const GateLimits& limits = m.check.limits;
  const double resolution = m.check.resolution_mm;
  out.gouge_threshold_mm =
      finding_threshold_mm(limits.has_gouge, limits.gouge_mm, out.gouge_mm, resolution);
  out.uncut_threshold_mm =
      finding_threshold_mm(limits.has_uncut, limits.uncut_mm, out.uncut_mm, resolution);
  const double missing =
      finding_threshold_mm(limits.has_gouge, limits.gouge_mm, out.missing_stock_mm, resolution);
  bool& complete = out.findings_complete;
  out.gouges = findings_of(m, m.spaces.swept, Side::gouge, out.gouge_threshold_mm, c.gouge,
                           complete, control);
  out.uncuts =
      findings_of(m, m.spaces.cut, Side::uncut, out.uncut_threshold_mm, c.uncut, complete, control);
  out.missing_stock =
      findings_of(m, raw, Side::missing_stock, missing, c.missing, complete, control);
  name_passes(out.uncuts, m.spaces.cut, m.passes);
}

/// Gouge by flutes and by each stage's shank and holder for themselves, where these come near.
void measure_bodies(StageDeviation& out, const Measured& m, const Certificate& all,
                    const CertificateRequest& request, const model::RunControl& control) {
  if (m.parts.empty()) {
    out.bodies.push_back({0, "cutter", all.figure_mm});
    return;
  }
  const auto figure = [&](const RemovedSpace& space) {
    return certify(m.cells, space, Side::gouge, nullptr, request, control).figure_mm;
  };
  out.bodies.push_back({0, "cutter", figure(m.spaces.fluted)});
  for (std::size_t stage = 0; stage < m.passes.size(); ++stage) {
    std::vector<Sweep> sweeps;
    std::string name;
    for (const AssemblySweep& part : m.parts) {
      if (part.stage != stage) continue;
      sweeps.push_back(part.sweep);
      if (name.find(part.body) == std::string::npos)
        name += (name.empty() ? "" : " and ") + part.body;
    }
    if (!sweeps.empty()) out.bodies.push_back({stage, name, figure(RemovedSpace(sweeps))});
  }
}

/// Of one cutter, with the positions that touch reachable samples.
Unavoidable unavoidable_of(const Measured& m, const ReachMap& proven, const ReachOfCutters& by,
                           std::size_t k, const DeviationField& field,
                           const std::vector<ReachQuery::Touch>& touches,
                           const model::RunControl& control) {
  std::vector<model::Vec3> free_tips;
  for (std::size_t i = 0; i < touches.size(); ++i)
    if (field.samples[i].reachable && touches[i].cutter == k) free_tips.push_back(touches[i].tip);
  UnavoidableOptions options;
  options.resolution_mm = std::max(kUnavoidable_mm, m.check.resolution_mm);
  // No map says where these reach, so that all of S is open and every place has to be searched.
  const CutterProfile& profile = by.searches[k].profile();
  if (profile.is_pointed() || profile.undercuts())
    options.largest_cell_count = 20'000, options.largest_point_count = 100,
    options.largest_square_count = 10'000;
  const Reachability& search = by.searches[k];
  Unavoidable found = unavoidable_uncut(search.cells(), proven, search, free_tips, by.cutters[k],
                                        options, control, k);
  if (found.place) found.place->point = search.to_own().point_back(found.place->point);
  return found;
}

/// The worst place's best cutter: no more than the least `high`, and no less than what every cutter
/// is proven to leave at one place.
Interval unavoidable_of_all(const Measured& m, const ReachMap& proven, const ReachOfCutters& by,
                            const DeviationField& field,
                            const std::vector<ReachQuery::Touch>& touches,
                            const model::RunControl& control) {
  Unavoidable best;
  std::size_t of = 0;
  for (std::size_t k = 0; k < by.searches.size(); ++k) {
    Unavoidable u = unavoidable_of(m, proven, by, k, field, touches, control);
    if (k == 0 || u.uncut_mm.high < best.uncut_mm.high) best = std::move(u), of = k;
    // Nobody asks by which cutter less than the width is left.
    if (best.uncut_mm.high <= 2 * std::max(kUnavoidable_mm, m.check.resolution_mm)) break;
  }
  // In a way that is not looked at a cutter may leave less.
  for (const Reachability& search : by.searches)
    if (search.is_among_others()) best.uncut_mm.low = 0;
  if (!best.place) return best.uncut_mm;
  const double a = m.check.allowance_mm;
  for (std::size_t k = 0; k < by.searches.size() && best.uncut_mm.low > 0; ++k) {
    if (k == of) continue;
    constexpr std::size_t kSquares = 20'000;
    const double goal = a + best.uncut_mm.low;
    const Reachability& search = by.searches[k];
    const model::Vec3 point = search.to_own().point(best.place->point);
    const double low = LowestTip(search.cells(), search).prove(point, goal, kSquares).low_mm - a;
    best.uncut_mm.low = std::clamp(low, 0.0, best.uncut_mm.low);
  }
  return best.uncut_mm;
}

}  // namespace

namespace {

/// Seconds since it was asked last.
class Laps {
 public:
  double lap() {
    const double before = std::exchange(at_, watch_.seconds());
    return at_ - before;
  }

 private:
  model::Stopwatch watch_;
  double at_ = 0;
};

}  // namespace

StageDeviation measure_stage(const ReferenceSurface& surface, const model::Stock& raw_stock,
                             std::span<const Pass> passes, const StockProbe* probe,
                             const StageCheck& check, const model::RunControl& control,
                             PieceWorkers* workers) {
  if (passes.empty()) throw std::invalid_argument("a stage needs the pass it is measured for");
  if (!(check.resolution_mm > 0)) throw std::invalid_argument("the resolution must be positive");
  const auto turns = [](const Pass& pass) { return pass.axes != nullptr; };
  if (check.tolerances && std::any_of(passes.begin(), passes.end(), turns))
    throw std::invalid_argument("no figures over tolerances where a pass turns its tool");
  const model::Stopwatch watch;
  const StageScene scene(surface, raw_stock, passes, check);
  const Spaces spaces = scene.spaces();
  StageDeviation out;
  Laps laps;
  PieceRound first(workers), second(workers);
  if (workers)
    first.ask({StagePiece::Kind::reach, StagePiece::Kind::gouge, StagePiece::Kind::missing_stock},
              {});
  const ReachMap proven =
      workers ? gathered_reach(scene, first.all(StagePiece::Kind::reach), control)
              : classify_reach(scene.cells, scene.by.searches, scene.by.efforts, control);
  model::return_freed_memory();
  const ReachQuery reach(scene.by.searches, proven);
  const Measured measured{scene.cells, spaces, reach, passes, scene.parts, check};
  out.phases.reach_s = laps.lap();

  if (workers)
    second.ask({StagePiece::Kind::field, StagePiece::Kind::uncut},
               entries_to_bytes(proven.entries()));
  const auto of_round = [](PieceRound& round, StagePiece::Kind kind) {
    return certificate_of_bytes(round.all(kind).front());
  };
  Certificates certificates;
  certificates.missing =
      workers ? of_round(first, StagePiece::Kind::missing_stock) : missing_stock_of(scene, control);
  certificates.gouge = workers ? of_round(first, StagePiece::Kind::gouge)
                               : gouge_of(scene, certificates.missing, control);
  certificates.uncut =
      workers ? of_round(second, StagePiece::Kind::uncut) : uncut_of(scene, reach, control);
  const std::vector<Finding> below =
      gouge_below_finer({scene.cells, passes, scene.parts, raw_stock, scene.request},
                        check.finer_passes, certificates.gouge, control);
  out.resolution_mm = check.resolution_mm;
  out.gouge_mm = certificates.gouge.figure_mm;
  out.uncut_mm = certificates.uncut.figure_mm;
  out.stock_blunt_mm = scene.cut.stock_blunt_mm();
  out.missing_stock_mm = certificates.missing.figure_mm;
  out.cells = certificates.gouge.cells + certificates.uncut.cells + certificates.missing.cells;
  out.reached_resolution =
      certificates.gouge.reached_resolution && certificates.uncut.reached_resolution;
  measure_bodies(out, measured, certificates.gouge, scene.request, control);
  out.phases.certificate_s = laps.lap();

  out.proven_reach = {proven.reachable_area_mm2(), proven.unreachable_area_mm2(),
                      proven.undecided_area_mm2(), reach.any_is_mapped(),
                      !reach.may_prove_unreachable() && proven.unreachable_area_mm2() == 0};
  out.field = sample_surface(surface, check.field_spacing_mm);
  const std::vector<ReachQuery::Touch> touches =
      workers ? gathered_field(out.field, second.all(StagePiece::Kind::field), passes)
              : measure_field(out.field, scene.cells, spaces, reach, passes, check.allowance_mm,
                              control);
  out.missing_allowance =
      missing_allowance(out.field, scene.cells, scene.raw, check.allowance_mm, control);
  out.phases.field_s = laps.lap();
  out.unavoidable_uncut_mm =
      unavoidable_of_all(measured, proven, scene.by, out.field, touches, control);
  summarize_field(out, check.limits);
  out.phases.unavoidable_s = laps.lap();

  const RayFigures rays =
      ask_stock(surface, raw_stock, scene.raw, measured, probe, out.field, control);
  out.voxel_gouge_mm = rays.gouge_mm;
  out.voxel_uncut_mm = rays.uncut_mm;
  out.phases.rays_s = laps.lap();

  find_places(out, measured, scene.raw, certificates, control);
  out.gouges.insert(out.gouges.end(), below.begin(), below.end());
  keep_deepest(out.gouges);
  out.phases.findings_s = laps.lap();
  if (check.tolerances) {
    const ToleratedReach tolerated(scene, *check.tolerances, passes, check, surface.area_mm2(),
                                   reach, control);
    const RobustScene robust{scene.cells,
                             scene.raw,
                             passes,
                             check,
                             scene.request,
                             scene.highest_mm,
                             tolerated.of_any(),
                             tolerated.of_extreme()};
    out.robust = robust_deviation(robust, out, control);
    if (probe) read_witnesses(*out.robust, robust, raw_stock, *probe, control);
  }
  out.budget = budget_of(scene.cut, check, probe, rays);
  out.seconds = watch.seconds();
  return out;
}

}  // namespace limitgauge::verifier
