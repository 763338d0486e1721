#include "reports/html/job/job_sections.h"

#include "reports/text/text.h"

namespace limitgauge::reports::html {
namespace {

constexpr const char* kDecisionRule = R"(<section id="decision"><h2>How it was decided</h2>
<details><summary>The rule, and what each verdict means</summary>
<p>Deviation is a run along the normal of the exact limit surface, from the allowance surface: outwards
through the material that still stands (uncut, positive), or inwards through what is no longer there
(gouge, negative). At a sharp edge every normal between those of its two faces counts. Part and
simulation share one frame; nothing was fitted.</p>
<p>Uncut is judged where a cutter used so far can reach. What none can reach is proven, has an area of
its own beside the verdict, and can be gated, as can the material that must stay there. Where nothing at
all is in reach, the stage fails. Where the raw stock does not cover the surface, that is a finding of
its own, held against the gouge limit; no program line is to blame for it.</p>
<ul><li><strong>Passed</strong>: the upper end of every certified interval is inside its limit, so that
no point of the surface exceeds it; coverage is at least what is asked for; the process has no fault
(a collision, a cut with the spindle at rest, ...); near misses are shown and do not count.</li>
<li><strong>Failed</strong>: the lower end of an interval is beyond its limit, so that some point
truly exceeds it; or coverage is too small; or nothing is in reach; or the process has a fault.</li>
<li><strong>Undecided</strong>: a limit lies inside a certified interval at the finest resolution
allowed.</li></ul>
<p>This is the rule of ISO 14253-1 in spirit: conformance is proven to pass and non-conformance is
proven to fail. The bounds are worst cases, not standard deviations, and carry no coverage factor. The
ratio of limit to interval width stands beside each figure; below 4 : 1 it is marked, and 10 : 1 or
better is aimed for.</p></details></section>
)";

constexpr const char* kProcessRule = R"(<section id="decision"><h2>How it was decided</h2>
<details><summary>The rule, and what each verdict means</summary>
<p>The program was cut in the raw stock, move by move, and nothing was measured against a design: whether
the part has the shape that it should have, this page does not say.</p>
<ul><li><strong>Passed</strong>: the process has no fault: no rapid through standing material, no holder,
shank or fixture touched, no cut with the spindle at rest, ...; near misses are shown and do not count.</li>
<li><strong>Failed</strong>: the process has a fault.</li></ul>
<p>Contacts are judged on the exact statement of the stock, not on its voxels. The stock was cut a second
time by a model that shares nothing with the first, and the run ends with an error where the two contradict
each other.</p></details></section>
)";

}  // namespace

std::string decision_section(bool has_design) {
  return has_design ? kDecisionRule : kProcessRule;
}

std::string assumptions_section(const std::vector<std::string>& assumptions) {
  if (assumptions.empty()) return {};
  std::string items;
  for (const std::string& a : assumptions) items += "<li>" + escape_markup(a) + "</li>\n";
  return "<section id=\"assumptions\"><h2>Assumptions</h2><ul>" + items + "</ul></section>\n";
}

}  // namespace limitgauge::reports::html
