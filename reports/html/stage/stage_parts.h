#pragma once

#include <cstddef>
#include <string>

#include "reports/run/report.h"
#include "reports/run/run_result.h"

/// What the page tells of a stage, part by part.
namespace limitgauge::reports::html {

/// One row a stage with its verdict and its gate figures, each with its limit.
std::string stage_table(const RunResult& result);

/// For the header: of each stage that did not pass the worst gouge, leftover, missing stock and
/// fault of every kind with its depth, its place, its program line in full, and a link to its row.
/// Empty for a job that passed.
std::string worst_places(const RunResult& result);

/// The stage's part of the page, folded below its heading where it passed.
std::string stage_section(const RunResult& result, std::size_t index);
/// "contour", or the program's name; escaped.
std::string path_source(const StageResult& stage);
/// "⌀8 mm flat"; escaped.
std::string cutter_text(const model::Cutter& cutter);

/// What is told in single figures of a stage that ran: deviation, toolpath, simulation, removal.
std::string figures_part(const StageResult& stage);
/// Worst-case bounds of all sources of error, folded away.
std::string budget_table(const std::vector<verifier::UncertaintyTerm>& budget);

/// The error map with its legend and the worst places marked, scaled by the gate; where everything
/// measured is far inside the limits, by what was measured.
std::string error_map(const StageResult& stage);

/// The patches of a stage that ran, the worst first, folded away.
std::string patch_table(const RunResult& result, std::size_t index);

/// Gouges and leftovers of a stage that ran, the worst first, and what each body of the assembly
/// did to the part.
std::string findings_part(const RunResult& result, std::size_t index);

/// Rows of that table; the others are in result.json.
inline constexpr std::size_t kMostGroups = 20;
/// Faults and near misses of the process, runs of moves with the same one as a row; a sentence
/// where there is none.
std::string process_table(const StageRun& ran, std::size_t stage);
/// Where the page's script puts charts over the program: removal rate, feed, engagement.
std::string process_charts(std::size_t stage);
/// How deep, or how far apart for a near miss: "≥ 0.84 mm".
std::string process_depth(const simulator::Finding& finding);
/// What was removed and how: rates, engagement, air cutting.
std::string removal_terms(const StageRun& ran);

/// The program text around every line that the findings of stage `index` name, the lines marked
/// with the findings' numbers; empty where there is none.
std::string program_part(const RunResult& result, std::size_t index);

}  // namespace limitgauge::reports::html
