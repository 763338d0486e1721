#include <algorithm>

#include "reports/compare/comparison_text.h"
#include "reports/compare/report.h"
#include "reports/text/terminal_table.h"
#include "reports/text/text.h"

namespace limitgauge::reports::compare {
namespace {

constexpr std::size_t kBaseColumn = 2, kFloorColumn = 5;
/// A terminal is for the worst of them; the files have all.
constexpr std::size_t kMostOnTerminal = 8;

Tone tone_of(Judgement judgement) {
  switch (judgement) {
    case Judgement::better:
      return Tone::good;
    case Judgement::worse:
      return Tone::bad;
    default:
      return Tone::faint;
  }
}

/// What a reader looks for first, and what moved.
bool is_shown(const FigureChange& figure, bool all) {
  return all || figure.metric->source == record::Source::certified ||
         figure.metric->id == "machining_time_s" || figure.judgement == Judgement::better ||
         figure.judgement == Judgement::worse;
}

TerminalTable::Cell judgement_cell(Judgement judgement) {
  return {name(judgement), tone_of(judgement)};
}

/// What a narrow terminal has no room for goes in this order: the floor, the base run; then the
/// stages' names are shortened.
TerminalTable table_of(const Comparison& comparison, std::size_t width, bool all) {
  constexpr TerminalTable::Column kStage = {false, true}, kText, kNumber = {true};
  TerminalTable table({kStage, kText, kNumber, kNumber, kNumber, kNumber, kText});
  table.add_row({{"stage"}, {"figure"}, {"base"}, {"new"}, {"change"}, {"floor"}, {"judgement"}});
  for (const StageComparison& stage : comparison.stages) {
    for (const FigureChange& figure : stage.figures) {
      if (!is_shown(figure, all)) continue;
      const FigureText text = figure_text(figure);
      table.add_row({{stage.name},
                     {std::string(figure.metric->label)},
                     {text.base},
                     {text.now},
                     {text.change},
                     {text.floor.empty() ? "–" : text.floor},
                     judgement_cell(figure.judgement)});
    }
  }
  for (const std::size_t spare : {kFloorColumn, kBaseColumn})
    if (table.width() > width) table.hide(spare);
  table.fit(width);
  return table;
}

std::string remark_line(const std::string& prefix, const Remark& remark, bool colour) {
  const std::string text = prefix + clean_text(remark.text);
  if (remark.judgement == Judgement::not_judged) return text + '\n';
  return text + ": " + painted(name(remark.judgement), tone_of(remark.judgement), colour) + '\n';
}

std::string named_place(const FoundPlace& place, const std::string& stage) {
  return clean_text(line_text(place, stage)) + at_text(place);
}

std::string finding_line(const StageComparison& stage, const FindingChange& change, bool colour) {
  const FoundPlace& place = change.now ? *change.now : *change.base;
  return clean_text(stage.name) + ": " + name(change) + " " + clean_text(kind_text(change.kind)) +
         " " + depth_text(change) + ", " + named_place(place, stage.name) + ": " +
         painted(name(change.judgement), tone_of(change.judgement), colour) + '\n';
}

std::string places_of(const StageComparison& stage, bool colour) {
  std::string out;
  for (const FigureChange& figure : stage.figures)
    if (figure.where && figure.judgement == Judgement::worse)
      out += clean_text(stage.name) + ": deepest " + std::string(figure.metric->label) + " " +
             measured_length(figure.where->depth_mm) + ", " +
             named_place(*figure.where, stage.name) + '\n';
  const std::size_t shown = std::min(stage.findings.size(), kMostOnTerminal);
  for (std::size_t i = 0; i < shown; ++i) out += finding_line(stage, stage.findings[i], colour);
  if (stage.findings.size() > shown)
    out += clean_text(stage.name) + ": and " + grouped(stage.findings.size() - shown) +
           " more findings that changed\n";
  return out;
}

}  // namespace

std::string text_table(const Comparison& comparison, bool colour, std::size_t width, bool all) {
  const TerminalTable table = table_of(comparison, width, all);
  std::string out;
  if (!comparison.base.name.empty())
    out = "base: " + clean_text(comparison.base.name) +
          "; new: " + clean_text(comparison.now.name) + '\n';
  for (std::size_t i = 0; table.rows() > 1 && i < table.rows(); ++i) out += table.line(i, colour);
  for (const Remark& remark : comparison.remarks) out += remark_line("", remark, colour);
  for (const StageComparison& stage : comparison.stages) {
    for (const Remark& remark : stage.remarks)
      out += remark_line(clean_text(stage.name) + ": ", remark, colour);
    out += places_of(stage, colour);
  }
  return out +
         "comparison: " + painted(summary(comparison), tone_of(comparison.judgement()), colour) +
         '\n';
}

}  // namespace limitgauge::reports::compare
