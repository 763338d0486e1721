#include "model/gcode/text/characters.h"

#include <string_view>

#include "model/base/message_text.h"

namespace limitgauge::model::gcode {

std::string shown(char c) {
  const auto byte = static_cast<unsigned char>(c);
  if (byte >= 0x20 && byte < 0x7F) return in_quotes(std::string_view(&c, 1));
  constexpr std::string_view kDigits = "0123456789abcdef";
  return std::string("byte 0x") + kDigits[byte / 16] + kDigits[byte % 16];
}

}  // namespace limitgauge::model::gcode
