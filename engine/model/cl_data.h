#pragma once

#include <array>
#include <filesystem>
#include <istream>
#include <optional>
#include <ostream>
#include <string>

#include "engine/model/cutter.h"
#include "engine/model/toolpath.h"

namespace limitgauge::model {

/// A cutter as APT has it: a corner circle between a lower and an upper line, turned about the
/// axis. Lengths mm, angles degrees. The taper of `Cutter` has its lower line level (a = 0).
struct ClCutter {
  double diameter = 0;       ///< d: twice the distance from the axis to where the two lines meet
  double corner_radius = 0;  ///< r
  double centre_radius = 0;  ///< e: from the axis to the corner circle's centre
  double centre_height = 0;  ///< f: from the tip to the corner circle's centre, along the axis
  double lower_angle = 0;    ///< a: of the lower line, from level
  double upper_angle = 0;    ///< b: of the upper line, from the axis
  double height = 0;         ///< h: of the whole cutter

  friend bool operator==(const ClCutter&, const ClCutter&) = default;
};
ClCutter cl_cutter(const Cutter& cutter);

/// A part program of cutter locations: straight moves of the tip of one tool.
struct ClData {
  std::string part;  ///< the text of PARTNO
  std::optional<ClCutter> cutter;
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
/// diameter and corner radius for ball and bull, all seven figures for tapers), LOADTL, FROM,
/// RAPID before every GOTO of a rapid, FEDRAT where the feed rate changes, FINI; no line is longer
/// than 72 columns. Coordinates are rounded to `decimals`; feed rates are exact. Throws
/// std::invalid_argument for points beyond ±1e9 mm, feed moves without a feed rate and options out
/// of range; ResourceError where `out` fails.
void write_cl_data(const Toolpath& path, const Cutter& cutter, const ClOptions& options,
                   std::ostream& out);

/// Reads CL data of this vocabulary: PARTNO, PPRINT and REMARK (text up to the line's end), UNITS
/// (MM or INCHES), CUTTER, LOADTL, SPINDL and COOLNT (not acted on), FROM, RAPID, FEDRAT (a number
/// with MMPM or IPM, on either side, or alone: in the units that hold), GOTO with three coordinates
/// or six whose tool axis is 0, 0, 1, FINI; statements continued by `$`, remarks behind `$$`,
/// blanks and either case. RAPID holds for the next GOTO only. Where no FROM stands, the path
/// starts at the first GOTO. Nothing behind FINI is read, and it must be there. What is not
/// understood is an InputError with line and column, never skipped.
ClData read_cl_data(const std::filesystem::path& path);
ClData read_cl_data(std::istream& in, const std::string& name_in_errors);

}  // namespace limitgauge::model
