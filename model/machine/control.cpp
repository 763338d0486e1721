#include "model/machine/control.h"

#include <algorithm>

namespace limitgauge::model {
namespace {

/// In the order of Control.
constexpr std::array<std::string_view, kControls.size()> kControlNames = {
    "linuxcnc", "fanuc", "haas", "mach3", "grbl", "siemens"};

}  // namespace

std::string_view name(Control control) {
  return kControlNames[static_cast<std::size_t>(control)];
}

std::optional<Control> control_named(std::string_view name) {
  const auto* const found = std::find(kControlNames.begin(), kControlNames.end(), name);
  if (found == kControlNames.end()) return std::nullopt;
  return static_cast<Control>(found - kControlNames.begin());
}

}  // namespace limitgauge::model
