#pragma once

#include "model/part/cutter.h"
#include "model/part/tolerances.h"

namespace limitgauge::verifier {

/// Throws std::invalid_argument for what model::require_valid refuses of a tool, for a range of
/// heights with a cutter whose side leans inwards or that is longer than the flutes, and for a
/// runout that leaves no cutter.
void require_certifiable(const model::Tolerances& tolerances, const model::Cutter& cutter);

}  // namespace limitgauge::verifier
