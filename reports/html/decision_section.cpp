#include "reports/html/decision_section.h"

#include "reports/text.h"

namespace limitgauge::reports::html {
namespace {

constexpr const char* kDecisionRule = R"(<section id="decision"><h2>How it was decided</h2>
<p>Deviation is the signed distance from each point of the exact limit surface to the space that was
removed, less the stage's allowance. Positive is material still standing (uncut), negative is cut too
deep (gouge). Part and simulation share one frame; nothing was fitted.</p>
<ul><li><strong>Passed</strong>: the upper end of every certified interval is inside its limit, so that
no point of the surface exceeds it; coverage is at least what is asked for; the process has no fault
(a collision, a cut with the spindle at rest, ...); near misses are shown and do not count.</li>
<li><strong>Failed</strong>: the lower end of an interval is beyond its limit, so that some point
truly exceeds it; or coverage is too small; or the process has a fault.</li>
<li><strong>Undecided</strong>: a limit lies inside a certified interval at the finest resolution
allowed.</li></ul>
<p>This is the rule of ISO 14253-1 in spirit: conformance is proven to pass and non-conformance is
proven to fail. The bounds are worst cases, not standard deviations, and carry no coverage factor. The
ratio of limit to interval width stands beside each figure; below 4 : 1 it is marked, and 10 : 1 or
better is aimed for.</p></section>
)";

}  // namespace

std::string decision_section() {
  return kDecisionRule;
}

std::string assumptions_section(const std::vector<std::string>& assumptions) {
  if (assumptions.empty()) return {};
  std::string items;
  for (const std::string& a : assumptions) items += "<li>" + escape_markup(a) + "</li>\n";
  return "<section id=\"assumptions\"><h2>Assumptions</h2><ul>" + items + "</ul></section>\n";
}

}  // namespace limitgauge::reports::html
