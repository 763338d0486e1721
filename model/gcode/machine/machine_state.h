#pragma once

#include <array>
#include <functional>
#include <optional>
#include <string>

#include "model/base/tolerance.h"
#include "model/gcode/machine/coordinate_systems.h"
#include "model/gcode/machine/orientation.h"
#include "model/gcode/machine/tool_table.h"
#include "model/gcode/program.h"
#include "model/gcode/text/statement.h"

namespace limitgauge::model::gcode {

/// What to do about a place on the machine that nothing states, for messages.
inline constexpr const char* kOffsetRemedy =
    "the machine's work offset ([machine] work_offsets in the job, or --work-offset)";
inline constexpr std::array<char, 3> kAxes = {'X', 'Y', 'Z'};
inline constexpr std::array<char, 3> kCentres = {'I', 'J', 'K'};

enum class FeedMode : std::uint8_t { per_minute, inverse_time, per_revolution };

/// What codes set until another code of their group. Power-on state as LinuxCNC's: G17 G21 G40 G49
/// G54 G80 G90 G91.1 G94 G97 G99, no feed rate.
struct ModalState {
  ArcPlane plane = ArcPlane::xy;
  double unit_mm = 1, feed_unit_mm = 1;
  bool incremental = false, centre_absolute = false;
  bool units_are_stated = false, distance_is_stated = false;  ///< by a word of their groups
  bool return_to_r = true;                                    ///< G99
  bool return_is_stated = false;                              ///< by G98 or G99
  int compensation = 400;                                     ///< G40, G41 or G42, in tenths
  int length_offset = 490;  ///< G43, G43.1, G43.2 or G49, in tenths
  /// G28, G30 or G53, in tenths, which has taken the tool's length out of effect (LengthCancel).
  std::optional<int> length_cancelled_by;
  /// By axis: since G43, G49, H or D changed the length in effect, or a code the zero offset, the
  /// axis has not been programmed in G90, on a control where its next motion makes up for the
  /// change.
  std::array<bool, 3> is_due{};
  bool cancelled_length_is_told = false;  ///< a motion along Z came since, and was listed
  std::optional<int> motion;              ///< G code in tenths
  /// G0 to G3, where canned cycles are a group beside them and come back to it.
  std::optional<int> beside_cycles;
  bool motion_is_taken = false;                       ///< G0 of a control that begins in it
  bool edge_is_taken = false;                         ///< D1 of a tool that came without a D
  bool without_edge = false;                          ///< Siemens's D0
  std::optional<int> length_number, diameter_number;  ///< H and D, where they stay
  FeedMode feed_mode = FeedMode::per_minute;
  double feed_mm = 0;  ///< by minute or by revolution; 0: none
};

struct Spindle {
  std::optional<bool> on;  ///< empty: no word of it yet
  bool clockwise = true;
  std::optional<double> rpm;      ///< the S word in force
  bool constant_surface = false;  ///< G96
  /// That stopped it, and was no word of the spindle: "the M6 of line 7".
  std::optional<std::string> stopped_by;
  /// At which a machine may have stopped it since it was last started: "the M1 of line 7".
  std::optional<std::string> paused_by;
};

struct Coolant {
  bool mist = false, flood = false;
};

/// A stored position of G28 or G30 in machine coordinates, without the tool's length.
struct ReferencePoint {
  Vec3 at_mm;
  std::array<bool, 3> known{};
  bool from_program = false;
  RotaryAngles angles_deg{};
};

/// The machine while a program runs: modal state, offsets, tools, and where the tool stands.
struct MachineState {
  explicit MachineState(const MachineSetup& machine);

  ModalState modal;
  Spindle spindle;
  Coolant coolant;
  CoordinateSystems systems;
  ToolTable tools;
  Orientation orientation;
  std::array<ReferencePoint, 2> reference;  ///< of G28 and G30
  bool fresh = false;                       ///< MachineSetup::assume_fresh_machine
  std::optional<int> selected_tool;         ///< by T
  std::uint32_t selected_line = 0;          ///< of that T
  bool has_changed_tool = false;            ///< by M6 or M61, to whatever tool
  int shifted_by = 0;                       ///< 520 or 920: the code that last set their offset
  bool has_start = false;                   ///< MachineSetup::start_mm
  bool has_moved = false;
  Vec3 start_mm;  ///< of the tip, in the frame of G54; follows what G92 says of unknown axes

  /// In the active work frame; under cutter compensation the programmed point.
  Vec3 position_mm;
  std::array<bool, 3> known{};   ///< programmed, or stated by an offset
  std::array<bool, 3> adrift{};  ///< at a place that nothing states (Motion::parked, astray)
  Frame frame;                   ///< active; refresh() after a change of systems or tools

  /// Where another tool's tip has come to stand since the last motion.
  std::optional<TipPlace> moved_tip;

  void refresh();
  /// Carries out a change of the frame or of a length in effect that leaves the tool where it is.
  /// Under tip control, and of a tool in a head, a length acts along the tool, wherever it points.
  void keeping_tip(const std::function<void()>& change);
  /// Whether a tool that is changed now comes to stand with its tip where that of the one before
  /// stood: before the first motion, since the start is the tip's, and at an assumed height.
  bool keeps_tip_at_change() const { return has_start && (!has_moved || !known[2]); }
  /// The work coordinate of an unknown axis turns out to be `value_mm`: so was it at the start, as
  /// far away as the program has moved since.
  void take_place(int axis, double value_mm);
  /// How the places of motions lie in the workpiece now. Motions' places are in the machine's
  /// frame, or in the tilted working plane.
  MotionFrame motion_frame() const;
  /// The tip, in the workpiece where rotary axes turn it, else in the machine's frame.
  Vec3 tip_mm() const;
  /// Another tool's tip stands further down along the tool by that much, whatever offsets are in
  /// effect; not while Z is adrift, nor where a change keeps the tip.
  void lower_tip(std::uint32_t line, double by_mm);
  /// The tip in the workpiece. Only on a machine with rotary axes.
  Vec3 in_workpiece() const;
  /// Carries out a change of `orientation` that leaves the tool where it is. Where an axis is not
  /// known and becomes a mixture with others, none is.
  void keeping_tool(const std::function<void()>& change);
  bool is_compensated() const { return modal.compensation != 400; }
  bool is_adrift() const { return adrift[0] || adrift[1] || adrift[2]; }

 private:
  void stay_at(const Frame& before);
  void stand_at(const Vec3& tip_mm, const MotionFrame& before);
};

/// Whether the block names a coordinate in the plane.
bool names_place(const Statement& statement, ArcPlane plane);
/// Throws InputError at `word` while cutter compensation is on.
void forbid_compensation(const Statement& statement, const Word& word, const MachineState& state);

/// A word's length in mm. Throws InputError at a value beyond any machine.
double length_of(const Statement& statement, const Word& word, const MachineState& state);

}  // namespace limitgauge::model::gcode
