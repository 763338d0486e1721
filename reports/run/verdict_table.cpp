#include <algorithm>
#include <array>
#include <sstream>

#include "reports/run/gate_figures.h"
#include "reports/run/report.h"
#include "reports/text/text.h"

namespace limitgauge::reports {
namespace {

constexpr std::size_t kColumns = 8;
constexpr std::size_t kVerdictColumn = 3;
constexpr std::size_t kGougeColumn = 4, kUncutColumn = 5;
constexpr std::size_t kGap = 2;
constexpr std::size_t kShortestName = 5;
using Row = std::array<std::string, kColumns>;
using Widths = std::array<std::size_t, kColumns>;
using Columns = std::vector<std::size_t>;
/// On a narrow terminal the intervals stand on a line of their own below their stage.
const Columns kAll = {0, 1, 2, 3, 4, 5, 6, 7};
const Columns kWithoutIntervals = {0, 1, 2, 3, 6, 7};

const char* relation(Standing standing) {
  switch (standing) {
    case Standing::within:
      return " ≤ ";
    case Standing::beyond:
      return " > ";
    default:
      return " ? ";
  }
}

/// "[0.076, 0.41] ≤ 10 µm": what is proven, how it stands, and the limit.
std::string against_limit(const GateFigure& figure) {
  if (figure.standing == Standing::not_run) return "–";
  if (figure.limit.empty()) return figure.measured;
  const std::string numbers = figure.measured.substr(0, figure.measured.rfind(' '));
  return numbers + relation(figure.standing) + figure.limit;
}

std::string verdict_word(verifier::Verdict verdict) {
  std::string word = verifier::name(verdict);
  std::replace(word.begin(), word.end(), '_', ' ');
  return word;
}

Row row_of(const StageResult& stage) {
  const std::vector<GateFigure> figures = gate_figures(stage);
  return {clean_text(stage.name),
          clean_text(stage.tool),
          clean_text(stage.program.empty() ? stage.strategy : stage.program),
          verdict_word(stage.verdict()),
          against_limit(figures[0]),
          against_limit(figures[1]),
          stage.ran ? figures[2].measured : "–",
          stage.ran ? duration_text(stage.seconds) : "–"};
}

std::size_t total(const Widths& widths, const Columns& columns) {
  std::size_t sum = kGap * (columns.size() - 1);
  for (const std::size_t c : columns) sum += widths[c];
  return sum;
}

/// Widths of the columns; the three names give way when the row is too long for a terminal.
Widths fitted_widths(const std::vector<Row>& rows, const Columns& columns, std::size_t width) {
  Widths widths{};
  for (const Row& row : rows)
    for (std::size_t c = 0; c < kColumns; ++c) widths[c] = std::max(widths[c], code_points(row[c]));
  while (total(widths, columns) > width) {
    std::size_t& widest = *std::max_element(widths.begin(), widths.begin() + kVerdictColumn);
    if (widest <= kShortestName) break;
    --widest;
  }
  return widths;
}

const char* colour_of(verifier::Verdict verdict) {
  switch (verdict) {
    case verifier::Verdict::pass:
      return "\x1b[32m";
    case verifier::Verdict::fail:
      return "\x1b[1;31m";
    case verifier::Verdict::indeterminate:
      return "\x1b[1;33m";
    case verifier::Verdict::not_run:
      break;
  }
  return "\x1b[2m";
}

std::string painted(const std::string& text, verifier::Verdict verdict, bool colour) {
  return colour ? colour_of(verdict) + text + "\x1b[0m" : text;
}

std::string line_of(const Row& row, const Widths& widths, const Columns& columns,
                    verifier::Verdict verdict, bool colour) {
  std::string line;
  for (const std::size_t c : columns) {
    const std::string cell = shortened(row[c], widths[c]);
    const std::string padding(widths[c] - code_points(cell), ' ');
    const bool right_aligned = c + 2 >= kColumns;
    const std::string shown = c == kVerdictColumn ? painted(cell, verdict, colour) : cell;
    if (!line.empty()) line += std::string(kGap, ' ');
    line += right_aligned ? padding + shown : shown + padding;
  }
  line.erase(line.find_last_not_of(' ') + 1);
  return line + '\n';
}

/// `text` broken at spaces so that no line is longer than `width`; later lines are indented.
std::string wrapped(const std::string& text, std::size_t indent, std::size_t width) {
  std::istringstream words(text);
  std::string out, word;
  std::size_t at = 0;
  while (words >> word) {
    const std::size_t length = code_points(word);
    if (at > indent && at + 1 + length > width) {
      out += '\n' + std::string(indent, ' ');
      at = indent;
    } else if (at > 0) {
      out += ' ';
      ++at;
    }
    out += word;
    at += length;
  }
  return out + '\n';
}

}  // namespace

std::string verdict_table(const RunResult& result, bool colour, std::size_t width) {
  std::vector<Row> rows = {
      {"stage", "tool", "strategy", "verdict", "gouge", "uncut", "coverage", "time"}};
  for (const StageResult& stage : result.stages) rows.push_back(row_of(stage));
  Widths widths = fitted_widths(rows, kAll, width);
  const bool narrow = total(widths, kAll) > width;
  const Columns& columns = narrow ? kWithoutIntervals : kAll;
  if (narrow) widths = fitted_widths(rows, columns, width);
  std::string out = line_of(rows[0], widths, columns, verifier::Verdict::not_run, false);
  for (std::size_t i = 0; i < result.stages.size(); ++i) {
    const Row& row = rows[i + 1];
    out += line_of(row, widths, columns, result.stages[i].verdict(), colour);
    if (narrow && result.stages[i].ran)
      out += "  gouge " + row[kGougeColumn] + "   uncut " + row[kUncutColumn] + '\n';
  }
  for (const StageResult& stage : result.stages)
    for (const std::string& note : stage_notes(stage))
      out += wrapped(clean_text(stage.name) + ": " + note, 4, width);
  for (const StageResult& stage : result.stages) {
    if (stage.verdict() == verifier::Verdict::pass) continue;
    for (const std::string& reason : stage.decision.reasons)
      if (!is_note(reason))
        out += wrapped(clean_text(stage.name) + ": " + clean_text(reason), 4, width);
  }
  return out + "verdict: " + painted(verdict_word(result.verdict), result.verdict, colour) + '\n';
}

}  // namespace limitgauge::reports
