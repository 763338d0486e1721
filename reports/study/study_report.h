#pragma once

#include <cstddef>
#include <iosfwd>
#include <string>
#include <vector>

#include "study/plan/plan.h"
#include "study/search/analysis.h"
#include "study/store/table.h"

/// What a study writes.
namespace limitgauge::reports::study_report {

/// What is known beside the study's own values; all of it may be left out.
struct About {
  std::string version;  ///< of the program
  /// Differ from run to run.
  std::string created, engine;  ///< "2026-11-22T01:40:00Z"; what ran the cases: "local", "slurm"
  double seconds = 0;           ///< that the study took
  /// What the job itself states for the varied keys, in the order of Table::keys.
  std::vector<study::Setting> own;
  /// The job's file as it is reached from where the study was started; empty: as the study states
  /// it.
  std::string job_path = {};
};

/// Where a case's result lies below the study's folder: "cases/0100/0142/result.json". No folder
/// holds more than a hundred cases.
std::string result_path(std::size_t case_index);

/// study.csv, RFC 4180: a line a case. Text that a spreadsheet would take for a formula has an
/// apostrophe before it.
void write_study_csv(const study::Plan& plan, const study::Table& table,
                     const study::Analysis& analysis, std::ostream& out);
/// study.json, schema `limitgauge.study/1`. The same study gives the same bytes but for what stands
/// under its last key, "run". Throws std::domain_error that names a figure that is not finite.
void write_study_json(const study::Plan& plan, const study::Table& table,
                      const study::Analysis& analysis, std::ostream& out, const About& about = {});
/// One self-contained page that works offline. The same rule for figures that are not finite.
void write_study_html(const study::Plan& plan, const study::Table& table,
                      const study::Analysis& analysis, std::ostream& out, const About& about = {});
/// The JSON Schema of study.json, as shipped.
const std::string& study_schema();

}  // namespace limitgauge::reports::study_report
