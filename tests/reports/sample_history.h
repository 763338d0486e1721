#pragma once

#include <string>
#include <vector>

#include "reports/history/job_history.h"

namespace limitgauge::reports {

/// `count` runs of the job "aircraft" in two stages, rough and finish, gated. Each is as the one
/// before, but for: every seventh fails in the finish, which has left 20 µm more; of every eleventh
/// the rough stage fails, and the finish is not run; from the half on the finish takes 5 % less.
std::vector<history::Entry> sample_runs(int count);

/// Overview of the runs with the usual choice of figures.
history_report::Overview overview_of(const std::vector<history::Entry>& runs,
                                     const history_report::Choice& choice = {});

/// Three runs with markup in every text.
history_report::Overview hostile_overview();

}  // namespace limitgauge::reports
