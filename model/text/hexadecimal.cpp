#include "model/text/hexadecimal.h"

#include "model/text/characters.h"

namespace limitgauge::model {

std::string hexadecimal(unsigned char byte, std::string_view digits) {
  return {digits[byte >> 4], digits[byte & 15]};
}

std::string hexadecimal(std::span<const unsigned char> bytes) {
  std::string out;
  for (const unsigned char byte : bytes) out += hexadecimal(byte);
  return out;
}

std::string percent_encoded(std::string_view path) {
  constexpr std::string_view kPlain = "-._~/";
  std::string out;
  for (const char c : path) {
    const bool plain = is_letter(c) || is_digit(c) || kPlain.find(c) != std::string_view::npos;
    out += plain ? std::string(1, c)
                 : "%" + hexadecimal(static_cast<unsigned char>(c), kUpperHexDigits);
  }
  return out;
}

}  // namespace limitgauge::model
