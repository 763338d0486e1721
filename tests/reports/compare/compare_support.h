#pragma once

#include <string>

#include "reports/compare/comparison.h"

namespace limitgauge::reports::compare {

/// A run of one stage, "finish", that passes: gouge 0 to 1 µm, uncut 5 to 6 µm, resolution 1 µm,
/// limits 10 µm, on a surface of 100 mm.
record::RunRecord sample_run();
/// The figure of that stage with the id.
const FigureChange& figure(const Comparison& comparison, const std::string& id);
/// The judgement of one figure when `base` becomes `now`.
Judgement judgement_of(const std::string& id, const record::RunRecord& base,
                       const record::RunRecord& now);
/// A leftover at (x, 0, 0).
record::Place place_at(double x_mm, double depth_mm, std::uint32_t line);

}  // namespace limitgauge::reports::compare
