#pragma once

#include <array>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "model/geometry/vec3.h"
#include "model/machine/control.h"
#include "model/machine/kinematics.h"

namespace limitgauge::model {

/// Where a work coordinate system lies on the machine: its origin in machine coordinates, turned
/// about Z, counter-clockwise seen from above.
struct WorkOffset {
  Vec3 origin_mm;
  double rotation_deg = 0;
};

/// One line of the machine's tool table. Tool numbers and offset numbers (H, D) share it: H2 asks
/// for the length of entry 2, D2 for its diameter.
struct ToolEntry {
  int number = 0;
  std::optional<double> length_mm;    ///< from the spindle's gauge line to the tip
  std::optional<double> diameter_mm;  ///< for cutter compensation
};

inline constexpr std::size_t kWorkOffsets = 9;  ///< G54 to G59, G59.1 to G59.3

/// What a program takes from the machine that it runs on. What is empty here and asked for by the
/// program is an error of the reader that names it, except as `assume_fresh_machine` says.
struct MachineSetup {
  Control control = Control::linuxcnc;  ///< whose habits programs are read by
  bool control_is_stated = false;
  /// Where programs may find subprograms in files of their own; empty: nowhere.
  std::filesystem::path subprograms;
  std::array<std::optional<WorkOffset>, kWorkOffsets> work_offsets;
  /// G54.1 P or G154 P of Fanuc and Haas, by P.
  std::map<int, WorkOffset> extended_offsets;
  std::optional<Vec3> home_mm, second_home_mm;  ///< G28 and G30, machine coordinates
  std::vector<ToolEntry> tools;
  /// What every T loads, whatever its number; only where `tools` is empty.
  std::optional<ToolEntry> only_tool;
  /// The tool in the spindle before the first tool change; empty: none, or the only one in `tools`.
  std::optional<int> loaded_tool;
  /// Where the tip stands before the first line, in the frame of G54. Every axis is known then, as
  /// it is to a control. Empty: at the programmed zero.
  std::optional<Vec3> start_mm;
  /// Nobody stated `start_mm`: it is where the tip is taken to stand, and an axis stays unknown
  /// until the program names it.
  bool start_is_assumed = false;
  /// Its rotary axes; empty: it has none that programs may turn.
  std::optional<Kinematics> kinematics;
  /// Whether programmed places are the tip's in the workpiece before a code says so (LinuxCNC's
  /// kinematics of type 0 may be either); empty: nobody said, and they are taken to be joints.
  std::optional<bool> starts_tool_centred;
  /// As LinuxCNC with an empty parameter file: offsets and reference points not stated lie at the
  /// machine's zero. Each that the program uses is listed in Program::assumed.
  bool assume_fresh_machine = false;
};

/// Where the tip stands before the first line of a job's programs, in the frame of their G54.
struct ProgramStart {
  Vec3 at_mm;
  bool assumed = false;  ///< nobody stated it
};

/// `G54` to `G59.3` for index 0 to 8, `G54.1 P1` and so on behind them.
std::string work_offset_name(std::size_t index);

/// LinuxCNC's tool table text: a line a tool, `T` number, `Z` length, `D` diameter, other words
/// (`P` pocket and the rest) read and dropped, `;` begins a remark. Lengths in mm, or inches where
/// `inch`. Throws InputError with line and column.
std::vector<ToolEntry> parse_tool_table(const std::string& text, const std::string& name,
                                        bool inch = false);

}  // namespace limitgauge::model
