#include "app/run/cut_stock.h"

#include <algorithm>
#include <cmath>
#include <sstream>
#include <utility>

#include "app/run/axis_turns.h"
#include "model/base/memory.h"
#include "simulator/instrument/dexel_agreement.h"
#include "simulator/instrument/dexels_from.h"
#include "simulator/instrument/turning_agreement.h"
#include "simulator/instrument/turning_removal.h"
#include "simulator/process/process_check.h"

namespace limitgauge::app {
namespace {

/// Lines on which the two stock models are compared after each stage.
constexpr std::size_t kComparedLines = 4000;

/// What each move took.
void follow_removal(const JobStage& asked, const simulator::Pass& pass, CutStock& stock,
                    const StageWatch& watch, reports::StageRun& ran) {
  simulator::DexelStock::Cut after =
      stock.lines.cut(pass, watch.control(asked.name + ": following the removal"));
  stock.lines = std::move(after.stock);
  ran.removal = std::move(after.removal);
}

/// Whether it is about a place of the stock, or might be.
bool may_be_of_stock(const simulator::Finding& finding) {
  return finding.kind != simulator::FindingKind::fixture_touched &&
         finding.kind != simulator::FindingKind::beyond_travel;
}

/// A stretch that only positions takes nothing, but for what lines that end on the surface that it
/// leaves are rounded to.
bool removes_nothing(const JobStage& asked, const simulator::RemovalTotals& removal) {
  constexpr double kRounding_mm3 = 1e-6;
  return only_positions(asked) && removal.volume_mm3 <= kRounding_mm3;
}

void say_forecast(const JobStage& asked, const simulator::CutForecast& forecast,
                  const StageWatch& watch) {
  std::ostringstream line;
  line << asked.name << ": cutting is forecast to take " << forecast.seconds
       << " s, the stock and its moves then " << model::in_mib(forecast.bytes);
  if (forecast.tiled) line << ", tile by tile";
  watch.options.watch.note(line.str());
}

/// Two stock models that contradict each other are a bug in one of them: no verdict rests on that.
/// `to_part` is how the dexels' frame lies in the part's.
void require_agreement(const std::string& when, const model::Pose& to_part,
                       const simulator::StockAgreement& found) {
  if (std::max(found.worst_end_mm, found.worst_side_mm) <= simulator::kAgreement_mm) return;
  const model::Vec3 at = to_part.point(found.worst_at);
  std::ostringstream what;
  what << when << ": the two stock models differ by "
       << std::max(found.worst_end_mm, found.worst_side_mm) << " mm at (" << at.x << ", " << at.y
       << ", " << at.z << "); please report this";
  throw verifier::InstrumentDisagreement(what.str());
}

/// Cuts the level set, with its volume before and after.
void cut_level_set(const JobStage& asked, const simulator::Pass& pass, CutStock& now,
                   const StageWatch& watch, reports::StageRun& ran) {
  const auto control = [&](const char* what) { return watch.control(asked.name + what); };
  say_forecast(asked, now.stock.forecast(pass, control(": forecasting")), watch);
  if (now.volume_is_older) now.volume_mm3 = now.stock.volume_mm3(control(": adding up"));
  now.stock = std::move(now.stock).cut(pass, control(": cutting"));
  const double before_mm3 =
      std::exchange(now.volume_mm3, now.stock.volume_mm3(control(": adding up")));
  now.volume_is_older = false;
  ran.removed_volume_mm3 = before_mm3 - now.volume_mm3;
}

/// No lines are cut by a tool that turns as it goes: they are taken from the level set, which an
/// evaluator of poses is held against.
void follow_turning(const JobStage& asked, const Settings& settings, const simulator::Pass& pass,
                    CutStock& now, const StageWatch& watch, reports::StageRun& ran) {
  const auto control = watch.control(asked.name + ": comparing the models");
  simulator::DexelStock after = dexels_from(now.stock, settings.line_spacing_mm, control);
  ran.agreement =
      compare_turning(now.lines, after, now.stock, pass, kComparedLines, control, now.volume_mm3);
  ran.removal = turning_removal(now.lines, after, pass, control);
  now.lines = std::move(after);
}

/// What is said of the stock after a stage.
void fill_in(const CutStock& now, reports::StageRun& ran) {
  ran.voxel_mm = now.stock.voxel_mm();
  ran.tiles = now.stock.tiles();
  ran.stock = now.stock;
}

void compare(const JobStage& asked, const CutStock& now, const StageWatch& watch,
             reports::StageRun& ran) {
  const auto control = watch.control(asked.name + ": comparing the models");
  ran.agreement = compare_stocks(now.lines, now.stock, kComparedLines, control, now.volume_mm3);
}

/// From the frame of the setup that `job` is a view of.
model::Pose to_part(const Job& job) {
  return job.at_setup ? job.setups[*job.at_setup].setup.from_part.inverse() : model::Pose{};
}

}  // namespace

namespace {

/// Of a stage that is no stretch of its program they are among the others of its moves.
std::vector<simulator::Finding> travel_of(const Job& job, const RunInputs& inputs,
                                          const JobStage& asked, const model::Toolpath& path) {
  const auto stage = std::ranges::find(job.stages, asked.name, &JobStage::name);
  if (!asked.piece || stage == job.stages.end()) return {};
  return travel_findings(*inputs.programs[static_cast<std::size_t>(stage - job.stages.begin())],
                         path);
}

}  // namespace

std::vector<simulator::Finding> process_findings(const Job& job, const RunInputs& inputs,
                                                 const JobStage& asked,
                                                 const simulator::StockModel& stock,
                                                 const simulator::Pass& pass,
                                                 const StageWatch& watch) {
  simulator::ProcessLimits limits;
  limits.tolerance_mm = inputs.settings.contact_tolerance_mm;
  limits.near_miss_mm = near_miss_mm(job);
  // Of a stretch its program's motions are held against it, by where the axes stand; of a planned
  // tool that leans they were when it was posted.
  if (!asked.piece && !pass.axes) limits.travel_mm = job.travel_mm;
  limits.fixtures = inputs.fixtures;
  limits.carried = carried_bodies(job, asked, inputs.carried);
  const auto control = watch.control(asked.name + ": checking the process");
  std::vector<simulator::Finding> found = turn_findings(job, asked, stock, limits, control);
  const auto moves = check_process(stock, pass, limits, control);
  const auto beyond = travel_of(job, inputs, asked, *pass.path);
  std::ranges::merge(moves, beyond, std::back_inserter(found), {}, &simulator::Finding::move,
                     &simulator::Finding::move);
  return found;
}

CutStock uncut_stock(const Job& job, const Settings& settings, const StageWatch& watch) {
  simulator::StockModel stock(job.stock, settings.voxel_mm, settings.stock_limit_bytes,
                              watch.control("raw stock"));
  const double volume_mm3 = stock.volume_mm3(watch.control("raw stock"));
  return {std::move(stock), volume_mm3, simulator::DexelStock(job.stock, settings.line_spacing_mm)};
}

CutStock cut_again(CutStock before, std::span<const model::Pass> passes, const Settings& settings,
                   const StageWatch& watch) {
  const auto control = watch.control("cutting again");
  for (const model::Pass& pass : passes) {
    before.stock = std::move(before.stock).cut(pass, control);
    before.lines = pass.axes ? dexels_from(before.stock, settings.line_spacing_mm, control)
                             : before.lines.cut(pass, control).stock;
  }
  before.volume_mm3 = before.stock.volume_mm3(watch.control("adding up"));
  before.volume_is_older = false;
  return before;
}

CutStock turned_over(const Job& job, const Settings& settings, const CutStock& before,
                     const StockTurn& turn, const StageWatch& watch) {
  const auto control = watch.control("turning the stock over");
  simulator::StockModel stock(job.stock, settings.voxel_mm, settings.stock_limit_bytes, control);
  for (const model::Pass& pass : turn.passes) stock = std::move(stock).cut(pass, control);
  require_agreement(
      "turning the stock over", to_part(job) * turn.turn,
      compare_stocks(before.lines, stock, kComparedLines, control, before.volume_mm3, turn.turn));
  simulator::DexelStock lines = dexels_from(stock, settings.line_spacing_mm, control);
  return {std::move(stock), before.volume_mm3, std::move(lines), true};
}

CutStock cut_stage(const Job& job, const RunInputs& inputs, const JobStage& asked, CutStock before,
                   const StageWatch& watch, reports::StageRun& ran) {
  const simulator::Pass pass{asked.cutter, ran.path, {}, false, ran.axes};
  const auto control = [&](const char* what) { return watch.control(asked.name + what); };
  CutStock now = std::move(before);
  ran.process = process_findings(job, inputs, asked, now.stock, pass, watch);
  if (!pass.axes) follow_removal(asked, pass, now, watch, ran);
  if (!pass.axes && removes_nothing(asked, ran.removal.totals)) {
    now.stock = std::move(now.stock).cut(pass, control(": cutting"));
  } else {
    cut_level_set(asked, pass, now, watch, ran);
  }
  if (pass.axes) {
    follow_turning(asked, inputs.settings, pass, now, watch, ran);
  } else {
    compare(asked, now, watch, ran);
  }
  fill_in(now, ran);
  require_agreement(asked.name, to_part(job), ran.agreement);
  return now;
}

bool passes_by(const Job& job, const RunInputs& inputs, const JobStage& asked,
               const CutStock& stock, const StageWatch& watch, reports::StageRun& ran) {
  if (!only_positions(asked)) return false;
  // What stands is part of the block: what meets nothing of the block meets nothing.
  const Settings& settings = inputs.settings;
  const simulator::StockModel block(job.stock, settings.voxel_mm, settings.stock_limit_bytes,
                                    watch.control(asked.name + ": checking the process"));
  const simulator::Pass pass{asked.cutter, ran.path, {}, false, ran.axes};
  constexpr double kClear_mm = 0.01;
  if (!keeps_clear(block, pass, std::max(kClear_mm, near_miss_mm(job)),
                   watch.control(asked.name + ": checking the process")))
    return false;
  auto found = process_findings(job, inputs, asked, block, pass, watch);
  if (std::any_of(found.begin(), found.end(), may_be_of_stock)) return false;
  ran.process = std::move(found);
  ran.removal.moves.resize(ran.path->moves.size());
  ran.removal.totals = removal_totals(*ran.path, ran.removal.moves, stock.lines.spacing_mm());
  compare(asked, stock, watch, ran);
  fill_in(stock, ran);
  return true;
}

}  // namespace limitgauge::app
