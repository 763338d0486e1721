#include "model/gcode/control/control_rules.h"

namespace limitgauge::model::gcode {
namespace {

constexpr ControlRules linuxcnc_rules() {
  ControlRules rules;
  rules.title = "LinuxCNC";
  rules.o_words = rules.expressions = rules.subprograms = true;
  rules.polar_words = rules.turns_by_p = rules.rotary_zero = true;
  return rules;
}

/// What Fanuc and Haas share.
constexpr ControlRules iso_rules(Control control, std::string_view title) {
  ControlRules rules;
  rules.control = control;
  rules.title = title;
  rules.expressions = rules.macro_b = rules.subprograms = rules.call_beside_motion = true;
  rules.colon_numbers = rules.numbered_skips = rules.semicolon_ends_block = true;
  rules.trailing_percent = rules.leader = true;
  rules.idle_centre_words = rules.rotary_zero = rules.modal_offset_words = true;
  rules.whole_lengths_doubtful = rules.rounds_calculated = rules.length_moves_z = true;
  rules.separate_cycle_group = rules.motion_beside_reference = rules.begins_in_g98 = true;
  rules.dwell_is_optional = rules.whole_peck = rules.tap_turns_spindle = true;
  rules.fanuc_offsets = rules.fanuc_cycles = true;
  rules.compensation = CompensationStyle::fanuc;
  return rules;
}

constexpr ControlRules fanuc_rules() {
  ControlRules rules = iso_rules(Control::fanuc, "Fanuc");
  rules.repeats_by_k = rules.rapid_in_machine_frame = rules.program_names = true;
  rules.dwell_letters = "PX";
  rules.length_cancel = LengthCancel::where_z_moves;
  rules.most_still_blocks = 1;
  rules.compensation_as_set = "start-up and cancel of type A, parameter 5003";
  rules.extended_systems = 300;
  return rules;
}

constexpr ControlRules haas_rules() {
  ControlRules rules = iso_rules(Control::haas, "Haas");
  rules.local_subprograms = rules.begins_in_g0 = rules.arguments_once = true;
  rules.length_cancel = LengthCancel::by_return;
  rules.extended_systems = 99;
  rules.compensation_as_set = "entry and exit of type A, setting 43, corners as Fanuc's";
  return rules;
}

constexpr ControlRules mach3_rules() {
  ControlRules rules;
  rules.control = Control::mach3;
  rules.title = "Mach3";
  rules.expressions = rules.subprograms = rules.repeats_by_q = rules.trailing_percent = true;
  rules.idle_centre_words = rules.rotary_zero = rules.dwell_is_optional = rules.whole_peck = true;
  rules.tap_turns_spindle = true;
  return rules;
}

constexpr ControlRules grbl_rules() {
  ControlRules rules;
  rules.control = Control::grbl;
  rules.title = "Grbl";
  rules.idle_percent = rules.dollar_lines = rules.idle_centre_words = true;
  return rules;
}

constexpr ControlRules siemens_rules() {
  ControlRules rules;
  rules.control = Control::siemens;
  rules.title = "Siemens";
  rules.r_parameters = rules.idle_centre_words = rules.rotary_zero = rules.length_by_d = true;
  rules.length_in_machine_frame = true;  // MD 10760 as 0
  rules.length_moves_z = rules.offsets_move_axes = true;
  rules.idle_percent = rules.turns_by_p = true;
  rules.dwell_letters = "FS";
  rules.compensation = CompensationStyle::siemens;
  rules.compensation_as_set = "NORM and G450, as the control starts";
  return rules;
}

constexpr std::array<ControlRules, kControls.size()> kRules = {
    linuxcnc_rules(), fanuc_rules(), haas_rules(), mach3_rules(), grbl_rules(), siemens_rules()};

}  // namespace

const ControlRules& rules_of(Control control) {
  return kRules[static_cast<std::size_t>(control)];
}

}  // namespace limitgauge::model::gcode
