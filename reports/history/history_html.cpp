#include <fmt/format.h>

#include <algorithm>
#include <ostream>

#include "reports/history/history_report.h"
#include "reports/history/runs_table.h"
#include "reports/html/markup.h"
#include "reports/html/shell.h"
#include "reports/text/embedded.h"
#include "reports/text/text.h"

namespace limitgauge::reports::history_report {
namespace {

using html::terms;

std::string job_anchor(std::size_t job) {
  return fmt::format("job-{}", job + 1);
}

std::string runs_words(std::size_t count) {
  return grouped(count) + (count == 1 ? " run" : " runs");
}

std::size_t shown_runs(const Overview& overview) {
  std::size_t count = 0;
  for (const JobHistory& job : overview.jobs) count += job.runs.size();
  return count;
}

std::string masthead(const Overview& overview) {
  const std::size_t shown = shown_runs(overview);
  std::string list;
  for (std::size_t i = 0; i < overview.jobs.size(); ++i) {
    const JobHistory& job = overview.jobs[i];
    list += fmt::format("<li><a href=\"#{}\">{}</a>: {}, the last one {}</li>\n", job_anchor(i),
                        escape_markup(job.job), runs_words(job.runs.size()),
                        verdict_badge(job.runs.back().entry.verdict));
  }
  const std::string runs =
      shown == overview.found
          ? runs_words(shown)
          : fmt::format("the newest {} of {}", grouped(shown), grouped(overview.found));
  return fmt::format(
             "<header><p class=\"kind\">Limitgauge · history of runs</p><h1>{}</h1>\n"
             "<ul>\n{}</ul>\n",
             escape_markup(overview.file), list) +
         terms({{"Runs", runs},
                {"Program version", "limitgauge " + escape_markup(overview.version)}}) +
         "</header>\n";
}

std::string passed_words(const JobHistory& job) {
  const auto passed = std::count_if(job.runs.begin(), job.runs.end(),
                                    [](const Run& run) { return run.entry.verdict == "pass"; });
  return fmt::format("{} of {}", grouped(static_cast<std::uint64_t>(passed)),
                     grouped(job.runs.size()));
}

/// Where the page's script draws; without it the table says the same.
std::string charts(std::size_t job) {
  return fmt::format(
      "<noscript><p class=\"note\">The charts need a script, which is switched off here. The table "
      "holds their figures.</p></noscript>\n<div data-chart=\"history\" data-job=\"{}\"></div>\n",
      job);
}

std::string job_section(const JobHistory& job, std::size_t index) {
  const history::Entry &first = job.runs.front().entry, &last = job.runs.back().entry;
  return fmt::format("<section id=\"{}\"><h2>{} {}</h2>\n", job_anchor(index),
                     escape_markup(job.job), verdict_badge(last.verdict)) +
         terms({{"Passed", passed_words(job)},
                {"First run shown", escape_markup(moment(first.created)) + " UTC"},
                {"Last run", escape_markup(moment(last.created)) + " UTC"}}) +
         (job.changes_meaning() ? fmt::format("<p class=\"note\"><strong>{}</strong></p>\n",
                                              escape_markup(kNewMeaning))
                                : std::string()) +
         charts(index) + runs_table(job, index) + "</section>\n";
}

constexpr const char* kRules =
    "<section id=\"rules\"><h2>How trends are judged</h2>\n"
    "<p>Each figure is held against that of the run of the same job before it. A certified figure "
    "is an interval that holds the truth: it is worse when it has left the interval before, or "
    "when "
    "its upper end has grown by more than the resolution that the run asked for. Sampled lengths "
    "must change by more than that resolution, coverage by more than 0.1 % of the area, machining "
    "time by more than 0.1 %. All that is less is the same.</p></section>\n";

}  // namespace

void write_history_html(const Overview& overview, std::ostream& out) {
  const html::Script script = {embedded::history_js(), embedded::history_js_sha256(),
                               embedded::history_css()};
  out << html::shell_head("History " + overview.file, script) << masthead(overview)
      << "<main id=\"figures\" tabindex=\"-1\">\n";
  for (std::size_t i = 0; i < overview.jobs.size(); ++i) out << job_section(overview.jobs[i], i);
  out << kRules
      << "</main>\n<footer><p>The same figures are in history.csv and history.json beside this "
         "page.</p></footer>\n"
      << html::shell_end(script, overview_json(overview, -1));
}

}  // namespace limitgauge::reports::history_report
