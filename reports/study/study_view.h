#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <vector>

#include "reports/study/study_report.h"
#include "study/search/objectives.h"

namespace limitgauge::reports::study_report {

/// All that a report of a study reads, and what several parts of it ask.
struct StudyView {
  const study::Plan& plan;
  const study::Table& table;
  const study::Analysis& analysis;
  const About& about;
};

constexpr std::array<study::Status, 5> kStatuses = {study::Status::pass, study::Status::fail,
                                                    study::Status::indeterminate,
                                                    study::Status::error, study::Status::lost};

std::size_t count(const study::Table& table, study::Status status);
/// The figures that the study is about, what is paid with first: those of the fronts, and where
/// there is none those that the plan names. Indices in Table::figures.
std::vector<std::size_t> objectives(const StudyView& view);
/// The row with the job's own settings.
std::optional<std::size_t> own_row(const StudyView& view);
/// At most `most` rows, those to look at first: passed, undecided, failed, error, lost, each by
/// first objective, the best first, and then by their numbers.
std::vector<std::size_t> best_rows(const StudyView& view, std::size_t most);

}  // namespace limitgauge::reports::study_report
