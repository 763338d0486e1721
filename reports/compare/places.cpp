#include "reports/compare/places.h"

namespace limitgauge::reports::compare {

FoundPlace found_place(const record::Place& place) {
  return {place.at_mm, place.depth_mm,  place.stage,
          place.line,  place.line_text, place.body == "cutter" ? std::string{} : place.body};
}

FoundPlace found_place(const record::ProcessFinding& finding, const std::string& stage) {
  std::string by = finding.part;
  if (!finding.against.empty() && finding.against != "stock") by += ", " + finding.against;
  return {finding.at_mm, finding.depth_mm, stage, finding.line, finding.line_text, by};
}

double depth_mm(const FindingChange& change) {
  return change.now ? change.now->depth_mm : change.base ? change.base->depth_mm : 0;
}

}  // namespace limitgauge::reports::compare
