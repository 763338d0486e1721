#include <algorithm>

#include "reports/history/history_report.h"
#include "reports/history/shown.h"
#include "reports/text/text.h"

namespace limitgauge::reports::history_report {
namespace {

constexpr std::size_t kGap = 2, kLongestLabel = 24;

struct TextColumn {
  bool right = false;
  std::vector<std::string> cells;  ///< its title first
};

TextColumn column(const JobHistory& job, const std::string& title, bool right,
                  const auto& text_of) {
  TextColumn out{right, {title}};
  for (const Run& run : job.runs) out.cells.push_back(text_of(run));
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
      column(job, "verdict", false, [](const Run& run) { return clean_text(run.entry.verdict); }));
}

/// Those that a line has room for: the whole run's and the last stage's, unless they were chosen.
bool is_shown(const JobHistory& job, const Column& one, const Choice& choice) {
  return !choice.metrics.empty() || !choice.stages.empty() || one.stage.empty() ||
         one.stage == job.columns.back().stage;
}

void add_figures(const JobHistory& job, const Choice& choice, std::vector<TextColumn>& columns) {
  for (std::size_t i = 0; i < job.columns.size(); ++i) {
    if (!is_shown(job, job.columns[i], choice)) continue;
    const ShownColumn shown(job, i);
    const std::string unit = shown.unit().empty() ? "" : ", " + shown.unit();
    columns.push_back(column(job, shown.title() + unit, true,
                             [&](const Run& run) { return shown.figure(run.cells[i]); }));
    columns.push_back(column(job, "", false, [&](const Run& run) { return trend(run.cells[i]); }));
  }
}

std::size_t width_of(const TextColumn& column) {
  std::size_t width = 0;
  for (const std::string& cell : column.cells) width = std::max(width, code_points(cell));
  return width;
}

std::string line(const std::vector<TextColumn>& columns, const std::vector<std::size_t>& widths,
                 std::size_t row) {
  std::string out;
  for (std::size_t i = 0; i < columns.size(); ++i) {
    const std::string& cell = columns[i].cells[row];
    const std::string padding(widths[i] - code_points(cell), ' ');
    if (i > 0) out += std::string(columns[i].cells.front().empty() ? 1 : kGap, ' ');
    out += columns[i].right ? padding + cell : cell + padding;
  }
  out.erase(out.find_last_not_of(' ') + 1);
  return out + '\n';
}

/// Trends and verdicts in colour; they say the same without.
std::string painted(std::string text) {
  const auto paint = [&](std::string_view word, std::string_view code) {
    for (std::size_t at = 0; (at = text.find(word, at)) != std::string::npos;) {
      const std::string dressed = std::string(code) + std::string(word) + "\x1b[0m";
      text.replace(at, word.size(), dressed);
      at += dressed.size();
    }
  };
  paint("↑ worse", "\x1b[1;31m");
  paint("↓ worse", "\x1b[1;31m");
  paint("↑ better", "\x1b[32m");
  paint("↓ better", "\x1b[32m");
  return text;
}

std::string job_table(const JobHistory& job, const Choice& choice, bool colour) {
  std::vector<TextColumn> columns;
  add_heads(job, columns);
  add_figures(job, choice, columns);
  std::vector<std::size_t> widths;
  for (const TextColumn& one : columns) widths.push_back(width_of(one));
  std::string out;
  for (std::size_t row = 0; row <= job.runs.size(); ++row) {
    const std::string text = line(columns, widths, row);
    out += colour ? painted(text) : text;
  }
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
