#include "app/cut_stock.h"

#include <algorithm>
#include <cmath>
#include <sstream>

#include "simulator/dexel_agreement.h"
#include "simulator/process_check.h"

namespace limitgauge::app {
namespace {

/// Lines on which the two stock models are compared after each stage.
constexpr std::size_t kComparedLines = 4000;

/// What the shape that is left does not show: collisions and the like, and what each move took.
void follow_process(const Job& job, const RunInputs& inputs, const JobStage& asked,
                    const simulator::Pass& pass, CutStock& stock, const StageWatch& watch,
                    reports::StageResult::Ran& ran) {
  simulator::ProcessLimits limits;
  limits.tolerance_mm = inputs.settings.contact_tolerance_mm;
  limits.near_miss_mm = job.near_miss_mm;
  limits.travel_mm = job.travel_mm;
  limits.fixtures = inputs.fixtures;
  ran.process = check_process(stock.stock, pass, limits,
                              watch.control(asked.name + ": checking the process"));
  simulator::DexelStock::Cut after =
      stock.lines.cut(pass, watch.control(asked.name + ": following the removal"));
  stock.lines = std::move(after.stock);
  ran.removal = std::move(after.removal);
}

void say_forecast(const JobStage& asked, const simulator::CutForecast& forecast,
                  const StageWatch& watch) {
  constexpr double kMib = 1024.0 * 1024.0;
  std::ostringstream line;
  line << asked.name << ": cutting is forecast to take " << forecast.seconds << " s and "
       << std::lround(forecast.bytes / kMib) << " MiB";
  if (forecast.tiled) line << ", tile by tile";
  watch.options.watch.note(line.str());
}

/// Two stock models that contradict each other are a bug in one of them: no verdict rests on that.
const simulator::StockAgreement& agreed(const JobStage& asked,
                                        const simulator::StockAgreement& found) {
  if (std::max(found.worst_end_mm, found.worst_side_mm) <= simulator::kAgreement_mm) return found;
  std::ostringstream what;
  what << asked.name << ": the two stock models differ by "
       << std::max(found.worst_end_mm, found.worst_side_mm) << " mm at (" << found.worst_at.x
       << ", " << found.worst_at.y << ", " << found.worst_at.z << "); please report this";
  throw verifier::InstrumentDisagreement(what.str());
}

/// The box of the surface with room around it, and everything above it: a leftover may be as high
/// as the raw stock. Below, as far as holes are looked for.
model::Box3 near_surface(const Job& job, const model::Box3& surface, double within_mm,
                         double voxel_mm) {
  model::Box3 box = surface.grown(within_mm);
  box.high.z = std::max(box.high.z, model::bounding_box(job.stock).high.z + voxel_mm);
  box.low.z = std::min(box.low.z, surface.low.z - verifier::kStockSight_mm);
  return box;
}

std::vector<verifier::StockReading> read_stock(const simulator::StockModel& stock,
                                               const model::Box3& region,
                                               const model::RunControl& control) {
  std::vector<verifier::StockReading> readings;
  stock.visit_surface_points(
      region,
      [&readings](std::span<const simulator::StockPoint> points) {
        for (const simulator::StockPoint& p : points)
          readings.push_back({p.position, p.residual_mm});
      },
      control);
  return readings;
}

}  // namespace

CutStock uncut_stock(const Job& job, const Settings& settings, const StageWatch& watch) {
  simulator::StockModel stock(job.stock, settings.voxel_mm, settings.memory_limit_bytes,
                              watch.control("raw stock"));
  const double volume_mm3 = stock.volume_mm3(watch.control("raw stock"));
  return {std::move(stock), volume_mm3, simulator::DexelStock(job.stock, settings.line_spacing_mm)};
}

CutStock cut_again(CutStock before, std::span<const verifier::Pass> passes,
                   const StageWatch& watch) {
  for (const verifier::Pass& taken : passes) {
    const simulator::Pass pass{taken.cutter, taken.path};
    before.stock = std::move(before.stock).cut(pass, watch.control("cutting again"));
    before.lines = before.lines.cut(pass, watch.control("cutting again")).stock;
  }
  before.volume_mm3 = before.stock.volume_mm3(watch.control("adding up"));
  return before;
}

double readings_within_mm(const JobStage& asked, double voxel_mm) {
  // Well beyond what a gate speaks of; the floor and the sides of the stock are far from the part.
  constexpr double kVoxels = 10;
  return kVoxels * voxel_mm +
         2 * (asked.allowance_mm + std::max(asked.limits.gouge_mm, asked.limits.uncut_mm));
}

StageCut cut_stage(const Job& job, const RunInputs& inputs, const JobStage& asked, CutStock before,
                   const StageWatch& watch, reports::StageResult::Ran& ran) {
  const simulator::Pass pass{asked.cutter, ran.path};
  const auto control = [&](const char* what) { return watch.control(asked.name + what); };
  StageCut cut{std::move(before), {}};
  CutStock& now = cut.after;
  follow_process(job, inputs, asked, pass, now, watch, ran);
  say_forecast(asked, now.stock.forecast(pass, control(": forecasting")), watch);
  now.stock = std::move(now.stock).cut(pass, control(": cutting"));
  const double volume_mm3 = now.stock.volume_mm3(control(": adding up"));
  ran.removed_volume_mm3 = now.volume_mm3 - volume_mm3;
  now.volume_mm3 = volume_mm3;
  ran.agreement = agreed(asked, compare_stocks(now.lines, now.stock, kComparedLines,
                                               control(": comparing the models"), volume_mm3));
  const double voxel_mm = now.stock.voxel_mm();
  cut.readings = read_stock(now.stock,
                            near_surface(job, inputs.surface.bounding_box(),
                                         readings_within_mm(asked, voxel_mm), voxel_mm),
                            control(": reading the stock"));
  ran.voxel_mm = voxel_mm;
  ran.tiles = now.stock.tiles();
  ran.stock = now.stock;
  return cut;
}

}  // namespace limitgauge::app
