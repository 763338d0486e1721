#include "model/gcode/text/system_parameters.h"

#include <algorithm>
#include <array>

namespace limitgauge::model::gcode {
namespace {

using Value = std::optional<double>;

/// LinuxCNC numbers nine axes: X, Y, Z, A, B, C and three more. Those that are not carried out
/// stand at 0.
constexpr int kNumberedAxes = 9, kFirstRotary = 3, kLastRotary = 5;
constexpr int kFirstSystem = 5221, kNextSystem = 20, kRotation = 9;

double angle(const RotaryAngles& angles_deg, int axis) {
  if (axis > kLastRotary) return 0;
  return angles_deg[static_cast<std::size_t>(axis - kFirstRotary)];
}

Value position(const MachineState& state, int axis) {
  if (axis > 2) return angle(state.orientation.angles_deg, axis);
  if (state.adrift[axis] || state.is_compensated()) return std::nullopt;
  if (!state.known[axis] && !state.fresh) return std::nullopt;
  return state.position_mm[axis] / state.modal.unit_mm;
}

/// Of the spindle on the machine.
Value machine_position(const MachineState& state, int axis) {
  if (axis > 2) return angle(state.orientation.angles_deg, axis);
  const CoordinateSystem& system = state.systems.system();
  const bool mixed = axis < 2 && system.rotation_deg != 0;
  if (!position(state, axis) || (mixed && !position(state, 1 - axis))) return std::nullopt;
  if (!system.usable[axis]) return std::nullopt;
  Vec3 at_mm = state.frame.to_machine(state.position_mm);
  at_mm.z += state.tools.true_length().value_or(0);
  return at_mm[axis] / state.modal.unit_mm;
}

Value reference(const ReferencePoint& point, int axis) {
  if (axis > 2) return angle(point.angles_deg, axis);
  return point.known[axis] ? Value(point.at_mm[axis]) : std::nullopt;
}

Value system_value(const MachineState& state, int number) {
  const auto index = static_cast<std::size_t>((number - kFirstSystem) / kNextSystem);
  const int item = (number - kFirstSystem) % kNextSystem;
  if (index >= kWorkOffsets || item > kRotation) return std::nullopt;
  const CoordinateSystem& system = state.systems.system(index);
  if (item == kRotation) return system.is_usable() ? Value(system.rotation_deg) : std::nullopt;
  if (item > 2) return system.is_usable() ? Value(0) : std::nullopt;
  return system.usable[item] ? Value(system.origin_mm[item]) : std::nullopt;
}

Value tool_value(const MachineState& state, int number) {
  if (!state.tools.loaded()) return std::nullopt;
  const int tool = *state.tools.loaded();
  if (number == 5400) return tool;
  if (number == 5403) return tool == 0 ? 0 : state.tools.offset_of(tool);
  if (number == 5410) return tool == 0 ? 0 : state.tools.diameter_of(tool);
  return 0;
}

Value feed(const MachineState& state) {
  return state.modal.feed_mm / state.modal.unit_mm;
}

double motion_mode(const MachineState& state) {
  return state.modal.motion.value_or(800);
}

double system_code(const MachineState& state) {
  const auto index = static_cast<int>(state.systems.active());
  return index < 6 ? 540 + 10 * index : 585 + index;
}

struct Named {
  std::string_view name;
  Value (*value)(const MachineState& state);
};
template <bool ModalState::*flag>
Value modal_flag(const MachineState& state) {
  return state.modal.*flag;
}
template <bool ModalState::*flag>
Value modal_flag_not(const MachineState& state) {
  return !(state.modal.*flag);
}
template <FeedMode mode>
Value feed_mode(const MachineState& state) {
  return state.modal.feed_mode == mode;
}
template <int axis>
Value work_axis(const MachineState& state) {
  return position(state, axis);
}
template <int axis>
Value machine_axis(const MachineState& state) {
  return machine_position(state, axis);
}
Value zero(const MachineState&) {
  return 0;
}
Value one(const MachineState&) {
  return 1;
}

/// Sorted by name.
constexpr auto kNamed = std::to_array<Named>(
    {{"_a", work_axis<3>},
     {"_abs_a", machine_axis<3>},
     {"_abs_b", machine_axis<4>},
     {"_abs_c", machine_axis<5>},
     {"_abs_u", zero},
     {"_abs_v", zero},
     {"_abs_w", zero},
     {"_abs_x", machine_axis<0>},
     {"_abs_y", machine_axis<1>},
     {"_abs_z", machine_axis<2>},
     {"_absolute", modal_flag_not<&ModalState::incremental>},
     {"_b", work_axis<4>},
     {"_c", work_axis<5>},
     {"_ccomp", [](const MachineState& state) -> Value { return state.modal.compensation; }},
     {"_coord_system", [](const MachineState& state) -> Value { return system_code(state); }},
     {"_current_tool", [](const MachineState& state) -> Value { return state.tools.loaded(); }},
     {"_feed", feed},
     {"_flood", [](const MachineState& state) -> Value { return state.coolant.flood; }},
     {"_ijk_absolute_mode", modal_flag<&ModalState::centre_absolute>},
     {"_imperial", [](const MachineState& state) -> Value { return state.modal.unit_mm != 1; }},
     {"_incremental", modal_flag<&ModalState::incremental>},
     {"_inverse_time", feed_mode<FeedMode::inverse_time>},
     {"_lathe_diameter_mode", zero},
     {"_lathe_radius_mode", one},
     {"_metric", [](const MachineState& state) -> Value { return state.modal.unit_mm == 1; }},
     {"_metric_machine", one},
     {"_mist", [](const MachineState& state) -> Value { return state.coolant.mist; }},
     {"_motion_mode", [](const MachineState& state) -> Value { return motion_mode(state); }},
     {"_plane",
      [](const MachineState& state) -> Value { return 10 * static_cast<int>(state.modal.plane); }},
     {"_remap_level", zero},
     {"_retract_old_z", modal_flag_not<&ModalState::return_to_r>},
     {"_retract_r_plane", modal_flag<&ModalState::return_to_r>},
     {"_rpm", [](const MachineState& state) -> Value { return state.spindle.rpm; }},
     {"_selected_tool", [](const MachineState& state) -> Value { return state.selected_tool; }},
     {"_spindle_css_mode",
      [](const MachineState& state) -> Value { return state.spindle.constant_surface; }},
     {"_spindle_cw",
      [](const MachineState& state) -> Value {
        return state.spindle.on.value_or(false) && state.spindle.clockwise;
      }},
     {"_spindle_on",
      [](const MachineState& state) -> Value { return state.spindle.on.value_or(false); }},
     {"_spindle_rpm_mode",
      [](const MachineState& state) -> Value { return !state.spindle.constant_surface; }},
     {"_task", one},  // as on the machine, not in a preview
     {"_tool_offset",
      [](const MachineState& state) -> Value { return state.tools.has_offset_in_use(); }},
     {"_u", zero},
     {"_units_per_minute", feed_mode<FeedMode::per_minute>},
     {"_units_per_rev", feed_mode<FeedMode::per_revolution>},
     {"_v", zero},
     {"_vmajor", [](const MachineState&) -> Value { return 2.9; }},
     {"_vminor", zero},
     {"_w", zero},
     {"_x", work_axis<0>},
     {"_y", work_axis<1>},
     {"_z", work_axis<2>}});

}  // namespace

std::optional<double> system_parameter(const MachineState& state, int number) {
  const auto among = [number](int first) {
    return number >= first && number < first + kNumberedAxes;
  };
  if (among(5021)) return machine_position(state, number - 5021);
  if (among(5161)) return reference(state.reference[0], number - 5161);
  if (among(5181)) return reference(state.reference[1], number - 5181);
  if (number == 5210) return state.systems.g92_applies();
  if (among(5211)) return number > 5213 ? 0 : state.systems.saved_g92_mm()[number - 5211];
  if (number == 5220) return static_cast<double>(state.systems.active() + 1);
  if (number >= kFirstSystem && number <= 5390) return system_value(state, number);
  if (number >= 5400 && number <= 5413) return tool_value(state, number);
  if (among(5420)) return position(state, number - 5420);
  return std::nullopt;
}

std::optional<double> system_parameter(const MachineState& state, std::string_view name,
                                       std::size_t call_level) {
  if (name == "_call_level") return static_cast<double>(call_level);
  const auto found = std::lower_bound(
      kNamed.begin(), kNamed.end(), name,
      [](const Named& entry, std::string_view wanted) { return entry.name < wanted; });
  if (found == kNamed.end() || found->name != name) return std::nullopt;
  return found->value(state);
}

}  // namespace limitgauge::model::gcode
