#pragma once

#include <optional>
#include <string_view>

#include "model/machine/control.h"

namespace limitgauge::model::gcode {

/// How cutter compensation begins and goes round corners.
enum class CompensationStyle {
  linuxcnc,  ///< an entry ends beside its own line, bends by up to 0.05 radians are left as they
             ///< are
  /// The entry ends beside the start of the motion behind it, square to that, however they meet
  /// (start-up of type A). G40 takes effect with the next move in the plane. Outer corners are
  /// lines: to where the paths beside the contour meet; of a turn by more than 90 degrees to the
  /// radius beyond either end, and across.
  fanuc,
  siemens  ///< the entry as fanuc's (NORM); outer corners are arcs (G450)
};

/// Which codes take the tool's length out of effect until H or G43 says it again, the modal G43
/// staying.
enum class LengthCancel {
  never,
  where_z_moves,  ///< G28, G30 and G53 that move Z (Fanuc B-63844EN, 14.1.2)
  by_return       ///< G28 and G30, whatever axes move (Haas 96-8000, "G28")
};

/// What a control takes beyond RS274/NGC as LinuxCNC documents it, or instead of it: the one home
/// of such differences, beside its codes (control_codes.h). Sources: LinuxCNC 2.9, "G-Code";
/// Fanuc B-63684EN and B-64304EN, operator's manuals (series 16i/18i and 0i-D); Haas, mill
/// operator's manual 96-8210; "Using Mach3Mill", chapter 10; Grbl 1.1, "gcode.c" and its wiki;
/// Siemens SINUMERIK 840D sl, "Fundamentals" 6FC5398-1BP40.
struct ControlRules {
  Control control = Control::linuxcnc;
  std::string_view title;  ///< for messages: `Haas`

  // Text.
  bool o_words = false;         ///< LinuxCNC's sub, call, while, if, ...
  bool expressions = false;     ///< brackets, functions and #parameters
  bool arguments_once = false;  ///< of G65 L: each run goes on with the variables of the one before
  bool macro_b = false;         ///< IF, GOTO, WHILE, DO, END, G65, vacant variables
  bool r_parameters = false;    ///< Siemens's R1=..., X=..., comments by ';' only
  bool subprograms = false;     ///< M98 and M99
  bool local_subprograms = false;   ///< M97 P calls the block of that number
  bool call_beside_motion = false;  ///< M98 and M99 end a block of other words
  bool repeats_by_q = false;        ///< M98 P Q
  bool colon_numbers = false;       ///< `:0100` is O0100
  bool numbered_skips = false;      ///< `/2` is a block skip as well
  bool semicolon_ends_block = false;
  bool trailing_percent = false;  ///< a `%` ends a program that none began
  bool leader = false;            ///< text behind the first `%` is skipped
  bool idle_percent = false;      ///< a line that begins with `%` says nothing of the end
  bool program_names = false;     ///< `<NAME>` in the place of a program's number
  bool dollar_lines = false;      ///< `$` begins a line for the control itself

  // Words.
  bool polar_words = false;              ///< @ and ^
  bool turns_by_p = false;               ///< P turns of an arc
  bool idle_centre_words = false;        ///< K0 in a G17 arc
  bool rotary_zero = false;              ///< A0, B0, C0 of an axis that stays
  bool modal_offset_words = false;       ///< D and H stay until the next; H0 and D0 are no offset
  bool length_by_d = false;              ///< D takes the tool's length
  bool length_in_machine_frame = false;  ///< which stays in effect beside G53
  LengthCancel length_cancel = LengthCancel::never;
  /// A change of the tool's length is made up for by the next motion of Z, in G91 too (Fanuc
  /// B-63844EN, 14.1.1), where LinuxCNC gives the tool's place another name.
  bool length_moves_z = false;
  /// The same of X, Y and Z behind a change of the zero offset (Siemens 6FC5398, "G91": SD 42440
  /// and 42442 as the control comes).
  bool offsets_move_axes = false;
  bool whole_lengths_doubtful = false;  ///< X10 may be 10 mm or 10 increments: a parameter says
  /// Lengths and angles that variables and expressions give are rounded to the least input
  /// increment: 0.001 mm, 0.0001 inch, 0.001 degrees (Fanuc B-63684EN, 16.1; Haas, "Address
  /// Substitution").
  bool rounds_calculated = false;
  std::string_view dwell_letters = "P";  ///< of G4

  // Codes.
  bool separate_cycle_group = false;     ///< G80 goes back to G0 to G3 before the cycle
  bool motion_beside_reference = false;  ///< G0 G28 Z0
  bool rapid_in_machine_frame = false;   ///< G53 is a rapid under G1 or beside it, too
  bool begins_in_g0 = false;
  bool begins_in_g98 = false;
  bool repeats_by_k = false;       ///< K of a canned cycle
  bool dwell_is_optional = false;  ///< of canned cycles that dwell; P in the others as well
  bool whole_peck = false;         ///< Q0 drills to the bottom in one
  bool tap_turns_spindle = false;  ///< G74 and G84 start it themselves
  /// Of canned cycles: Z and R are what G90 or G91 of their own block makes of them, whatever comes
  /// later, another cycle of the run too, and the tool goes across at the level where it stands,
  /// then to R.
  bool fanuc_cycles = false;
  bool fanuc_offsets = false;  ///< G10 L2 P0, L10 to L13, L20; G91 adds
  int extended_systems = 0;    ///< of G54.1 P or G154 P

  CompensationStyle compensation = CompensationStyle::linuxcnc;
  /// Blocks without a motion in the plane that the control reads over to find the next one beside a
  /// contour: with more it leaves the corner between as it is (Fanuc B-63944EN, 6.6.3: parameter
  /// 19625 less two, one at least).
  std::optional<int> most_still_blocks = {};
  std::string_view compensation_as_set = {};  ///< what is assumed of its settings, for messages
};

const ControlRules& rules_of(Control control);

}  // namespace limitgauge::model::gcode
