#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <ostream>

#include "reports/compare/comparison_text.h"
#include "reports/compare/report.h"
#include "reports/html/markup.h"
#include "reports/html/shell.h"
#include "reports/text/interval_text.h"

namespace limitgauge::reports::compare {
namespace {

/// A page of more rows than this helps nobody; compare.json has all.
constexpr std::size_t kMostFindings = 200;

struct Look {
  const char* css;
  const char* sign;
};

Look look_of(Judgement judgement) {
  switch (judgement) {
    case Judgement::better:
      return {"pass", "▲"};
    case Judgement::worse:
      return {"fail", "▼"};
    case Judgement::same:
      return {"none", "="};
    case Judgement::not_judged:
      break;
  }
  return {"none", "·"};
}

std::string badge(Judgement judgement) {
  const Look look = look_of(judgement);
  return html::badge(look.css, look.sign, name(judgement));
}

/// The words come from here and begin with a plain letter.
std::string capital(std::string words) {
  words.front() = static_cast<char>(std::toupper(static_cast<unsigned char>(words.front())));
  return words;
}

std::string verdict_badge(std::optional<verifier::Verdict> verdict) {
  return verdict ? html::badge(*verdict) : "–";
}

std::string remark_list(const std::vector<Remark>& remarks) {
  if (remarks.empty()) return {};
  std::string out = "<ul class=\"reasons\">\n";
  for (const Remark& remark : remarks)
    out += fmt::format("<li>{} {}</li>\n",
                       remark.judgement == Judgement::not_judged ? "" : badge(remark.judgement),
                       escape_markup(remark.text));
  return out + "</ul>\n";
}

std::string place_cell(const FoundPlace& place, const std::string& stage) {
  std::string line = "–";
  if (place.line) line = fmt::format("line {}", *place.line);
  if (!place.stage.empty() && place.stage != stage) line += " of " + escape_markup(place.stage);
  if (!place.line_text.empty()) line += " <code>" + escape_markup(place.line_text) + "</code>";
  return line;
}

/// What a reader came for: everything that is worse, each with a link to its stage.
std::string regressions(const Comparison& comparison) {
  std::string out;
  const auto item = [&out](const std::string& text) { out += "<li>" + text + "</li>\n"; };
  for (const Remark& remark : comparison.remarks)
    if (remark.judgement == Judgement::worse) item(escape_markup(remark.text));
  for (std::size_t i = 0; i < comparison.stages.size(); ++i) {
    const StageComparison& stage = comparison.stages[i];
    const std::string link =
        fmt::format("<a href=\"#{}\">{}</a>: ", html::stage_anchor(i), escape_markup(stage.name));
    for (const Remark& remark : stage.remarks)
      if (remark.judgement == Judgement::worse) item(link + escape_markup(remark.text));
    for (const FigureChange& figure : stage.figures) {
      if (figure.judgement != Judgement::worse) continue;
      const FigureText text = figure_text(figure);
      item(link + fmt::format("{} {} before, now {}{}; {}", figure.metric->label, text.base,
                              text.now,
                              figure.where ? ", " + place_cell(*figure.where, stage.name) : "",
                              escape_markup(figure.why)));
    }
    std::size_t findings = 0;
    for (const FindingChange& change : stage.findings)
      if (change.judgement == Judgement::worse) ++findings;
    if (findings > 0)
      item(link + grouped(findings) + (findings == 1 ? " finding" : " findings") +
           " new or deeper");
  }
  return out.empty() ? out : "<ul class=\"reasons\">\n" + out + "</ul>\n";
}

std::string masthead(const Comparison& comparison) {
  const Judgement judgement = comparison.judgement();
  const char* css = judgement == Judgement::worse    ? "fail"
                    : judgement == Judgement::better ? "pass"
                                                     : "none";
  // What is worse stands on top already.
  std::vector<Remark> others = comparison.remarks;
  std::erase_if(others, [](const Remark& r) { return r.judgement == Judgement::worse; });
  const auto run = [](const RunHead& head) {
    const std::string name =
        head.name.empty() ? std::string() : "<strong>" + escape_markup(head.name) + "</strong>, ";
    return fmt::format("{}{}, limitgauge {} {}", name, escape_markup(head.created),
                       escape_markup(head.version), html::badge(head.verdict));
  };
  return fmt::format(
             "<header><p class=\"kind\">Limitgauge · comparison of two results</p>"
             "<h1>{}</h1>\n<div class=\"verdict {}\"><p class=\"word\">{}</p>\n{}</div>\n",
             escape_markup(comparison.now.job), css, escape_markup(summary(comparison)),
             regressions(comparison)) +
         html::terms(
             {{"Base", run(comparison.base)},
              {"New", run(comparison.now)},
              {"Machining time", duration_text(comparison.base.machining_time_s) + " before, now " +
                                     duration_text(comparison.now.machining_time_s)}}) +
         remark_list(others) + "</header>\n";
}

html::Row figure_row(const FigureChange& figure) {
  const FigureText text = figure_text(figure);
  return {{std::string(figure.metric->label), text.base, text.now, text.change,
           text.floor.empty() ? "–" : text.floor,
           fmt::format("<span class=\"sum\">{} <small>{}</small></span>", badge(figure.judgement),
                       escape_markup(figure.why))},
          {}};
}

/// What the columns of the two runs are called.
struct RunTitles {
  std::string base, now;
};

std::string figures_table(const StageComparison& stage, bool judged, const char* caption,
                          const RunTitles& titles) {
  std::vector<html::Row> rows;
  for (const FigureChange& figure : stage.figures)
    if ((figure.judgement != Judgement::not_judged) == judged) rows.push_back(figure_row(figure));
  if (rows.empty()) return {};
  return html::table(caption,
                     {{"Figure"},
                      {titles.base, true},
                      {titles.now, true},
                      {"Change", true},
                      {"Noise floor", true},
                      {"Judgement"}},
                     rows);
}

std::string figures_part(const StageComparison& stage, const RunTitles& titles) {
  if (stage.figures.empty()) return "<p>No figures: not both runs measured this stage.</p>\n";
  return figures_table(stage, true, "Figures", titles) +
         "<details><summary>Figures that are not judged</summary>\n" +
         figures_table(stage, false, "Shown for information", titles) + "</details>\n";
}

html::Row finding_row(const StageComparison& stage, const FindingChange& change,
                      const LengthUnit& unit) {
  const FoundPlace& place = change.now ? *change.now : *change.base;
  std::string kind = escape_markup(kind_text(change.kind));
  if (!place.by.empty()) kind += " <small>" + escape_markup(place.by) + "</small>";
  const auto depth = [&](const std::optional<FoundPlace>& p) {
    return p ? html::typeset(measured_number(p->depth_mm, unit)) : std::string("–");
  };
  return {{std::string(name(change)), kind, depth(change.base), depth(change.now),
           change.base && change.now ? measured_number(change.moved_mm, {}) : "–",
           html::coordinates(place.at_mm), place_cell(place, stage.name), badge(change.judgement)},
          {}};
}

/// Of all depths of the stage's findings.
LengthUnit depth_unit(const StageComparison& stage) {
  double largest_mm = 0;
  for (const FindingChange& change : stage.findings)
    for (const std::optional<FoundPlace>& place : {change.base, change.now})
      if (place) largest_mm = std::max(largest_mm, std::abs(place->depth_mm));
  return unit_for(largest_mm);
}

std::string findings_table(const StageComparison& stage) {
  if (stage.findings.empty())
    return fmt::format("<p>No finding is new, vanished or differs; {} the same.</p>\n",
                       grouped(stage.same_findings));
  const LengthUnit unit = depth_unit(stage);
  std::vector<html::Row> rows;
  for (const FindingChange& change : stage.findings) {
    if (rows.size() == kMostFindings) break;
    rows.push_back(finding_row(stage, change, unit));
  }
  std::string caption =
      fmt::format("Findings that differ; {} the same", grouped(stage.same_findings));
  if (rows.size() < stage.findings.size())
    caption += fmt::format("; the first {} of {}, all are in compare.json", grouped(rows.size()),
                           grouped(stage.findings.size()));
  return html::table(caption,
                     {{"Finding"},
                      {"Kind"},
                      {std::string("Base depth, ") + unit.symbol, true},
                      {std::string("New depth, ") + unit.symbol, true},
                      {"Moved, mm", true},
                      {"X, Y, Z, mm", true},
                      {"Program"},
                      {"Judgement"}},
                     rows);
}

std::string worst_place(const StageComparison& stage) {
  std::string out;
  for (const FigureChange& figure : stage.figures)
    if (figure.where && figure.judgement == Judgement::worse)
      out += fmt::format("<p>Deepest {} of the new run: {} at ({}), {}.</p>\n",
                         figure.metric->label, measured_length(figure.where->depth_mm),
                         html::coordinates(figure.where->at_mm),
                         place_cell(*figure.where, stage.name));
  return out;
}

std::string stage_section(const StageComparison& stage, std::size_t index,
                          const RunTitles& titles) {
  return fmt::format(
      "<section id=\"{}\"><h2>{}</h2>\n<p>Verdict: {} before, now {}.</p>\n{}{}{}{}</section>\n",
      html::stage_anchor(index), escape_markup(stage.name), verdict_badge(stage.base),
      verdict_badge(stage.now), remark_list(stage.remarks), worst_place(stage),
      figures_part(stage, titles), findings_table(stage));
}

}  // namespace

void write_html(const Comparison& comparison, std::ostream& out) {
  out << html::shell_head(comparison.now.job + ", compared", {}) << masthead(comparison)
      << "<main id=\"figures\" tabindex=\"-1\">\n";
  const RunTitles titles{capital(escape_markup(base_title(comparison))),
                         capital(escape_markup(new_title(comparison)))};
  for (std::size_t i = 0; i < comparison.stages.size(); ++i)
    out << stage_section(comparison.stages[i], i, titles);
  out << "</main>\n<footer>A figure is worse or better where it changed beyond its noise floor: "
         "for certified figures "
         "the widest certified interval that either run accepted, for statistics of the deviation "
         "a "
         "tenth of it, 0.1 points of coverage, a voxel for what was read off the stock. A "
         "certified "
         "figure is also where the two intervals do not meet, and where the depth reached, the "
         "bound "
         "promised and the deepest sample all moved the same way. What is not judged is shown for "
         "information.</footer>\n"
      << html::shell_end({}, {});
}

}  // namespace limitgauge::reports::compare
