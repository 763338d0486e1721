#pragma once

#include <filesystem>
#include <iosfwd>
#include <string>

#include "app/cli/commands.h"
#include "app/study/study_cases.h"
#include "study/plan/plan.h"
#include "study/search/analysis.h"
#include "study/store/table.h"

namespace limitgauge::app {

struct StudyOutcome {
  study::Table table;
  study::Analysis analysis;
  StudyProgress progress;
  std::string created, engine;
  double seconds = 0;
};

/// study.csv, study.json and study.html. Throws ResourceError.
void write_study(const study::Plan& plan, const StudyOutcome& outcome,
                 const std::filesystem::path& folder);
/// The result of one case, in its place below the study's folder.
void write_case(std::size_t index, const std::string& text, const std::filesystem::path& folder);

/// How many cases came out how, why some have no result, and the setting to take.
void print_study(const StudyOutcome& outcome, std::ostream& out);

/// A recommended setting, or why there is none.
ExitCode exit_code(const StudyOutcome& outcome);

}  // namespace limitgauge::app
