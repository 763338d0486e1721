#include "reports/html/masthead.h"

#include <fmt/format.h>

#include "reports/html/job/job_sections.h"
#include "reports/html/markup.h"
#include "reports/html/stage/stage_parts.h"
#include "reports/run/gate_figures.h"
#include "reports/text/text.h"

namespace limitgauge::reports::html {
namespace {

const char* verdict_sentence(verifier::Verdict verdict) {
  switch (verdict) {
    case verifier::Verdict::pass:
      return "Every gate figure is proven inside its limit.";
    case verifier::Verdict::fail:
      return "At least one gate figure is proven beyond its limit.";
    case verifier::Verdict::indeterminate:
      return "Nothing is proven beyond a limit, but a certified interval still holds one: neither "
             "pass nor fail can be stated.";
    case verifier::Verdict::not_run:
      break;
  }
  return "No stage was run.";
}

/// Without a design: what it does not say comes first.
std::string process_sentence(verifier::Verdict verdict) {
  const std::string head = "<strong>Nothing was measured against a design.</strong> ";
  if (verdict == verifier::Verdict::pass)
    return head + "The program was cut in its stock, and no fault was found on the way.";
  if (verdict == verifier::Verdict::fail)
    return head + "The program was cut in its stock, and faults were found on the way.";
  return head + verdict_sentence(verdict);
}

/// What decided the verdict: the reasons of the stages that did not pass, or of all.
std::string reasons_list(const RunResult& result) {
  std::string out;
  for (std::size_t i = 0; i < result.stages.size(); ++i) {
    const StageResult& stage = result.stages[i];
    const verifier::Verdict verdict = stage.verdict();
    if (verdict == verifier::Verdict::pass && result.verdict != verifier::Verdict::pass) continue;
    for (const std::string& reason : stage.decision.reasons)
      if (!is_note(reason))
        out += fmt::format("<li><a href=\"#{}\">{}</a>: {}</li>\n", stage_anchor(i),
                           escape_markup(stage.name), escape_markup(reason));
  }
  return out.empty() ? out : "<ul class=\"reasons\">" + out + "</ul>\n";
}

/// What no cutter reaches and what stock is missing, of every stage: a verdict says nothing of it.
std::string notes_list(const RunResult& result) {
  std::string out;
  for (std::size_t i = 0; i < result.stages.size(); ++i)
    for (const std::string& note : stage_notes(result.stages[i]))
      out += fmt::format("<li><a href=\"#{}\">{}</a>: <strong>{}</strong></li>\n", stage_anchor(i),
                         escape_markup(result.stages[i].name), escape_markup(note));
  return out.empty() ? out : "<ul class=\"reasons\">" + out + "</ul>\n";
}

}  // namespace

namespace {

/// What a verdict on a mesh is about.
std::string facets_sentence(const SurfaceResult& surface) {
  return surface.mesh ? " The design is a mesh: all of it is about its facets." : "";
}

std::string design_text(const SurfaceResult& surface) {
  const std::string file = escape_markup(surface.cage);
  if (!surface.mesh) return file + ", a Catmull-Clark cage: its limit surface";
  return fmt::format("{}, a mesh: its {} facets as they are", file, grouped(surface.summary.faces));
}

}  // namespace

std::string masthead(const RunResult& result) {
  return fmt::format(
             "<header><p class=\"kind\">Limitgauge · {}</p>"
             "<h1>{}</h1>\n<div class=\"verdict {}\"><p "
             "class=\"word\">{}</p><p>{}</p>\n{}{}{}</div>\n",
             result.surface ? "certificate of toolpath verification"
                            : "a program cut without a design",
             escape_markup(result.job), css_class(result.verdict), badge(result.verdict),
             result.surface ? verdict_sentence(result.verdict) + facets_sentence(*result.surface)
                            : process_sentence(result.verdict),
             notes_list(result), worst_places(result), reasons_list(result)) +
         terms(
             {{"Created", escape_markup(result.created)},
              {"Design surface", result.surface ? design_text(*result.surface)
                                                : "none: gouge, uncut and coverage are not known"},
              {"Stock", stock_text(result.raw_stock)},
              {"Program version", "limitgauge " + escape_markup(result.version)}}) +
         "</header>\n";
}

namespace {

std::string entry(std::string_view anchor, std::string_view text) {
  return fmt::format("<li><a href=\"#{}\">{}</a></li>", anchor, text);
}

}  // namespace

std::string contents(const RunResult& result) {
  std::string list = entry("stages", "Stages") +
                     entry("view", result.surface ? "Error map in 3D" : "Finished stock in 3D");
  for (std::size_t i = 0; i < result.stages.size(); ++i)
    list +=
        entry(stage_anchor(i), fmt::format("{}. {}", i + 1, escape_markup(result.stages[i].name)));
  if (result.surface) list += entry("surface", "Design surface");
  if (has_engine_section(result)) list += entry("toolpaths", "Toolpaths");
  list += entry("tools", "Tools") + entry("inputs", "Job and inputs") +
          entry("decision", "How it was decided");
  if (!result.assumptions.empty()) list += entry("assumptions", "Assumptions");
  return "<nav class=\"contents\" aria-label=\"Contents\"><ul>" + list + "</ul></nav>\n";
}

}  // namespace limitgauge::reports::html
