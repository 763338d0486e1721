#include "reports/html/headline.h"

#include <fmt/format.h>

#include "reports/html/markup.h"
#include "reports/run/gate_figures.h"
#include "reports/run/headlines.h"
#include "reports/text/text.h"
#include "verifier/gate/gate_text.h"

namespace limitgauge::reports::html {
namespace {

using verifier::Verdict;

/// A list of `lines`, each begun with a link to its stage.
class StageList {
 public:
  explicit StageList(const RunResult& result) : result_(result) {}

  void add(std::size_t stage, const std::string& markup) {
    lines_ += fmt::format("<li><a href=\"#{}\">{}</a>: {}</li>\n", stage_anchor(stage),
                          escape_markup(result_.stages[stage].name), markup);
  }
  std::string take(std::string_view css) const {
    return lines_.empty() ? lines_ : fmt::format("<ul class=\"{}\">{}</ul>\n", css, lines_);
  }

 private:
  const RunResult& result_;
  std::string lines_;
};

/// Without a design: what it does not say comes first.
std::string design_words(const RunResult& result) {
  if (!result.surface) return "<strong>Nothing was measured against a design.</strong> ";
  if (result.mesh_design()) return "The design is a mesh: all of this is about its facets. ";
  return {};
}

const char* passed_sentence(const RunResult& result) {
  return result.surface ? "Every gate figure is proven inside its limit."
                        : "The program was cut in its stock, and no fault was found on the way.";
}

bool has_open_figure(const RunResult& result) {
  return result.verdict == Verdict::indeterminate;
}

/// "coverage 98.99 %, limit ≥ 99.00 %"
std::string against_limit(const GateFigure& figure) {
  std::string out = figure.name + " " + figure.measured;
  if (!figure.limit.empty()) out += ", limit " + std::string(figure.relation) + figure.limit;
  if (figure.standing == Standing::beyond || figure.standing == Standing::undecided)
    out += std::string(": ") + name(figure.standing);
  return out;
}

bool is_about_reach(const GateFigure& figure) {
  return figure.name == "unreachable" || figure.name == "unavoidable uncut";
}

bool is_told(const GateFigure& figure) {
  return figure.standing == Standing::beyond || figure.standing == Standing::undecided ||
         !figure.limit.empty();
}

std::vector<std::string> escaped(std::vector<std::string> texts) {
  for (std::string& text : texts) text = escape_markup(text);
  return texts;
}

/// The figures that are said beside the verdict.
std::vector<std::string> notes_of(const StageResult& stage) {
  std::vector<std::string> out;
  if (!stage.ran) return out;
  if (!stage.ran->deviation) return escaped(stage_notes(stage));
  const verifier::StageDeviation& d = *stage.ran->deviation;
  const bool out_of_reach = unreachable_area_mm2(d).low > 0 || d.unreachable_area_mm2 > 0;
  for (const std::string& note : stage_notes(stage))
    if (!note.starts_with("unreachable ") && !note.starts_with("missing stock "))
      out.push_back(escape_markup(note));
  for (const GateFigure& figure : gate_figures(stage)) {
    const bool missing = figure.name == "missing stock" && d.missing_stock_mm.low > 0;
    if (missing || (is_about_reach(figure) && (out_of_reach || is_told(figure))))
      out.push_back(escape_markup(against_limit(figure)));
  }
  // Where no part is proven to be out of reach, samples may still be.
  if (unreachable_area_mm2(d).high <= 0 && d.unreachable_area_mm2 > 0)
    out = escaped(stage_notes(stage));
  return out;
}

std::vector<std::string> names_of(const RunResult& result) {
  std::vector<std::string> names;
  for (const StageResult& stage : result.stages) names.push_back(stage.name);
  return names;
}

/// Of a stage that ran and did not pass.
std::vector<std::string> placeless(const RunResult& result, std::size_t index) {
  const StageResult& stage = result.stages[index];
  std::vector<std::string> out;
  if (headlines(stage).empty()) {
    for (const std::string& reason : stage.decision.reasons)
      if (!is_note(reason)) out.push_back(escape_markup(reason));
    return out;
  }
  if (!stage.ran->deviation) return out;
  bool reach_fails = false;
  for (const GateFigure& figure : gate_figures(stage)) {
    const bool fails = figure.standing == Standing::beyond;
    if (figure.name == "coverage" && fails) out.push_back(escape_markup(against_limit(figure)));
    reach_fails |= is_about_reach(figure) && (fails || figure.standing == Standing::undecided);
  }
  const std::string highest =
      verifier::out_of_reach_text(stage.ran->deviation->field, names_of(result));
  if (reach_fails && !highest.empty()) out.push_back(escape_markup(highest.substr(2)));
  return out;
}

}  // namespace

std::string verdict_lines(const RunResult& result) {
  if (result.verdict == Verdict::pass)
    return fmt::format("<p>{}{}</p>\n", design_words(result), passed_sentence(result));
  StageList list(result);
  for (std::size_t i = 0; i < result.stages.size(); ++i) {
    const std::vector<std::string> kinds = headlines(result.stages[i]);
    if (!kinds.empty()) list.add(i, "<strong>" + escape_markup(joined(kinds, ", ")) + "</strong>");
  }
  std::string about = design_words(result);
  if (has_open_figure(result))
    about +=
        "Nothing is proven beyond a limit, but a certified interval still holds one: neither "
        "pass nor fail can be stated.";
  return (about.empty() ? about : "<p>" + about + "</p>\n") + list.take("reasons headlines");
}

std::string notes_list(const RunResult& result) {
  StageList list(result);
  for (std::size_t i = 0; i < result.stages.size(); ++i)
    if (const std::string notes = joined(notes_of(result.stages[i]), "; "); !notes.empty())
      list.add(i, notes);
  return list.take("reasons notes");
}

std::string placeless_reasons(const RunResult& result) {
  StageList list(result);
  for (std::size_t i = 0; i < result.stages.size(); ++i) {
    if (!result.stages[i].ran || result.stages[i].verdict() == Verdict::pass) continue;
    for (const std::string& line : placeless(result, i)) list.add(i, line);
  }
  return list.take("reasons");
}

}  // namespace limitgauge::reports::html
