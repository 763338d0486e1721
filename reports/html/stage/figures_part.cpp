#include "reports/html/stage/figures_part.h"

#include <algorithm>

#include "reports/html/markup.h"
#include "reports/html/stage/process_part.h"
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
  return "<div class=\"figures\"><div>" + deviation_terms(ran.deviation) + "</div><div>" +
         path_terms(ran) + simulation_terms(ran) + removal_terms(ran) + "</div></div>\n";
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

}  // namespace limitgauge::reports::html
