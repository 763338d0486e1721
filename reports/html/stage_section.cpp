#include "reports/html/stage_section.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "reports/gate_figures.h"
#include "reports/html/charts.h"
#include "reports/html/error_map.h"
#include "reports/html/markup.h"
#include "reports/html/process_part.h"
#include "reports/html/program_part.h"
#include "reports/text.h"

namespace limitgauge::reports::html {
namespace {

constexpr std::size_t kLongestList = 20;

std::string signed_length(double mm) {
  return typeset(measured_length(mm));
}

/// Metres from a metre on.
std::string travel(double mm) {
  return mm < 1000 ? three_digits(mm) + " mm" : three_digits(mm / 1000) + " m";
}

std::string more_note(std::size_t total) {
  if (total <= kLongestList) return {};
  return fmt::format("<p class=\"note\">The {} worst of {}; the others are in result.json.</p>\n",
                     kLongestList, grouped(total));
}

/// Sides of the box of a cluster, rounded for reading.
std::string extent_text(const model::Box3& box) {
  if (box.empty()) return "–";
  const model::Vec3 size = box.size();
  return fixed(size.x, 2) + " × " + fixed(size.y, 2) + " × " + fixed(size.z, 2);
}

/// The program lines of the passes around a leftover, or the body that gouged.
std::string left_by(const verifier::Finding& f) {
  if (f.passes.empty()) return escape_markup(f.body);
  std::string lines;
  for (const verifier::NearPass& p : f.passes)
    if (p.line > 0) lines += (lines.empty() ? "lines " : ", ") + std::to_string(p.line);
  return lines.empty() ? "–" : lines;
}

/// What each body of the assembly does to the part; nothing to say where all is well above it.
std::string bodies_table(const RunResult& result, const verifier::StageDeviation& d) {
  if (d.bodies.size() < 2) return {};
  std::vector<std::vector<std::string>> rows;
  for (const verifier::BodyFigure& b : d.bodies) {
    const bool flutes = b.body == "cutter";
    rows.push_back({escape_markup(b.body),
                    flutes || b.stage >= result.stages.size()
                        ? "all so far"
                        : escape_markup(result.stages[b.stage].name),
                    measured_length(b.gouge_mm.low), measured_length(b.gouge_mm.high)});
  }
  return table("Gouge by body of the assembly, certified",
               {{"Body"}, {"Stage"}, {"At least", true}, {"At most", true}}, rows);
}

std::string findings_table(const RunResult& result, const std::vector<verifier::Finding>& findings,
                           std::string_view caption, char letter) {
  if (findings.empty()) return {};
  std::vector<std::vector<std::string>> rows;
  for (std::size_t i = 0; i < std::min(findings.size(), kLongestList); ++i) {
    const verifier::Finding& f = findings[i];
    const std::string stage =
        f.stage < result.stages.size() ? escape_markup(result.stages[f.stage].name) : "–";
    rows.push_back({fmt::format("{}{}", letter, i + 1), measured_length(f.depth_mm),
                    three_digits(f.area_mm2) + " mm²", extent_text(f.extent_mm),
                    coordinates(f.place.point), std::to_string(f.place.patch), fixed(f.place.u, 4),
                    fixed(f.place.v, 4), stage, f.line > 0 ? std::to_string(f.line) : "–",
                    grouped(f.move), left_by(f)});
  }
  return table(caption,
               {{"No."},
                {"Depth", true},
                {"Area", true},
                {"Extent in mm", true},
                {"X, Y, Z in mm", true},
                {"Patch", true},
                {"u", true},
                {"v", true},
                {"Stage"},
                {"Line", true},
                {"Move", true},
                {"By"}},
               rows) +
         more_note(findings.size());
}

std::string ratio_text(const verifier::Interval& interval, bool has_limit, double limit_mm) {
  if (!has_limit) return "–";
  const double ratio = accuracy_ratio(interval, limit_mm);
  if (!std::isfinite(ratio)) return "exact";
  const std::string text = three_digits(ratio) + " : 1";
  if (ratio >= kLeastAccuracyRatio) return text;
  return text + " <strong class=\"warn\">below 4 : 1</strong>";
}

/// Gouge and uncut as bars against their limits, then coverage and collisions in words.
std::string gate_table(const StageResult& stage) {
  const verifier::StageDeviation& d = stage.ran->deviation;
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
                    f.limit.empty() ? "–"
                                    : (i == 2  ? "≥ "
                                       : i < 2 ? "≤ "
                                               : "") +
                                          f.limit,
                    i < 2 ? ratios[i] : "", badge(f.standing)});
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

std::string deviation_terms(const verifier::StageDeviation& d) {
  const auto area = [](double mm2) { return three_digits(mm2) + " mm²"; };
  return "<h4>Deviation</h4>" +
         terms({{"Mean", signed_length(d.mean_mm)},
                {"Root mean square", signed_length(d.rms_mm)},
                {"1st percentile", signed_length(d.p01_mm)},
                {"Median", signed_length(d.p50_mm)},
                {"99th percentile", signed_length(d.p99_mm)},
                {"Second instrument (voxels): gouge", measured_length(d.voxel_gouge_mm)},
                {"Second instrument (voxels): uncut", measured_length(d.voxel_uncut_mm)},
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
  return "<h4>Toolpath</h4>" +
         terms({{"Moves", grouped(r.path ? r.path->moves.size() : 0)},
                {"Section planes or levels", grouped(std::uint64_t(std::max(r.planes, 0)))},
                {"Cutting length", travel(r.cut_length_mm)},
                {"Rapid length", travel(r.rapid_length_mm)},
                {"Machining time", duration_text(r.machining_time_s)},
                {"Planning took", duration_text(r.plan_seconds)}});
}

std::string simulation_terms(const StageResult::Ran& r) {
  return "<h4>Simulation</h4>" +
         terms({{"Voxel", stated_length(r.voxel_mm)},
                {"Removed volume", three_digits(r.removed_volume_mm3 / 1000) + " cm³"},
                {"Simulation took", duration_text(r.simulation_seconds)},
                {"Peak memory", bytes_text(r.peak_memory_bytes)}});
}

std::string budget_table(const std::vector<verifier::UncertaintyTerm>& budget) {
  if (budget.empty()) return {};
  std::vector<std::vector<std::string>> rows;
  for (const verifier::UncertaintyTerm& t : budget)
    rows.push_back({escape_markup(t.source),
                    t.bound_mm == 0 ? "0" : typeset(three_digits(t.bound_mm * 1000)),
                    t.in_certificate ? "part of every interval above" : "voxel figures only"});
  return table("Uncertainty budget: worst-case bounds, no coverage factor.",
               {{"Source"}, {"Bound in µm", true}, {"Concerns"}}, rows);
}

std::string ignored_words(const std::vector<std::string>& words) {
  if (words.empty()) return {};
  std::string list;
  for (std::size_t i = 0; i < std::min(words.size(), kLongestList); ++i)
    list += (i ? ", " : "") + escape_markup(words[i]);
  return fmt::format(
      "<p class=\"note\">Words that move nothing; of these only tools and the spindle are heeded "
      "(line: "
      "word): "
      "{}{}.</p>\n",
      list, words.size() > kLongestList ? " …" : "");
}

std::string stock_figure(const std::optional<StagePictures>& pictures) {
  if (!pictures || pictures->stock_png.empty()) return {};
  return fmt::format(
      "<figure class=\"stock\"><figcaption>The stock after this stage, as simulated."
      "</figcaption><img src=\"{}\" alt=\"Shaded view of the cut stock\"></figure>\n",
      png_uri(pictures->stock_png));
}

std::string measured_part(const RunResult& result, std::size_t index) {
  const StageResult& stage = result.stages[index];
  const StageResult::Ran& ran = *stage.ran;
  const verifier::StageDeviation& d = ran.deviation;
  std::string out = gate_table(stage) + "<div class=\"plates\">";
  if (stage.pictures) out += error_maps(stage);
  out += histogram_chart(d, stage.limits) + stock_figure(stage.pictures) + "</div>\n";
  out += findings_table(result, d.gouges, "Gouges, deepest first", 'G');
  out += findings_table(result, d.uncuts, "Material left standing, highest first", 'U');
  out += bodies_table(result, d);
  out += process_table(ran.process);
  out += program_part(result, index);
  out += "<div class=\"figures\"><div>" + deviation_terms(d) + "</div><div>" + path_terms(ran) +
         simulation_terms(ran) + removal_terms(ran) + "</div></div>\n";
  return out + ignored_words(ran.ignored_words) + budget_table(d.budget);
}

std::string request_line(const StageResult& stage) {
  std::vector<std::string> parts = {escape_markup(stage.tool) + ", " + cutter_text(stage.cutter),
                                    path_source(stage)};
  if (stage.step_mm > 0) parts.push_back("path interval " + stated_length(stage.step_mm));
  parts.push_back("allowance " + stated_length(stage.allowance_mm));
  if (stage.tolerance_mm > 0)
    parts.push_back("path tolerance " + stated_length(stage.tolerance_mm));
  std::string out;
  for (const std::string& part : parts)
    out += fmt::format("{}<span class=\"part\">{}</span>", out.empty() ? "" : " · ", part);
  return out;
}

}  // namespace

std::string stage_anchor(std::size_t index) {
  return "stage-" + std::to_string(index + 1);
}

std::string path_source(const StageResult& stage) {
  return stage.program.empty()
             ? escape_markup(stage.strategy)
             : "program " + escape_markup(stage.program) +
                   (stage.program_part.empty() ? "" : ", ") + escape_markup(stage.program_part);
}

std::string cutter_text(const model::Cutter& cutter) {
  return fmt::format("{} ⌀{}", model::name(cutter.type), stated_length(cutter.diameter_mm));
}

std::string stage_section(const RunResult& result, std::size_t index) {
  const StageResult& stage = result.stages[index];
  const verifier::Verdict verdict = stage.verdict();
  std::string reasons;
  for (const std::string& reason : stage.decision.reasons)
    reasons += "<li>" + escape_markup(reason) + "</li>";
  if (!reasons.empty()) reasons = fmt::format("<ul class=\"reasons\">{}</ul>", reasons);
  return fmt::format(
      "<section class=\"stage\" id=\"{}\"><h2><span class=\"no\">Stage {}</span> {} "
      "{}</h2>\n<p class=\"request\">{}</p>\n{}\n{}</section>\n",
      stage_anchor(index), index + 1, escape_markup(stage.name), badge(verdict),
      request_line(stage), reasons, stage.ran ? measured_part(result, index) : std::string());
}

}  // namespace limitgauge::reports::html
