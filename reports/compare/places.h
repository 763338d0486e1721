#pragma once

#include "reports/compare/comparison.h"

namespace limitgauge::reports::compare {

FoundPlace found_place(const record::Place& place);
FoundPlace found_place(const record::ProcessFinding& finding, const std::string& stage);
/// How deep the place of a change is: in the new run where it is there.
double depth_mm(const FindingChange& change);

}  // namespace limitgauge::reports::compare
