#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "model/text/clean_text.h"
#include "model/text/rounded.h"
#include "verifier/gate/deviation.h"

namespace limitgauge::reports {

using model::clean_text;
/// `text` cleaned, with the five characters that mean something to HTML and XML as entities.
std::string escape_markup(std::string_view text);
/// The parts with `between` between them.
std::string joined(const std::vector<std::string>& parts, std::string_view between);
/// Number of code points: what a terminal shows of `text` where no character is wide.
std::size_t code_points(std::string_view text);
/// `text` cut to `width` code points, the last one an ellipsis where something is lost.
std::string shortened(std::string_view text, std::size_t width);

/// `value` with `decimals` places after the point; never "-0".
inline std::string fixed(double value, int decimals) {
  return model::with_decimals(value, decimals);
}
/// `value` with three significant digits, no exponent between 1e-4 and 1e7.
std::string three_digits(double value);
/// 98325 as "98 325", with narrow no-break spaces from five digits on.
std::string grouped(std::uint64_t count);

/// The unit that a length is shown in.
struct LengthUnit {
  double per_mm = 1;
  const char* symbol = "mm";
};
/// Micrometres where every length shown beside each other is below 0.1 mm, millimetres else.
LengthUnit unit_for(double largest_mm);
/// A measured length, three significant digits and its unit: "0.445 µm", "1.25 mm".
std::string measured_length(double mm);
/// A stated length, all its digits and its unit: "10 µm", "0.2 mm".
std::string stated_length(double mm);

/// "0.8 s", "12.4 s", "3 min 05 s", "1 h 02 min".
std::string duration_text(double seconds);
/// "1:33:05": hours, minutes and seconds, for columns of times.
std::string clock_text(double seconds);
/// "21.8 MB" (10^6 bytes, as the paper's tables count).
std::string bytes_text(std::size_t bytes);
/// A share as a percentage that never rounds up to a whole it has not reached: "99.98 %".
std::string percent_text(double share);
/// "pass", "not run".
std::string verdict_text(verifier::Verdict verdict);

/// `text` as a cell of an RFC 4180 file: in quotes always, with an apostrophe before what a
/// spreadsheet would take for a formula.
std::string csv_text_cell(std::string_view text);

/// `bytes` in base64 (RFC 4648, padded), on one line.
std::string base64(std::string_view bytes);

}  // namespace limitgauge::reports
