#include "model/gcode/machine/macro_variables.h"

#include "model/gcode/text/system_parameters.h"

namespace limitgauge::model::gcode {
namespace {

using Value = std::optional<double>;

Value in_unit(const MachineState& state, Value length_mm) {
  return length_mm ? Value(*length_mm / state.modal.unit_mm) : std::nullopt;
}

Value code(std::optional<int> tenths) {
  return tenths ? Value(*tenths / 10.0) : std::nullopt;
}

Value number(std::optional<int> value) {
  return value ? Value(*value) : std::nullopt;
}

Value system_code(const MachineState& state) {
  const std::size_t active = state.systems.active();
  return active < 6 ? Value(54 + static_cast<double>(active)) : std::nullopt;
}

Value feed_mode_code(const MachineState& state) {
  return 93 + static_cast<double>(
                  static_cast<int>(state.modal.feed_mode == FeedMode::per_minute) +
                  2 * static_cast<int>(state.modal.feed_mode == FeedMode::per_revolution));
}

/// Of the blocks before, by modal group.
Value modal_variable(const MachineState& state, Control control, int variable) {
  const ModalState& modal = state.modal;
  switch (variable) {
    case 4001:
      return code(modal.beside_cycles);
    case 4002:
      return static_cast<double>(modal.plane);
    case 4003:
      return modal.incremental ? 91 : 90;
    case 4005:
      return feed_mode_code(state);
    case 4006:
      return modal.unit_mm == 1 ? 21 : 20;
    case 4007:
      return code(modal.compensation);
    case 4008:
      return code(modal.length_offset);
    case 4010:
      return modal.return_to_r ? 99 : 98;
    case 4012:
      return control == Control::haas ? system_code(state) : std::nullopt;
    case 4014:
      return control == Control::fanuc ? system_code(state) : std::nullopt;
    case 4107:
      return number(modal.diameter_number);
    case 4109:
      return in_unit(state, modal.feed_mm);
    case 4111:
      return number(modal.length_number);
    case 4119:
      return state.spindle.rpm;
    case 4120:
      return number(state.selected_tool);
    default:
      return std::nullopt;
  }
}

Value tool_variable(const MachineState& state, int variable) {
  if (variable >= 2001 && variable <= 2200)
    return in_unit(state, state.tools.offset_of(variable - 2000));
  if (variable >= 2401 && variable <= 2600)
    return in_unit(state, state.tools.diameter_of(variable - 2400));
  return std::nullopt;
}

}  // namespace

std::optional<double> macro_variable(const MachineState& state, Control control, int variable) {
  const auto among = [variable](int first) { return variable >= first && variable < first + 3; };
  constexpr int kPosition = 5420, kMachinePosition = 5021;  // LinuxCNC's numbers
  if (among(5001)) return system_parameter(state, variable - 5001 + kPosition);
  if (among(5041)) {
    // Fanuc's hold the tool's length and radius: what they are then nothing here says.
    const bool has_tool =
        control == Control::fanuc && (state.tools.has_offset_in_use() || state.is_compensated());
    if (has_tool) return std::nullopt;
    return system_parameter(state, variable - 5041 + kPosition);
  }
  if (among(5021)) return system_parameter(state, variable - 5021 + kMachinePosition);
  constexpr int kSpacing = 20, kSystems = 6;
  const int item = (variable - 5221) % kSpacing;
  if (variable >= 5221 && variable < 5221 + kSystems * kSpacing && item < 3)
    return in_unit(state, system_parameter(state, variable));
  if (control == Control::haas && variable >= 2001 && variable <= 2600)
    return tool_variable(state, variable);
  return modal_variable(state, control, variable);
}

}  // namespace limitgauge::model::gcode
