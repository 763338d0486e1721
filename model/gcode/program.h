#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <istream>
#include <optional>
#include <ostream>
#include <string>
#include <string_view>
#include <vector>

#include "model/gcode/dialect.h"
#include "model/machine/machine_setup.h"
#include "model/machine/turning_motion.h"
#include "model/part/toolpath.h"

namespace limitgauge::model {

enum class MotionKind : std::uint8_t { rapid, feed, arc };
/// G17, G18, G19.
enum class ArcPlane : std::uint8_t { xy = 17, zx = 18, yz = 19 };

/// First, second and perpendicular axis of a plane.
constexpr std::array<int, 3> axes_of(ArcPlane plane) {
  if (plane == ArcPlane::zx) return {2, 0, 1};
  if (plane == ArcPlane::yz) return {1, 2, 0};
  return {0, 1, 2};
}

/// A canonical motion of a program: the tip of the tool in the machine's frame, mm.
struct Motion {
  MotionKind kind = MotionKind::rapid;
  ArcPlane plane = ArcPlane::xy;
  /// Every axis has been stated or programmed by the end of this motion; of the others `to` is as
  /// far from where the tip was taken to stand as the program has moved them.
  bool position_known = true;
  /// By M5, a tool change or S0, or before the first M3 or M4 of a program that has one.
  bool spindle_stopped : 1 = false;
  /// Z stands at a place that nothing states (G28, G30 or G53 Z0 of a machine whose setup is not
  /// known) and is taken to be above everything; `to.z` is then the last known height.
  bool parked : 1 = false;
  /// X or Y stand at such a place; allowed only while parked.
  bool astray : 1 = false;
  /// Z has been stated or programmed by the end of this motion.
  bool height_known : 1 = true;
  std::uint32_t line = 0;
  float feed_mm_min = 0;  ///< 0 where a feed move has none: a finding, not an error
  Vec3 to;
  double centre1 = 0, centre2 = 0;  ///< arc centre in the plane's first and second axis, absolute
  double turns = 0;                 ///< of an arc, whole or begun; positive: counter-clockwise
};
static_assert(sizeof(Motion) == 64);

/// `LINE rapid X Y Z`, `LINE feed X Y Z` or `LINE arc PLANE X Y Z C1 C2 TURNS`, in the shortest
/// decimals that read back as the same numbers.
std::string to_text(const Motion& motion);

/// An auxiliary word that does not move the tool and was therefore not acted on.
struct IgnoredWord {
  std::uint32_t line = 0;
  std::string word;
};

/// A tool that comes into the spindle before motion `motion`.
struct ToolChange {
  std::uint32_t line = 0;  ///< 0: it was there at the start
  std::size_t motion = 0;
  int tool = 0;
};

/// Before motion `motion` another tool has come into the spindle, which stood still: its tip is at
/// `at_mm`, not where the motion before ended.
struct TipPlace {
  std::size_t motion = 0;
  std::uint32_t line = 0;
  Vec3 at_mm;  ///< in the workpiece where rotary axes turn it, else in the machine's frame
  RotaryAngles angles_deg{};  ///< at which they stand
};

/// From motion `motion` on the rotary axes stand at `angles_deg`, and the places that motions name
/// lie in the workpiece as `frame` says.
struct FrameChange {
  std::size_t motion = 0;
  RotaryAngles angles_deg{};
  MotionFrame frame;
};

/// Motion `motion` turns rotary axes. Where it leads is said by `turn`; its own place is in the
/// frame of the motion before it.
struct AxisTurn {
  std::size_t motion = 0;
  std::uint32_t line = 0;
  bool rapid = true, spindle_stopped = false;
  bool parked = false;  ///< Z stands above everything
  TurningMotion turn;   ///< of an arc, from its start straight to its end
  double minutes = 0;   ///< that it takes, of a feed; 0: nothing says
  /// A, B and C: by a word that says where to, wherever the axis stood before.
  std::array<bool, 3> named{};
};

/// A comment that stands before motion `motion`: a name for what follows, perhaps.
struct ProgramComment {
  std::uint32_t line = 0;
  std::size_t motion = 0;
  std::string text;  ///< without its parentheses or semicolon, trimmed
};

/// A program as read: canonical motions, and what was set aside.
struct Program {
  std::string name;
  std::vector<Motion> motions;
  std::vector<IgnoredWord> ignored;
  std::vector<ToolChange> tool_changes;
  std::vector<TipPlace> tip_places;      ///< by rising motion
  std::vector<ProgramComment> comments;  ///< of lines that hold nothing else
  std::vector<FrameChange> frames;  ///< of a machine with rotary axes, by rising motion; else none
  std::vector<AxisTurn> turns;      ///< by rising motion
  /// Of CL data whose tool does not stand along +Z throughout: how it stands at the end of each
  /// motion, in the machine's frame.
  std::optional<ToolAxes> axes;
  /// What was taken for granted, in words with the line: an offset of a fresh machine, a park
  /// position, a length offset that is taken to be the tool's own.
  std::vector<std::string> assumed;
  /// What G92 or G10 L20 say of where the tip stood before the first line, in the frame of G54, of
  /// axes that nothing had stated or programmed until then.
  std::array<std::optional<double>, 3> start_said_mm;
  /// The last line that set a work offset, a shift of G92 or G52 or a tool's offset, where the
  /// program ends with others than it began with; 0: it ends with those.
  std::uint32_t offsets_left = 0;
  bool has_end = true;          ///< by M2, M30, '%' or, in CL data, FINI
  bool ends_in_line = true;     ///< false: the file's last line has no end
  bool starts_spindle = false;  ///< M3 or M4 somewhere; without, the spindle is taken to turn

