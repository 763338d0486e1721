#include <algorithm>
#include <array>

#include "reports/compare/report.h"
#include "reports/compare/words.h"
#include "reports/text/text.h"

namespace limitgauge::reports::compare {
namespace {

constexpr std::size_t kColumns = 7;
constexpr std::size_t kJudgementColumn = 6;
constexpr std::size_t kGap = 2;
constexpr std::size_t kShortestName = 5;
/// A terminal is for the worst of them; the files have all.
constexpr std::size_t kMostFindings = 8;

struct Row {
  std::array<std::string, kColumns> cells;
  Judgement judgement = Judgement::not_judged;
};
using Widths = std::array<std::size_t, kColumns>;
using Columns = std::vector<std::size_t>;

std::string painted(const std::string& text, Judgement judgement, bool colour) {
  if (!colour) return text;
  switch (judgement) {
    case Judgement::better:
      return "\x1b[32m" + text + "\x1b[0m";
    case Judgement::worse:
      return "\x1b[1;31m" + text + "\x1b[0m";
    default:
      return "\x1b[2m" + text + "\x1b[0m";
  }
}

/// What a reader looks for first, and what moved.
bool is_shown(const FigureChange& figure, bool all) {
  return all || figure.metric->source == record::Source::certified ||
         figure.metric->id == "machining_time_s" || figure.judgement == Judgement::better ||
         figure.judgement == Judgement::worse;
}

std::vector<Row> rows_of(const Comparison& comparison, bool all) {
  std::vector<Row> rows = {
      {{"stage", "figure", "base", "new", "change", "floor", "judgement"}, Judgement::not_judged}};
  for (const StageComparison& stage : comparison.stages) {
    for (const FigureChange& figure : stage.figures) {
      if (!is_shown(figure, all)) continue;
      const FigureText text = figure_text(figure);
      rows.push_back(
          {{clean_text(stage.name), std::string(figure.metric->label), text.base, text.now,
            text.change, text.floor.empty() ? "–" : text.floor, name(figure.judgement)},
           figure.judgement});
    }
  }
  return rows;
}

std::size_t total(const Widths& widths, const Columns& columns) {
  std::size_t sum = kGap * (columns.size() - 1);
  for (const std::size_t c : columns) sum += widths[c];
  return sum;
}

struct Layout {
  Columns columns;
  Widths widths{};
};

/// What a narrow terminal has no room for goes in this order: the floor, the base run; then the
/// stages' names are shortened.
Layout fitted(const std::vector<Row>& rows, std::size_t width) {
  Layout out{{0, 1, 2, 3, 4, 5, 6}, {}};
  for (const Row& row : rows)
    for (std::size_t c = 0; c < kColumns; ++c)
      out.widths[c] = std::max(out.widths[c], code_points(row.cells[c]));
  for (const std::size_t spare : {std::size_t{5}, std::size_t{2}})
    if (total(out.widths, out.columns) > width) std::erase(out.columns, spare);
  while (total(out.widths, out.columns) > width && out.widths[0] > kShortestName) --out.widths[0];
  return out;
}

std::string line_of(const Row& row, const Layout& layout, bool is_head, bool colour) {
  std::string line;
  for (const std::size_t c : layout.columns) {
    const std::string cell = shortened(row.cells[c], layout.widths[c]);
    const std::string padding(layout.widths[c] - code_points(cell), ' ');
    if (!line.empty()) line += std::string(kGap, ' ');
    if (c == kJudgementColumn)
      line += is_head ? cell : painted(cell, row.judgement, colour);
    else
      line += c < 2 ? cell + padding : padding + cell;
  }
  return line + '\n';
}

std::string remark_line(const std::string& prefix, const Remark& remark, bool colour) {
  const std::string text = prefix + clean_text(remark.text);
  if (remark.judgement == Judgement::not_judged) return text + '\n';
  return text + ": " + painted(name(remark.judgement), remark.judgement, colour) + '\n';
}

std::string named_place(const FoundPlace& place, const std::string& stage) {
  return clean_text(line_text(place, stage)) + " at (" + fixed(place.at_mm.x, 3) + ", " +
         fixed(place.at_mm.y, 3) + ", " + fixed(place.at_mm.z, 3) + ")";
}

std::string finding_line(const StageComparison& stage, const FindingChange& change, bool colour) {
  const FoundPlace& place = change.now ? *change.now : *change.base;
  return clean_text(stage.name) + ": " + name(change) + " " + clean_text(kind_words(change.kind)) +
         " " + depth_text(change) + ", " + named_place(place, stage.name) + ": " +
         painted(name(change.judgement), change.judgement, colour) + '\n';
}

std::string places_of(const StageComparison& stage, bool colour) {
  std::string out;
  for (const FigureChange& figure : stage.figures)
    if (figure.where && figure.judgement == Judgement::worse)
      out += clean_text(stage.name) + ": deepest " + std::string(figure.metric->label) + " " +
             measured_length(figure.where->depth_mm) + ", " +
             named_place(*figure.where, stage.name) + '\n';
  const std::size_t shown = std::min(stage.findings.size(), kMostFindings);
  for (std::size_t i = 0; i < shown; ++i) out += finding_line(stage, stage.findings[i], colour);
  if (stage.findings.size() > shown)
    out += clean_text(stage.name) + ": and " + grouped(stage.findings.size() - shown) +
           " more findings that changed\n";
  return out;
}

}  // namespace

std::string text_table(const Comparison& comparison, bool colour, std::size_t width, bool all) {
  const std::vector<Row> rows = rows_of(comparison, all);
  const Layout layout = fitted(rows, width);
  std::string out;
  for (std::size_t i = 0; rows.size() > 1 && i < rows.size(); ++i)
    out += line_of(rows[i], layout, i == 0, colour);
  for (const Remark& remark : comparison.remarks) out += remark_line("", remark, colour);
  for (const StageComparison& stage : comparison.stages) {
    for (const Remark& remark : stage.remarks)
      out += remark_line(clean_text(stage.name) + ": ", remark, colour);
    out += places_of(stage, colour);
  }
  return out + "comparison: " + painted(summary(comparison), comparison.judgement(), colour) + '\n';
}

}  // namespace limitgauge::reports::compare
