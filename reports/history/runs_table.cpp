#include "reports/history/runs_table.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "reports/html/markup.h"
#include "reports/text/text.h"

namespace limitgauge::reports::history_report {
namespace {

using html::Row;

/// Beyond it a figure fails, whatever the others do.
bool is_beyond(const Column& column, const Cell& cell) {
  if (!cell.value || !cell.limit) return false;
  return column.metric == "coverage" ? cell.value->high < *cell.limit
                                     : cell.value->low > *cell.limit;
}

std::string trend_markup(const Cell& cell) {
  const std::string text = trend(cell);
  if (text.empty()) return {};
  const std::string_view word = trend_word(cell);
  const char* css = word == "worse" ? "worse" : word == "better" ? "better" : "level";
  if (text == "=") return "<small class=\"level\">same</small>";
  return fmt::format("<small class=\"{}\">{}</small>", css, text);
}

std::string figure_cell(const Column& column, const FigureColumn& shown, const Cell& cell) {
  if (!cell.value) return "–";
  std::string out = html::typeset(shown.figure(cell));
  if (is_beyond(column, cell))
    out += fmt::format("<small class=\"worse\">limit {}</small>", shown.limit(cell));
  return out + trend_markup(cell);
}

std::string named(const history::Entry& run) {
  std::string out;
  if (!run.commit.empty())
    out += fmt::format("<code title=\"{}\">{}</code>", escape_markup(run.commit),
                       escape_markup(short_commit(run.commit)));
  if (!run.label.empty()) out += (out.empty() ? "" : " ") + escape_markup(run.label);
  return out.empty() ? "–" : out;
}

std::string stages_that_did_not_pass(const history::Entry& run) {
  std::string out;
  for (const history::StageVerdict& one : run.stages)
    if (one.verdict == "fail" || one.verdict == "indeterminate")
      out += (out.empty() ? "" : ", ") + escape_markup(one.stage);
  return out.empty() ? out : "<small>" + out + "</small>";
}

}  // namespace

std::string verdict_badge(std::string_view verdict) {
  using verifier::Verdict;
  for (const Verdict one : {Verdict::pass, Verdict::fail, Verdict::indeterminate, Verdict::not_run})
    if (verdict == verifier::name(one)) return html::badge(one);
  return escape_markup(verdict);
}

std::string runs_table(const JobHistory& job, std::size_t index) {
  std::vector<FigureColumn> shown;
  std::vector<html::Column> columns = {
      {"Run", true}, {"Date, UTC"}, {"Commit, label"}, {"Verdict"}};
  for (std::size_t i = 0; i < job.columns.size(); ++i) {
    shown.emplace_back(job, i);
    const std::string unit = shown[i].unit().empty() ? "" : ", " + shown[i].unit();
    columns.push_back({escape_markup(shown[i].title() + unit), true});
  }
  std::vector<Row> rows;
  for (auto run = job.runs.rbegin(); run != job.runs.rend(); ++run) {
    Row& row = rows.emplace_back();
    row.attributes = fmt::format(" id=\"run-{}\" data-run=\"{}\"", run->entry.id, run->entry.id);
    row.cells = {fmt::format("<a href=\"#run-{0}\">{0}</a>", run->entry.id),
                 escape_markup(moment(run->entry.created)), named(run->entry),
                 verdict_badge(run->entry.verdict) + stages_that_did_not_pass(run->entry)};
    for (std::size_t i = 0; i < job.columns.size(); ++i)
      row.cells.push_back(figure_cell(job.columns[i], shown[i], run->cells[i]));
  }
  return fmt::format("<div data-runs=\"{}\">\n", index) +
         html::table("Runs, newest first, each held against the one before it.", columns, rows) +
         "</div>\n";
}

}  // namespace limitgauge::reports::history_report
