#pragma once

#include <string>
#include <string_view>

namespace limitgauge::model {

/// `text` as valid UTF-8 that XML, JSON and a terminal may be given: control characters (but for
/// tab and line feed), malformed bytes and characters that turn the direction of writing
/// (U+202A to U+202E, U+2066 to U+2069) become U+FFFD.
std::string clean_text(std::string_view text);
/// The same on one line: tabs and line feeds become spaces.
std::string one_line(std::string_view text);

}  // namespace limitgauge::model
