#include <fmt/format.h>

#include <ostream>
#include <variant>

#include "reports/embedded.h"
#include "reports/gate_figures.h"
#include "reports/html/engine_section.h"
#include "reports/html/markup.h"
#include "reports/html/stage_section.h"
#include "reports/page/page_script.h"
#include "reports/process.h"
#include "reports/report.h"
#include "reports/text.h"

namespace limitgauge::reports {
namespace {

using namespace html;

std::string mesh_stock_text(const model::MeshStock& stock) {
  const model::Vec3 s = bounding_box(*stock.mesh).size();
  const std::string source =
      stock.voxel_mm > 0 ? fmt::format(", zero set at a voxel of {} mm", shortest(stock.voxel_mm))
                         : std::string();
  return fmt::format("{}: mesh of {} triangles{}, {} × {} × {} mm", escape_markup(stock.file),
                     grouped(std::uint64_t(stock.mesh->triangles.size())), source, fixed(s.x, 3),
                     fixed(s.y, 3), fixed(s.z, 3));
}

std::string stock_text(const model::Stock& stock) {
  if (const auto* mesh = std::get_if<model::MeshStock>(&stock)) return mesh_stock_text(*mesh);
  if (const auto* box = std::get_if<model::BoxStock>(&stock)) {
    const model::Vec3& s = box->size_mm;
    return fmt::format("block {} × {} × {} mm", shortest(s.x), shortest(s.y), shortest(s.z));
  }
  const auto& bar = std::get<model::CylinderStock>(stock);
  return fmt::format("bar ⌀{} × {} mm", shortest(bar.diameter_mm), shortest(bar.height_mm));
}

const char* verdict_sentence(verifier::Verdict verdict) {
  switch (verdict) {
    case verifier::Verdict::pass:
      return "Every gate figure is proven inside its limit.";
    case verifier::Verdict::fail:
      return "At least one gate figure is proven beyond its limit.";
    case verifier::Verdict::indeterminate:
      return "Nothing is proven beyond a limit, but a certified interval still holds one: neither "
             "pass nor fail can be stated at this resolution.";
    case verifier::Verdict::not_run:
      break;
  }
  return "No stage was run.";
}

/// Where the figure that keeps the stage from passing is worst, and which program line made it.
std::string worst_place(const StageResult& stage, const RunResult& result) {
  if (!stage.ran) return {};
  const verifier::StageDeviation& d = stage.ran->deviation;
  const std::vector<GateFigure> figures = gate_figures(stage);
  std::string out;
  for (const auto& [i, findings] : {std::pair{0, &d.gouges}, {1, &d.uncuts}}) {
    const bool passes =
        figures[i].standing == Standing::within || figures[i].standing == Standing::no_limit;
    if (passes || findings->empty()) continue;
    const verifier::Finding& f = findings->front();
    const bool known = f.stage < result.stages.size();
    out += fmt::format("<li>Worst {}: <strong>{}</strong> at {} mm (X, Y, Z), patch {}",
                       figures[i].name, measured_length(f.depth_mm), coordinates(f.place.point),
                       f.place.patch);
    if (f.line > 0)
      out += fmt::format(", <strong>program line {}</strong>{}", f.line,
                         known ? " of " + escape_markup(result.stages[f.stage].name) : "");
    out += "</li>\n";
  }
  return out;
}

/// What decided the verdict: the reasons of the stages that did not pass, or of all.
std::string reasons_list(const RunResult& result) {
  std::string out;
  for (std::size_t i = 0; i < result.stages.size(); ++i) {
    const StageResult& stage = result.stages[i];
    const verifier::Verdict verdict = stage.verdict();
    if (verdict == verifier::Verdict::pass && result.verdict != verifier::Verdict::pass) continue;
    for (const std::string& reason : stage.decision.reasons)
      out += fmt::format("<li><a href=\"#{}\">{}</a>: {}</li>\n", stage_anchor(i),
                         escape_markup(stage.name), escape_markup(reason));
    out += worst_place(stage, result);
  }
  return out.empty() ? out : "<ul class=\"reasons\">" + out + "</ul>\n";
}

std::string masthead(const RunResult& result) {
  return fmt::format(
             "<header><p class=\"kind\">Limitgauge · certificate of toolpath verification</p>"
             "<h1>{}</h1>\n<div class=\"verdict {}\"><p class=\"word\">{}</p><p>{}</p>{}</div>\n",
             escape_markup(result.job), css_class(result.verdict), badge(result.verdict),
             verdict_sentence(result.verdict), reasons_list(result)) +
         terms({{"Created", escape_markup(result.created)},
                {"Design surface", escape_markup(result.surface.cage)},
                {"Stock", stock_text(result.raw_stock)},
                {"Program version", "limitgauge " + escape_markup(result.version)},
                {"Threads", std::to_string(result.threads)}}) +
         "</header>\n";
}

std::vector<std::string> stage_row(const StageResult& stage, std::size_t index) {
  const std::vector<GateFigure> f = gate_figures(stage);
  const auto figure = [&](std::size_t i) {
    if (f[i].standing == Standing::not_run) return std::string("–");
    return f[i].measured + (f[i].limit.empty() ? "" : "<small>limit " + f[i].limit + "</small>");
  };
  const std::size_t hits = stage.ran ? faults(stage.ran->process) : 0;
  return {fmt::format("<a href=\"#{}\">{}</a>", stage_anchor(index), escape_markup(stage.name)),
          fmt::format("{}<small>{}</small>", escape_markup(stage.tool), cutter_text(stage.cutter)),
          path_source(stage),
          stated_length(stage.allowance_mm),
          figure(0),
          figure(1),
          figure(2),
          stage.ran ? grouped(hits) : "–",
          stage.ran ? duration_text(stage.seconds) : "–",
          badge(stage.verdict())};
}

std::string stage_table(const RunResult& result) {
  std::vector<std::vector<std::string>> rows;
  for (std::size_t i = 0; i < result.stages.size(); ++i)
    rows.push_back(stage_row(result.stages[i], i));
  return "<section><h2>Stages</h2>\n" +
         table("Gouge and uncut are certified intervals against the stage's own allowance surface.",
               {{"Stage"},
                {"Tool"},
                {"Path"},
                {"Allowance", true},
                {"Gouge", true},
                {"Uncut", true},
                {"Coverage", true},
                {"Process faults", true},
                {"Time", true},
                {"Verdict"}},
               rows) +
         "</section>\n";
}

/// The rules that shape this cage's surface, in words.
std::string rules_text(const verifier::SurfaceRules& r) {
  std::string text = "Catmull-Clark, boundary ";
  switch (r.boundary) {
    case model::BoundaryRule::none:
      text += "none (faces at it are no surface)";
      break;
    case model::BoundaryRule::edge_and_corner:
      text += "edge and corner";
      break;
    case model::BoundaryRule::edge_only:
      text += "edge only";
      break;
  }
  const auto add = [&](model::Index count, const char* what) {
    if (count > 0) text += fmt::format(", {} {}", count, what);
  };
  add(r.sharp_edges, "sharp edges"), add(r.semi_sharp_edges, "semi-sharp edges, uniform");
  add(r.sharp_vertices, "sharp vertices"), add(r.semi_sharp_vertices, "semi-sharp vertices");
  add(r.darts, "darts"), add(r.holes, "holes");
  return text;
}

std::string surface_section(const SurfaceResult& s) {
  const model::Vec3 size = s.bbox_mm.size();
  return "<section><h2>Design surface</h2>\n" +
         terms(
             {{"Size of the limit surface", fmt::format("{} × {} × {} mm", fixed(size.x, 3),
                                                        fixed(size.y, 3), fixed(size.z, 3))},
              {"Area", three_digits(s.area_mm2) + " mm²"},
              {"Patches", grouped(std::uint64_t(s.summary.patches))},
              {"Faces of the cage", grouped(std::uint64_t(s.summary.faces))},
              {"Boundary edges", grouped(std::uint64_t(s.summary.boundary_edges))},
              {"Extraordinary vertices", grouped(std::uint64_t(s.summary.extraordinary_vertices))},
              {"Rules of the surface", rules_text(s.rules)}}) +
         "</section>\n";
}

constexpr const char* kDecisionRule = R"(<section><h2>How it was decided</h2>
<p>Deviation is the signed distance from each point of the exact limit surface to the space that was
removed, less the stage's allowance. Positive is material still standing (uncut), negative is cut too
deep (gouge). Part and simulation share one frame; nothing was fitted.</p>
<ul><li><strong>Passed</strong>: the upper end of every certified interval is inside its limit, so that
no point of the surface exceeds it; coverage is at least what is asked for; the process has no fault
(a collision, a cut with the spindle at rest, ...); near misses are shown and do not count.</li>
<li><strong>Failed</strong>: the lower end of an interval is beyond its limit, so that some point
truly exceeds it; or coverage is too small; or the process has a fault.</li>
<li><strong>Undecided</strong>: a limit lies inside a certified interval at the finest resolution
allowed.</li></ul>
<p>This is the rule of ISO 14253-1 in spirit: conformance is proven to pass and non-conformance is
proven to fail. The bounds are worst cases, not standard deviations, and carry no coverage factor. The
ratio of limit to interval width stands beside each figure; below 4 : 1 it is marked, and 10 : 1 or
better is aimed for.</p></section>
)";

std::string assumptions_section(const std::vector<std::string>& assumptions) {
  if (assumptions.empty()) return {};
  std::string items;
  for (const std::string& a : assumptions) items += "<li>" + escape_markup(a) + "</li>\n";
  return "<section><h2>Assumptions</h2><ul>" + items + "</ul></section>\n";
}

std::string head(const RunResult& result) {
  return fmt::format(
      "<!DOCTYPE html>\n<html lang=\"en\"><head><meta charset=\"utf-8\">\n"
      // Nothing is loaded and nothing of a file's text runs.
      "<meta http-equiv=\"Content-Security-Policy\" content=\"{}\">\n"
      "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n"
      "<meta name=\"color-scheme\" content=\"light dark\">\n"
      "<title>{}: {} – Limitgauge</title>\n<style>\n{}{}</style></head>\n<body><main>\n",
      page::content_policy(), escape_markup(result.job), word(result.verdict),
      embedded::report_css(), embedded::script_css());
}

}  // namespace

void write_html(const RunResult& result, std::ostream& out) {
  out << head(result) << masthead(result) << stage_table(result)
      << "<section id=\"view\"><h2>Error map</h2>\n<div data-view></div></section>\n";
  for (std::size_t i = 0; i < result.stages.size(); ++i) out << stage_section(result, i);
  out << surface_section(result.surface) << engine_section(result) << kDecisionRule
      << assumptions_section(result.assumptions)
      << "<footer><p>All lengths in mm or µm as stated. The same figures, digit for digit, are in "
         "result.json beside this page.</p></footer>\n</main>\n";
  page::write_page_script(result, out);
  out << "</body></html>\n";
}

}  // namespace limitgauge::reports
