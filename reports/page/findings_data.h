#pragma once

#include "reports/page/blocks.h"
#include "reports/run/run_result.h"

namespace limitgauge::reports::page {

/// Longest list of findings of a kind on a page; their total is stated.
inline constexpr std::size_t kMostFindings = 500;

/// "gouges", "uncuts" and "process" of a stage that ran, numbered as the page's tables number them,
/// each with its total ("gouges_total", ...).
Json findings_data(const StageRun& ran, const MeshDesign* mesh = nullptr);

/// "text" of stage `index`: the lines of its program around those that findings of any stage name.
Json text_data(const RunResult& result, std::size_t index, Blob& blob);

/// x, y, z.
Json point_json(const model::Vec3& p_mm);

}  // namespace limitgauge::reports::page
