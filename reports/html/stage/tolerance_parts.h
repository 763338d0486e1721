#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "reports/run/run_result.h"

/// What the page tells of a stage that was certified over tolerances, part by part.
namespace limitgauge::reports::html {

/// The stage's block: gouge and uncut as stated and over all values, where and with which values
/// they are worst, how far the tolerances may grow and what eats that. Empty where the stage has
/// none.
std::string tolerance_part(const RunResult& result, std::size_t index);

/// Which values lead to a figure, for those who set a machine up: "the zero 5 µm low; tool ball3
/// 10 µm larger in radius and 5 µm longer".
std::string witness_words(const model::Tolerances& tolerances,
                          const verifier::RobustFigure& figure);

/// One of the figures with its name: "gouge", "uncut".
struct NamedFigure {
  const char* name = "";
  const verifier::RobustFigure* figure = nullptr;
};

/// The factors by which the tolerances may grow as bars on one scale, with what they show in words;
/// of figures that have a margin. Empty where none has.
std::string margin_chart(const std::vector<NamedFigure>& figures);
/// "may grow 1.078 times, which is proven to pass; from 1.081 times on it is proven to fail".
std::string margin_words(const verifier::ToleranceMargin& margin);

/// How much of the figure each tolerance is good for where the figure is worst, the most first.
/// Empty where no such place is known.
std::string eaters_table(const model::Tolerances& tolerances, const NamedFigure& figure);

}  // namespace limitgauge::reports::html
