#include "reports/html/stage/stage_parts.h"

#include <algorithm>
#include <cmath>

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

std::string deviation_terms(const StageResult& stage) {
  const verifier::StageDeviation& d = *stage.ran->deviation;
  const auto area = [](double mm2) { return three_digits(mm2) + " mm²"; };
  std::vector<Term> list = {
      {"Mean", signed_length(d.mean_mm)},
      {"Root mean square", signed_length(d.rms_mm)},
      {"1st percentile", signed_length(d.p01_mm)},
      {"Median", signed_length(d.p50_mm)},
      {"99th percentile", signed_length(d.p99_mm)},
      {"Second instrument (rays into the stock): gouge", measured_length(d.voxel_gouge_mm)},
      {"Second instrument (rays into the stock): uncut", measured_length(d.voxel_uncut_mm)},
      {"Area in reach, by samples", area(d.reachable_area_mm2)},
      {"Area out of reach, by samples", area(d.unreachable_area_mm2)},
      {"Area proven in reach", area(d.proven_reach.reachable_mm2)}};
  // Where some is missing for certain, that is said on top of the page.
  for (const GateFigure& figure : gate_figures(stage))
    if (figure.name == "missing stock" && !(d.missing_stock_mm.low > 0))
      list.push_back({"Missing stock", figure.measured});
  list.push_back({"Cells examined", grouped(d.cells)});
  list.push_back(
      {"Interval width asked for",
       stated_length(d.resolution_mm) + (d.reached_resolution ? ", reached" : ", not reached")});
  list.push_back({"Verification took", duration_text(d.seconds)});
  return "<h3>Deviation</h3>" + terms(list);
}

/// What the table of toolpaths does not say.
std::string path_terms(const StageRun& r) {
  return "<h3>Toolpath</h3>" + terms({{"Cutting length", travel(r.cut_length_mm)},
                                      {"Rapid length", travel(r.rapid_length_mm)}});
}

std::string simulation_terms(const StageRun& r) {
  std::vector<Term> list = {{"Voxel", stated_length(r.voxel_mm)}};
  // Without a design it stands in the table of stages.
  if (r.deviation)
    list.push_back({"Removed volume", three_digits(r.removed_volume_mm3 / 1000) + " cm³"});
  list.push_back({"Simulation took", duration_text(r.simulation_seconds)});
  list.push_back({"Peak memory", bytes_text(r.peak_memory_bytes)});
  return "<h3>Simulation</h3>" + terms(list);
}

const char* concerned(const verifier::UncertaintyTerm& t) {
  if (t.in_certificate) return "part of every interval";
  return t.found_by_check ? "found by a check, in no figure" : "voxel figures only";
}

}  // namespace

std::string figures_part(const StageResult& stage) {
  const StageRun& ran = *stage.ran;
  const std::string deviation =
      ran.deviation ? "<div>" + deviation_terms(stage) + "</div>" : std::string();
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
  return fold("budget", "Uncertainty budget",
              table("Worst-case bounds, no coverage factor.",
                    {{"Source"}, {"Bound, µm", true}, {"Concerns"}}, rows));
}

}  // namespace limitgauge::reports::html
