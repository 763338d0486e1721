#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string_view>

namespace limitgauge::model {

/// Whose habits a program is read by; what each accepts is in model/gcode/control and
/// docs/programs.md.
enum class Control : std::uint8_t { linuxcnc, fanuc, haas, mach3, grbl, siemens };

inline constexpr std::array kControls = {Control::linuxcnc, Control::fanuc, Control::haas,
                                         Control::mach3,    Control::grbl,  Control::siemens};

/// As options and jobs name it: `linuxcnc`.
std::string_view name(Control control);
/// Nothing for a name that is none of them.
std::optional<Control> control_named(std::string_view name);

}  // namespace limitgauge::model
