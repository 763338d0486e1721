#include <algorithm>
#include <utility>

#include "reports/history/figure_column.h"
#include "reports/history/history_report.h"
#include "reports/text/terminal_table.h"
#include "reports/text/text.h"

namespace limitgauge::reports::history_report {
namespace {

constexpr std::size_t kLongestLabel = 24;

using TextCell = TerminalTable::Cell;

struct TextColumn {
  TerminalTable::Column column;
  std::vector<TextCell> cells;  ///< its title first
};

template <class TextOf>
TextColumn column(const JobHistory& job, const std::string& title, bool right, TextOf text_of) {
  TextColumn out{{right}, {TextCell{title}}};
  for (const Run& run : job.runs) out.cells.push_back(TextCell{text_of(run)});
  return out;
}

/// Trends in colour; they say the same without.
TextColumn trends(const JobHistory& job, std::size_t index) {
  TextColumn out{{false, false, 1}, {TextCell{}}};
  for (const Run& run : job.runs) {
    const std::string_view word = trend_word(run.cells[index]);
    const Tone tone = word == "worse" ? Tone::bad : word == "better" ? Tone::good : Tone::plain;
    out.cells.push_back(TextCell{trend(run.cells[index]), tone});
  }
  return out;
}

bool any(const JobHistory& job, std::string history::Entry::*name) {
  return std::any_of(job.runs.begin(), job.runs.end(),
                     [&](const Run& run) { return !(run.entry.*name).empty(); });
}

void add_heads(const JobHistory& job, std::vector<TextColumn>& columns) {
  columns.push_back(
      column(job, "run", true, [](const Run& run) { return std::to_string(run.entry.id); }));
  columns.push_back(
      column(job, "date, UTC", false, [](const Run& run) { return moment(run.entry.created); }));
  if (any(job, &history::Entry::commit))
    columns.push_back(column(job, "commit", false,
                             [](const Run& run) { return short_commit(run.entry.commit); }));
  if (any(job, &history::Entry::label))
    columns.push_back(column(job, "label", false, [](const Run& run) {
      return shortened(run.entry.label, kLongestLabel);
    }));
  columns.push_back(
      column(job, "verdict", false, [](const Run& run) { return run.entry.verdict; }));
}

/// Those that a line has room for, unless they were chosen: the whole run's and the last stage's,
/// of tolerances the margin.
bool is_shown(const JobHistory& job, const Column& one, const Choice& choice) {
  if (!choice.metrics.empty()) return true;
  if (one.metric.starts_with("robust_")) return false;
  return !choice.stages.empty() || one.stage.empty() || one.stage == job.columns.back().stage;
}

void add_figures(const JobHistory& job, const Choice& choice, std::vector<TextColumn>& columns) {
  for (std::size_t i = 0; i < job.columns.size(); ++i) {
    if (!is_shown(job, job.columns[i], choice)) continue;
    const FigureColumn shown(job, i);
    const std::string unit = shown.unit().empty() ? "" : ", " + shown.unit();
    columns.push_back(column(job, shown.title() + unit, true,
                             [&](const Run& run) { return shown.figure(run.cells[i]); }));
    columns.push_back(trends(job, i));
  }
}

std::string job_table(const JobHistory& job, const Choice& choice, bool colour) {
  std::vector<TextColumn> columns;
  add_heads(job, columns);
  add_figures(job, choice, columns);
  std::vector<TerminalTable::Column> kinds;
  for (const TextColumn& one : columns) kinds.push_back(one.column);
  TerminalTable table(std::move(kinds));
  std::string out;
  for (std::size_t row = 0; row <= job.runs.size(); ++row) {
    std::vector<TextCell> cells;
    for (const TextColumn& one : columns) cells.push_back(one.cells[row]);
    table.add_row(std::move(cells));
  }
  for (std::size_t row = 0; row < table.rows(); ++row) out += table.line(row, colour);
  return out;
}

}  // namespace

std::string history_table(const Overview& overview, bool colour) {
  std::string out;
  for (const JobHistory& job : overview.jobs) {
    if (!out.empty()) out += '\n';
    out += shortened(job.job, 60) + ": " + std::to_string(job.runs.size()) +
           (job.runs.size() == 1 ? " run\n" : " runs\n") + job_table(job, overview.choice, colour);
    if (job.changes_meaning()) out += std::string(kNewMeaning) + '\n';
  }
  return out;
}

}  // namespace limitgauge::reports::history_report
