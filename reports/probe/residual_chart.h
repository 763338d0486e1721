#pragma once

#include <string>

#include "reports/probe/probe_result.h"

namespace limitgauge::reports::probe {

/// The residuals in the order of the file, as measured and with the shift taken back, with the
/// stated uncertainty about the latter; drawn as SVG. Of many points each mark is the range of
/// several that follow each other.
std::string residual_chart(const ProbeResult& result);

}  // namespace limitgauge::reports::probe
