#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "model/geometry/vec3.h"

namespace limitgauge::model {

/// A point that was measured on a part, in the part's frame.
struct MeasuredPoint {
  Vec3 at_mm;
  double u_mm = 0;  ///< standard uncertainty, above zero; 0 where the file has no such column
  int line = 0;     ///< of the file
};

struct MeasuredPoints {
  std::vector<MeasuredPoint> points;  ///< in the order of the file, at least one
  bool has_uncertainty = false;
  std::vector<std::string> ignored;  ///< columns that mean nothing here, as the header names them
};

/// Measured points as a table: a header line that names the columns x, y, z and optionally u_mm
/// (x_mm, y_mm and z_mm are the same), then a line a point. Columns are parted by semicolons where
/// the header has one, else by commas where it has one, else by blanks; CRLF, a byte order mark,
/// blank lines and cells in double quotes are all right. Throws InputError with line and column for
/// what is no number, an uncertainty that is not above zero, a missing column or cell, coordinates
/// beyond coordinate_limit.h, and for a table without points. `shown` names it.
MeasuredPoints parse_measured_points(std::string_view text, const std::string& shown);
/// The same of a file.
MeasuredPoints read_measured_points(const std::filesystem::path& file);

}  // namespace limitgauge::model
