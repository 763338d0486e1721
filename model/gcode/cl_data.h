#pragma once

#include <array>
#include <filesystem>
#include <istream>
#include <optional>
#include <ostream>
#include <string>

#include "model/part/cutter_figures.h"
#include "model/part/toolpath.h"

namespace limitgauge::model {

/// A part program of cutter locations: straight moves of the tip of one tool.
struct ClData {
  std::string part;  ///< the text of PARTNO
  /// Of CUTTER; height 0 in its short forms.
  std::optional<SevenFigures> cutter;
  std::optional<int> tool;  ///< of LOADTL
  Toolpath path;
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
void write_cl_data(const Toolpath& path, const Cutter& cutter, const ClOptions& options,
                   std::ostream& out);

/// Reads CL data of this vocabulary: PARTNO, PPRINT and REMARK (text up to the line's end), UNITS
/// (MM or INCHES), CUTTER (one, two or all seven figures, of a cutter that can be made), LOADTL,
/// SPINDL and COOLNT (not acted on), FROM, RAPID, FEDRAT (a number with MMPM or IPM, on either
/// side, or alone: in the units that hold), GOTO with three coordinates or six whose tool axis is
/// 0, 0, 1, FINI; statements continued by `$`, remarks behind `$$`, blanks and either case. RAPID
/// holds for the next GOTO only. Where no FROM stands, the path starts at the first GOTO. Nothing
/// behind FINI is read, and it must be there. What is not understood is an InputError with line and
/// column, never skipped.
ClData read_cl_data(const std::filesystem::path& path);
ClData read_cl_data(std::istream& in, const std::string& name_in_errors);

}  // namespace limitgauge::model
