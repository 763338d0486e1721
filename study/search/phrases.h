#pragma once

#include <cstddef>
#include <string>

namespace limitgauge::study {

/// A figure with its unit for a sentence: whole from 1000 up, else four significant digits; lengths
/// under a tenth of a millimetre in micrometres.
std::string quantity(double value, const std::string& unit);
/// "12 %": two significant digits, whole from 10 up; "less than 0.1 %" below that.
std::string percent(double share);
/// "1 case", "12 cases".
std::string counted(std::size_t count, const std::string& noun);

}  // namespace limitgauge::study
