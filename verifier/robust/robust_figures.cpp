#include "verifier/robust/robust_figures.h"

#include <algorithm>
#include <limits>
#include <stdexcept>

#include "model/base/clock.h"
#include "verifier/robust/tolerance_margin.h"
#include "verifier/tolerance.h"

namespace limitgauge::verifier {
namespace {

/// Step of a value when it is asked how a run changes with it, mm: far above what runs are found
/// to, far below what bends them.
constexpr double kStep_mm = 1e-3;
/// Beyond all passes: the raw stock.
constexpr std::uint32_t kNoPass = std::numeric_limits<std::uint32_t>::max();

ToleranceBox grown_box(const RobustScene& scene, double factor) {
  return {model::scaled(*scene.check.tolerances, factor), scene.passes};
}

/// A figure and the values that its witness has.
struct Found {
  Certificate certificate;
  std::optional<ToleranceValues> values;
};

/// The common values at which the box's draws have a witness.
ToleranceValues values_at(const ToleranceBox& box, Side side, const Witness& witness) {
  return box.off_path(box.shifted(side, witness.shift_x, witness.shift_y),
                      off_path(side, witness.normal, box.path_mm()));
}

/// A leftover's `high` leaves out what no cutter of the box can touch; its witness, which has the
/// values that leave most, what the cutter of these cannot.
Certificate certified(const RobustScene& scene, Side side, const ToleranceBox& box,
                      const CertificateRequest& request, const model::RunControl& control) {
  const ToleratedSpaces spaces(box, scene.raw, side, scene.highest_mm);
  const auto within = [&](const ReachQuery* reach) {
    return certify(scene.cells, spaces.whole, side, reach, request, control, &spaces.draws);
  };
  if (side != Side::uncut) return within(nullptr);
  Certificate out = within(scene.reach_of_any);
  if (scene.reach_of_any == scene.reach_of_extreme || !(out.figure_mm.low > 0)) return out;
  const Certificate extreme = within(scene.reach_of_extreme);
  out.figure_mm.low = std::min(extreme.figure_mm.low, out.figure_mm.high);
  out.witness = extreme.witness;
  return out;
}

Found find(const RobustScene& scene, Side side, const ToleranceBox& box,
           const model::RunControl& control) {
  Found out{certified(scene, side, box, scene.request, control), {}};
  if (const auto& w = out.certificate.witness; w && out.certificate.figure_mm.low > 0)
    out.values = values_at(box, side, *w);
  return out;
}

/// The run at a place, at one set of values.
double run_at(const RobustScene& scene, Side side, const ToleranceBox& box,
              const ToleranceValues& values, const Witness& witness) {
  const RemovedSpace space =
      scene.raw.with(box.sweeps_at(values, side, scene.highest_mm)).shifted(box.shift_at(values));
  RunBounds bounds(scene.cells, space, side, scene.request.allowance_mm);
  return bounds.run(witness.place.point, witness.normal).length_mm;
}

/// How the run at the witness changes with each value, by a step into its range.
std::vector<NamedLength> sensitivities(const RobustScene& scene, Side side, const ToleranceBox& box,
                                       const Found& found) {
  std::vector<NamedLength> out;
  const Witness& witness = *found.certificate.witness;
  const double whole = run_at(scene, side, box, *found.values, witness);
  for (std::size_t k = 0; k < box.tolerances().size(); ++k) {
    const Tolerance& t = box.tolerances()[k];
    ToleranceValues beside = *found.values;
    const double step = t.range_mm.width() > 0 ? std::min(kStep_mm, t.range_mm.width()) : kStep_mm;
    beside[k] += beside[k] > (t.range_mm.low + t.range_mm.high) / 2 ? -step : step;
    const double moved = beside[k] - (*found.values)[k];
    out.push_back({t.name(), (run_at(scene, side, box, beside, witness) - whole) / moved + 0.0});
  }
  return out;
}

BoxTrial trial_of(const RobustScene& scene, Side side, double limit_mm, double factor,
                  const model::RunControl& control) {
  CertificateRequest request = scene.request;
  request.decides_only = true;
  const Certificate found = certified(scene, side, grown_box(scene, factor), request, control);
  if (found.figure_mm.high <= limit_mm) return {BoxTrial::Is::within, {}};
  if (!found.witness || found.figure_mm.low <= limit_mm) return {BoxTrial::Is::undecided, {}};
  return {BoxTrial::Is::beyond, [&scene, side, witness = *found.witness](double by) {
            const ToleranceBox box = grown_box(scene, by);
            return run_at(scene, side, box, values_at(box, side, witness), witness) - kRounding_mm;
          }};
}

ToleranceMargin margin_of(const RobustScene& scene, Side side, const Interval& nominal,
                          const Interval& whole, double limit_mm,
                          const model::RunControl& control) {
  return find_margin(nominal, whole, limit_mm, [&](double factor) -> std::optional<BoxTrial> {
    try {
      return trial_of(scene, side, limit_mm, factor, control);
    } catch (const std::invalid_argument&) {
      return std::nullopt;
    }
  });
}

/// The move that swept the place, or that is nearest to it.
void name_move(const RobustScene& scene, const ToleranceBox& box, const BodyRef& body,
               RobustFigure& out) {
  const std::vector<AssemblySweep> parts = box.parts(scene.highest_mm);
  const std::size_t passes = scene.passes.size();
  out.raw_stock = body.pass >= passes + parts.size();
  if (out.raw_stock) return;
  out.stage = body.pass < passes ? body.pass : parts[body.pass - passes].stage;
  if (body.pass >= passes) out.body = parts[body.pass - passes].body;
  out.move = ChordPieces(*scene.passes[out.stage].path).move_of(body.index);
  out.line = scene.passes[out.stage].path->moves[out.move].line;
}

}  // namespace

RobustFigure robust_figure(const RobustScene& scene, Side side, const model::Tolerances& tolerances,
                           const model::RunControl& control) {
  const ToleranceBox box(tolerances, scene.passes);
  const Found found = find(scene, side, box, control);
  RobustFigure out;
  out.figure_mm = found.certificate.figure_mm;
  out.reached_resolution = found.certificate.reached_resolution;
  out.cells = found.certificate.cells;
  if (!found.values) return out;
  out.place = found.certificate.witness->place;
  out.normal = found.certificate.witness->normal;
  BodyRef body = found.certificate.witness->body;
  // Of what is left no part of a shank is held.
  if (side == Side::uncut && body.pass >= scene.passes.size()) body.pass = kNoPass;
  name_move(scene, box, body, out);
  for (std::size_t k = 0; k < box.tolerances().size(); ++k)
    out.at.push_back({box.tolerances()[k].name(), (*found.values)[k]});
  out.sensitivity = sensitivities(scene, side, box, found);
  return out;
}

RobustDeviation robust_deviation(const RobustScene& scene, const StageDeviation& nominal,
                                 const model::RunControl& control) {
  const model::Stopwatch watch;
  const GateLimits& limits = scene.check.limits;
  const auto figure = [&](Side side, const Interval& stated, bool limited, double limit_mm) {
    RobustFigure out = robust_figure(scene, side, *scene.check.tolerances, control);
    if (limited && scene.check.finds_margin)
      out.margin = margin_of(scene, side, stated, out.figure_mm, limit_mm, control);
    return out;
  };
  RobustDeviation out;
  out.gouge = figure(Side::gouge, nominal.gouge_mm, limits.has_gouge, limits.gouge_mm);
  out.uncut = figure(Side::uncut, nominal.uncut_mm, limits.has_uncut, limits.uncut_mm);
  out.seconds = watch.seconds();
  return out;
}

}  // namespace limitgauge::verifier
