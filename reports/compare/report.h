#pragma once

#include <iosfwd>
#include <string>

#include "reports/compare/comparison.h"

namespace limitgauge::reports::compare {

/// For a terminal of `width` columns: the figures that count, what changed besides, and the
/// judgement; `all` lists every figure.
std::string text_table(const Comparison& comparison, bool colour, std::size_t width, bool all);
/// compare.md: short enough for a comment on a change, its texts escaped.
void write_markdown(const Comparison& comparison, std::ostream& out);
/// compare.html: one self-contained page without a script.
void write_html(const Comparison& comparison, std::ostream& out);
/// compare.json, schema limitgauge.compare/1.
void write_json(const Comparison& comparison, std::ostream& out);
/// junit.xml: a suite for the run and one for each stage, with a case for each figure that is
/// judged, for each kind of remark and for the findings. One has failed exactly where `judgement`
/// is worse.
void write_junit(const Comparison& comparison, std::ostream& out);

}  // namespace limitgauge::reports::compare
