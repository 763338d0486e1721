#include "reports/vtk/stage_facts.h"

#include "reports/run/run_result.h"

namespace limitgauge::reports {

std::vector<Fact> stage_facts(const StageResult& stage) {
  std::vector<Fact> facts{{"stage", stage.name},
                          {"tool", stage.tool},
                          {"verdict", std::string(name(stage.verdict()))},
                          {"units", std::string("mm")}};
  if (stage.allowance_mm) facts.push_back({"allowance_mm", *stage.allowance_mm});
  const verifier::GateLimits& l = stage.limits;
  if (l.has_gouge) facts.push_back({"gouge_limit_mm", l.gouge_mm});
  if (l.has_uncut) facts.push_back({"uncut_limit_mm", l.uncut_mm});
  if (l.has_coverage) facts.push_back({"coverage_limit", l.coverage});
  if (l.has_unreachable)
    facts.push_back(
        {l.unreachable_is_share ? "unreachable_limit" : "unreachable_limit_mm2", l.unreachable});
  if (l.has_unavoidable) facts.push_back({"unavoidable_limit_mm", l.unavoidable_mm});
  return facts;
}

}  // namespace limitgauge::reports
