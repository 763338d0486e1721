#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "history/entry.h"
#include "history/history.h"
#include "reports/compare/comparison.h"
#include "reports/record/metrics.h"
#include "verifier/gate/deviation.h"

/// Past runs, job by job, as the terminal, the page and the files show them.
namespace limitgauge::reports::history_report {

/// What is shown; empty: all stages, and of the metrics gouge, uncut, those over
/// tolerances with their margin, and the machining time.
struct Choice {
  std::vector<std::string> stages, metrics;
};

/// One figure over the runs of a job.
struct Column {
  std::string stage, metric;  ///< stage empty: of the whole run
  std::string label, unit;    ///< "gouge", "mm"; the id of a metric that this program does not know
  const record::Metric* known = nullptr;  ///< null for such a one
};

/// The figure of one run, and what it is against the one before that has it.
struct Cell {
  std::optional<verifier::Interval> value;
  std::optional<double> limit;                  ///< of the gate, as it was for that run
  std::optional<compare::Judgement> judgement;  ///< empty where there is nothing to judge by
  /// The run before measured something else under this name: nothing is judged.
  bool new_meaning = false;
  int direction =
      0;  ///< +1 where the figure's middle (a margin's proven end) grew, −1 where it fell
};

struct Run {
  history::Entry entry;  ///< without its values
  std::vector<Cell> cells;
};

struct JobHistory {
  /// Whether runs of result schema 1 stand beside later ones, whose gouge and uncut mean runs along
  /// the normal.
  bool changes_meaning() const;

  std::string job;
  std::vector<Column> columns;  ///< the whole run's first, then by stage
  std::vector<Run> runs;        ///< oldest first
};

struct Overview {
  std::string file;       ///< as the user names it
  std::string version;    ///< of this program
  std::size_t found = 0;  ///< runs that were asked for, before the newest were taken
  Choice choice;
  std::vector<JobHistory> jobs;  ///< by name
};

/// What is to be said of a job whose figures change their meaning.
inline constexpr const char* kNewMeaning =
    "Gouge, uncut and what is measured beside them mean something else from the first run marked "
    "\"new meaning\" on (limitgauge.result/2): runs along the normal, no longer distances to the "
    "nearest removed space or material. No trend is drawn across that.";

/// Metrics of the `series` of a history that must be read for `choice`: limits and what trends are
/// judged by among them.
std::vector<std::string> metrics_to_read(const Choice& choice,
                                         std::span<const history::Series> series);

/// `runs` by job, oldest first as they are.
std::vector<JobHistory> job_histories(std::span<const history::Entry> runs, const Choice& choice);

}  // namespace limitgauge::reports::history_report