  /// The turn that motion `motion` is; nothing where no axis turns.
  const AxisTurn* turn_of(std::size_t motion) const;
  /// Where a tool change before motion `motion` has put the tip; nothing where none has.
  const TipPlace* tip_place_of(std::size_t motion) const;
};

/// What is to be said of a program without an end.
std::string missing_end_words(const Program& program);

/// Reads a program in G-code or, where is_cl_data() says so, in CL data (cl_data.h).
///
/// Reads RS274/NGC as LinuxCNC documents it, with the habits of Fanuc and Grbl that do not
/// contradict it; docs/programs.md lists every code. A word that is not understood is an InputError
/// with line and column, never skipped. The motions are those of LinuxCNC (its order of execution,
/// arc tolerances and count of turns), with these choices where it asks the machine:
///  - lines that begin with `/` are carried out (the switch is off) and listed as ignored `/`;
///  - axes that were never programmed stand where `machine` has the start, by default at 0, and
///    leave position_known false unless the start is stated;
///  - a program may end without M2 or M30, unless it began with `%`; nothing behind its end is read
///    but subprograms that it calls;
///  - a parameter that was never set is an error where it is read;
///  - what `machine` does not state and the program needs is an error, except the machine's zero
///    along Z and the reference points: a move to them that nothing states leaves the axis parked.
/// Other controls than LinuxCNC (MachineSetup::control) have rules of their own
/// (model/gcode/control).
/// Comments that a controller acts on, as `(MSG, text)`, are listed as ignored.
Program read_program(const std::filesystem::path& path, const MachineSetup& machine = {});
Program read_program(std::istream& in, const std::string& name_in_errors,
                     const MachineSetup& machine = {});
/// Of a text that is at hand: no copy of it is made.
Program read_program(std::string_view text, const std::string& name_in_errors,
                     const MachineSetup& machine = {});

/// The same; where the machine's control does not read the program, the error names those that
/// would. For what users see: it may read the program once for each control.
Program read_program_or_name_control(const std::filesystem::path& path,
                                     const MachineSetup& machine);
Program read_program_or_name_control(std::string_view text, const std::string& name_in_errors,
                                     const MachineSetup& machine);

/// The files of `folder` that programs may call, sorted: named by a number, with or without O. None
/// for an empty folder. Throws InputError for a folder that cannot be read.
std::vector<std::filesystem::path> subprogram_files(const std::filesystem::path& folder);

/// How a toolpath is written as a program.
struct WriterOptions {
  std::string program_name = {};
  std::string comment = {};
  int decimals = 4;        ///< 0 to what the dialect takes
  double spindle_rpm = 0;  ///< 0: no S word
  int tool_number = 1;     ///< 0 to 9999; Fanuc: the program's number too, where it is not 0
  Dialect dialect = Dialect::linuxcnc;
  /// Arcs may stand for runs of feed moves within this; empty: moves only (arc_fit.h).
  std::optional<double> arc_tolerance_mm = std::nullopt;
  /// N words, from 1 to 99999 and then from 1 again.
  bool line_numbers = false;
};
/// Writes `path` as G-code and gives every move the line that it stands on. The coordinates in
/// `path` are rounded to what is written, rapids lose their feed rate, and feed rates are rounded
/// where the dialect's are, so that the program read back is the same path; a move that rounding
/// leaves without length is still written as one. Where arcs are asked for, the program read back
/// is another path within their tolerance of this one: read_program and to_toolpath give it. The
/// tool goes to the start's height first, then over the start; no length offset is set, since the
/// coordinates are those of the tool's tip. Throws std::invalid_argument before anything is written
/// for points and feed rates beyond what the dialect takes, feed moves without a feed rate and
/// options out of range; ResourceError where `out` fails.
void write_program(Toolpath& path, const WriterOptions& options, std::ostream& out);

}  // namespace limitgauge::model
