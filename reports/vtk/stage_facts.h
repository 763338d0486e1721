#pragma once

#include <string>
#include <variant>
#include <vector>

namespace limitgauge::reports {

struct StageResult;

/// A named value that holds for a whole file: field data in VTK's words. Names end in their unit.
struct Fact {
  std::string name;
  std::variant<double, std::string> value;
};

/// What the VTK files of a stage say of it: `stage`, `tool`, `verdict`, `units`, `allowance_mm`,
/// and those of its gate's limits that are stated: `gouge_limit_mm`, `uncut_limit_mm`,
/// `coverage_limit`, `unreachable_limit` (a share) or `unreachable_limit_mm2`,
/// `unavoidable_limit_mm`.
std::vector<Fact> stage_facts(const StageResult& stage);

}  // namespace limitgauge::reports
