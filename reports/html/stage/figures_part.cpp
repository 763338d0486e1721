#include "reports/html/stage/stage_parts.h"

#include <algorithm>
#include <cmath>

#include "reports/html/charts.h"
#include "reports/html/markup.h"
#include "reports/run/gate_figures.h"
#include "reports/text/text.h"

namespace limitgauge::reports::html {
namespace {

std::string signed_length(double mm) {
  return typeset(measured_length(mm));
}

/// Metres from a metre on.
std::string travel(double mm) {
  return mm < 1000 ? three_digits(mm) + " mm" : three_digits(mm / 1000) + " m";
}

std::string deviation_terms(const verifier::StageDeviation& d) {
  const auto area = [](double mm2) { return three_digits(mm2) + " mm²"; };
  return "<h3>Deviation</h3>" +
         terms(
             {{"Mean", signed_length(d.mean_mm)},
              {"Root mean square", signed_length(d.rms_mm)},
              {"1st percentile", signed_length(d.p01_mm)},
              {"Median", signed_length(d.p50_mm)},
              {"99th percentile", signed_length(d.p99_mm)},
              {"Second instrument (rays into the stock): gouge", measured_length(d.voxel_gouge_mm)},
              {"Second instrument (rays into the stock): uncut", measured_length(d.voxel_uncut_mm)},
              {"Reachable area", area(d.reachable_area_mm2)},
              {"Unreachable area", area(d.unreachable_area_mm2)},
              {"Proven in reach, out of reach, neither",
               area(d.proven_reach.reachable_mm2) + ", " + area(d.proven_reach.unreachable_mm2) +
                   ", " + area(d.proven_reach.undecided_mm2)},
              {"Unavoidable uncut", measured_length(d.unavoidable_uncut_mm.low) + " to " +
                                        measured_length(d.unavoidable_uncut_mm.high)},
              {"Cells examined", grouped(d.cells)},
              {"Interval width asked for",
               stated_length(d.resolution_mm) +
                   (d.reached_resolution ? ", reached" : ", not reached")},
              {"Verification took", duration_text(d.seconds)}});
}

std::string path_terms(const StageResult::Ran& r) {
  return "<h3>Toolpath</h3>" +
         terms({{"Moves", grouped(r.path ? r.path->moves.size() : 0)},
                {"Section planes or levels", grouped(std::uint64_t(std::max(r.planes, 0)))},
                {"Cutting length", travel(r.cut_length_mm)},
                {"Rapid length", travel(r.rapid_length_mm)},
                {"Machining time", duration_text(r.machining_time_s)},
                {"Planning took", duration_text(r.plan_seconds)}});
}

std::string simulation_terms(const StageResult::Ran& r) {
  return "<h3>Simulation</h3>" +
         terms({{"Voxel", stated_length(r.voxel_mm)},
                {"Removed volume", three_digits(r.removed_volume_mm3 / 1000) + " cm³"},
                {"Simulation took", duration_text(r.simulation_seconds)},
                {"Peak memory", bytes_text(r.peak_memory_bytes)}});
}

const char* concerned(const verifier::UncertaintyTerm& t) {
  if (t.in_certificate) return "part of every interval above";
  return t.found_by_check ? "found by a check, in no figure" : "voxel figures only";
}

}  // namespace

std::string figures_part(const StageResult::Ran& ran) {
  const std::string deviation =
      ran.deviation ? "<div>" + deviation_terms(*ran.deviation) + "</div>" : std::string();
  return "<div class=\"figures\">" + deviation + "<div>" + path_terms(ran) + simulation_terms(ran) +
         removal_terms(ran) + "</div></div>\n";
}

std::string budget_table(const std::vector<verifier::UncertaintyTerm>& budget) {
  if (budget.empty()) return {};
  std::vector<std::vector<std::string>> rows;
  for (const verifier::UncertaintyTerm& t : budget)
    rows.push_back({escape_markup(t.source),
                    t.bound_mm == 0 ? "0" : typeset(three_digits(t.bound_mm * 1000)),
                    concerned(t)});
  return table("Uncertainty budget: worst-case bounds, no coverage factor.",
               {{"Source"}, {"Bound in µm", true}, {"Concerns"}}, rows);
}

namespace {

std::string ratio_text(const verifier::Interval& interval, bool has_limit, double limit_mm) {
  if (!has_limit) return "–";
  const double ratio = accuracy_ratio(interval, limit_mm);
  if (!std::isfinite(ratio)) return "exact";
  const std::string text = three_digits(ratio) + " : 1";
  if (ratio >= kLeastAccuracyRatio) return text;
  return text + " <strong class=\"warn\">below 4 : 1</strong>";
}

/// Without a design no figure is an interval.
std::string counts_table(const StageResult& stage) {
  std::vector<std::vector<std::string>> rows;
  for (const GateFigure& f : gate_figures(stage))
    rows.push_back({f.name, f.measured, f.limit, badge(f.standing)});
  return table(
      "What the verdict is made of: counts of moves. Nothing was measured against a design.",
      {{"Figure"}, {"Found", true}, {"Allowed", true}, {"Standing"}}, rows);
}

}  // namespace

std::string gate_part(const StageResult& stage) {
  if (!stage.ran->deviation) return counts_table(stage);
  const verifier::StageDeviation& d = *stage.ran->deviation;
  const verifier::GateLimits& l = stage.limits;
  const std::vector<GateFigure> figures = gate_figures(stage);
  const std::string charts[] = {interval_chart(d.gouge_mm, l.has_gouge, l.gouge_mm),
                                interval_chart(d.uncut_mm, l.has_uncut, l.uncut_mm)};
  const std::string ratios[] = {ratio_text(d.gouge_mm, l.has_gouge, l.gouge_mm),
                                ratio_text(d.uncut_mm, l.has_uncut, l.uncut_mm)};
  std::vector<std::vector<std::string>> rows;
  for (std::size_t i = 0; i < figures.size(); ++i) {
    const GateFigure& f = figures[i];
    rows.push_back({f.name, f.measured, i < 2 ? charts[i] : "",
                    f.limit.empty() ? "–" : f.relation + f.limit, i < 2 ? ratios[i] : "",
                    badge(f.standing)});
  }
  return table(
      "Gate figures. An interval is proven: some point reaches its lower end, no point of "
      "the surface exceeds its upper end.",
      {{"Figure"},
       {"Measured", true},
       {"Interval and limit"},
       {"Limit", true},
       {"Limit : interval", true},
       {"Standing"}},
      rows);
}

}  // namespace limitgauge::reports::html
