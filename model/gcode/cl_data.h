#pragma once

#include <cstdint>
#include <filesystem>
#include <istream>
#include <optional>
#include <ostream>
#include <string>
#include <string_view>
#include <vector>

#include "model/gcode/program.h"
#include "model/part/cutter.h"
#include "model/part/toolpath.h"

namespace limitgauge::model {

/// A part program of cutter locations: straight moves of the tip of one tool, whose axis may turn.
struct ClData {
  std::string part;  ///< the text of PARTNO
  /// Of CUTTER; height 0 in its short forms.
  std::optional<SevenFigures> cutter;
  std::string cutter_as_stated;  ///< "CUTTER/6,3"; empty without one
  std::uint32_t cutter_line = 0;
  bool units_are_stated = false;  ///< by UNITS; without it lengths are millimetres
  std::optional<int> tool;        ///< of LOADTL
  std::uint32_t tool_line = 0;
  std::vector<IgnoredWord> ignored;  ///< SPINDL and COOLNT
  /// FROM: where the tip stands before the first motion. Without it nothing is said of that.
  std::optional<Vec3> from;
  std::string from_as_stated;  ///< "FROM/0,0,50"; empty without one
  std::uint32_t from_line = 0;
  std::optional<Vec3> from_axis;  ///< how the tool stands there, a unit vector
  std::vector<Move> moves;        ///< every GOTO, the first one as well
  /// The tool's axis at the end of each move, unit vectors; empty where it stands along 0,0,1 at
  /// FROM and throughout.
  std::vector<Vec3> axes;
  std::uint32_t turning_line = 0;  ///< the first move that turns the tool; 0: none
  std::uint32_t kept_axis_line =
      0;  ///< the first GOTO of three figures with a tool tilted; 0: none
};

/// What stands above the moves.
struct ClOptions {
  std::string part;
  int tool_number = 1;
  int decimals = 4;  ///< 0 to 9
};

/// Writes `path` as APT-style CL data: PARTNO, UNITS/MM, CUTTER (diameter alone for flat cutters,
/// diameter and corner radius for ball and bull, all seven figures for the others), LOADTL, FROM,
/// RAPID before every GOTO of a rapid, FEDRAT where the feed rate changes, FINI; no line is longer
/// than 72 columns. Coordinates are rounded to `decimals`; feed rates are exact. Throws
/// std::invalid_argument for points beyond ±1e9 mm, feed moves without a feed rate and options out
/// of range; ResourceError where `out` fails.
///
/// With `axes`, which must fit the path (require_axes), MULTAX/ON stands before FROM, and FROM and
/// GOTO have the tool's axis to nine decimals behind the place: what read_cl_data() makes moves
/// with axes of.
void write_cl_data(const Toolpath& path, const Cutter& cutter, const ClOptions& options,
                   std::ostream& out, const ToolAxes* axes = nullptr);

/// Reads CL data of this vocabulary: PARTNO, PPRINT and REMARK (text up to the line's end), UNITS
/// (MM or INCHES), CUTTER (one, two or all seven figures, of a cutter that can be made), LOADTL,
/// SPINDL and COOLNT (not acted on), FROM, RAPID, FEDRAT (a number with MMPM or IPM, on either
/// side, or alone: in the units that hold), GOTO with three coordinates or six, MULTAX (ON or OFF),
/// FINI; statements continued by `$`, remarks behind `$$`, blanks and either case. RAPID holds for
/// the next GOTO only. Every GOTO is a motion, the first one too, with or without a FROM. The last
/// three of six figures are the tool's axis, from its tip to the spindle, of length 1 within 1e-3;
/// with three figures it stays as it was, 0,0,1 at first. A GOTO that turns it by more than 90
/// degrees is an error, and one that turns it at all behind MULTAX/OFF.
/// Nothing behind FINI is read, and it must be there. What is not understood is an InputError with
/// line and column, never skipped.
ClData read_cl_data(const std::filesystem::path& path);
ClData read_cl_data(std::istream& in, const std::string& name_in_errors);

/// Whether a program is CL data: the ending of its name is .apt, .cl, .cls or .ncl, or it begins
/// with a word of APT and what belongs behind it.
bool is_cl_data(std::string_view text, const std::string& name);

/// CL data as a program. The coordinates are those of the frame of G54, lengths of tools are none
/// of their business: they are of the tip. The tool stands at FROM before the first motion,
/// unless `machine` states its start: then a FROM elsewhere is listed as not acted on. Without FROM
/// its axis is that of the first motion from the start on. What CUTTER says is listed as assumed,
/// how a tool turns, and millimetres without UNITS.
Program to_program(const ClData& data, const std::string& name, const MachineSetup& machine);

}  // namespace limitgauge::model
