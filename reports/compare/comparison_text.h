#pragma once

#include <string>

#include "reports/compare/comparison.h"

namespace limitgauge::reports::compare {

/// "better", "same", "worse", "not judged".
const char* name(Judgement judgement);
/// "new", "vanished", "deeper", "shallower", "moved"; a near miss is nearer or farther.
const char* name(const FindingChange& change);
/// "rapid through standing material"; the kind itself where it is unknown.
std::string kind_text(const std::string& kind);

/// A figure's cells for people: both runs in one unit, the change signed.
struct FigureText {
  std::string base, now, change, floor;
};
FigureText figure_text(const FigureChange& change);
/// "base", "new"; with the run's name where it has one: "base, out/main".
std::string base_title(const Comparison& comparison);
std::string new_title(const Comparison& comparison);
/// "0.05 mm", "0.05 mm, 0.04 mm before".
std::string depth_text(const FindingChange& change);
/// "line 120: X1 Y2 Z3"; with the stage whose program it is unless that is `stage`.
std::string line_text(const FoundPlace& place, const std::string& stage);
/// " at (1.000, 2.000, 3.000)", mm.
std::string at_text(const FoundPlace& place);
/// "worse: 2 regressions": the whole in a few words.
std::string summary(const Comparison& comparison);

}  // namespace limitgauge::reports::compare
