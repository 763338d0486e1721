#pragma once

#include <string>
#include <string_view>

#include "reports/run/finding_list.h"

namespace limitgauge::reports::sarif {

/// What tells one finding from another across runs. Both begin with 16 hexadecimal digits, the
/// FNV-1a hash (64 bits) of lines that end in line feeds:
///   place: "place/1", kind, stage, body, what is met, then the cell of 2 mm: floor(c / 2 +
///   0.381966)
///          for c = x, y, z of `ListedFinding::about`, with commas
///   line:  "line/1", kind, stage, body, what is met, then the program line, normalised
/// Neither holds a line number or a depth. The cells' borders lie at odd places, where coordinates
/// of designs seldom are, so that the last bits of a figure do not choose between two cells.
std::string place_fingerprint(const ListedFinding& finding, std::string_view stage);
std::string line_fingerprint(const ListedFinding& finding, std::string_view stage,
                             std::string_view program_line);

/// `line` without comments, blanks and its N word, in capitals.
std::string normalised_line(std::string_view line);
/// The FNV-1a hash of `text`, 64 bits, 16 lower-case hexadecimal digits.
std::string hash_text(std::string_view text);

}  // namespace limitgauge::reports::sarif
