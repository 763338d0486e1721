#include "verifier/robust/certifiable.h"

#include <stdexcept>
#include <string>

#include "verifier/cutter/cutter_profile.h"

namespace limitgauge::verifier {

void require_certifiable(const model::Tolerances& tolerances, const model::Cutter& cutter) {
  const std::string who = "tool \"" + cutter.id + "\": ";
  const auto stated = tolerances.tools.find(cutter.id);
  model::ToolTolerance tool =
      stated == tolerances.tools.end() ? model::ToolTolerance{} : stated->second;
  const double heights =
      tool.length_mm.width() + tolerances.zero_mm[2].width() + 2 * tolerances.positioning_mm.z;
  const CutterProfile profile(cutter);
  if (heights > 0 && profile.undercuts())
    throw std::invalid_argument(who +
                                "its side leans inwards; no range of heights (length, zero or "
                                "positioning along Z) can be certified of it");
  if (heights >= profile.top_mm - profile.core_mm)
    throw std::invalid_argument(who + "its range of heights is longer than its flutes");
  model::Interval& radius = tool.flat_mm ? *tool.flat_mm : tool.radius_mm;
  radius = radius.widened(tolerances.runout_mm);
  try {
    model::require_valid(tool, cutter);
  } catch (const std::invalid_argument& error) {
    throw std::invalid_argument(who + error.what());
  }
}

}  // namespace limitgauge::verifier
