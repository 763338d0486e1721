#include "model/text/clean_text.h"

#include <algorithm>

namespace limitgauge::model {
namespace {

constexpr std::string_view kReplacement = "\xEF\xBF\xBD";

/// Length of the well-formed UTF-8 sequence at the head of `s`, 0 where there is none.
std::size_t sequence_length(std::string_view s) {
  const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(s[i]); };
  const unsigned char lead = byte(0);
  const std::size_t n = lead < 0x80   ? 1
                        : lead < 0xC2 ? 0
                        : lead < 0xE0 ? 2
                        : lead < 0xF0 ? 3
                        : lead < 0xF5 ? 4
                                      : 0;
  if (n == 0 || n > s.size()) return 0;
  for (std::size_t i = 1; i < n; ++i)
    if ((byte(i) & 0xC0) != 0x80) return 0;
  // Overlong forms, surrogates and what lies beyond U+10FFFF.
  if (n == 3 && lead == 0xE0 && byte(1) < 0xA0) return 0;
  if (n == 3 && lead == 0xED && byte(1) > 0x9F) return 0;
  if (n == 4 && lead == 0xF0 && byte(1) < 0x90) return 0;
  if (n == 4 && lead == 0xF4 && byte(1) > 0x8F) return 0;
  return n;
}

/// Characters that turn the direction of what follows: a text could look like another one.
bool turns_direction(std::string_view sequence) {
  const auto last = static_cast<unsigned char>(sequence.back());
  return (sequence.starts_with("\xE2\x80") && last >= 0xAA && last <= 0xAE) ||
         (sequence.starts_with("\xE2\x81") && last >= 0xA6 && last <= 0xA9);
}

bool is_allowed(std::string_view sequence) {
  if (sequence.size() == 1) {
    const auto c = static_cast<unsigned char>(sequence[0]);
    return (c >= 0x20 && c != 0x7F) || c == '\t' || c == '\n';
  }
  // C1 controls, and the two non-characters that XML 1.0 leaves out.
  const bool c1 = sequence.size() == 2 && sequence[0] == '\xC2' &&
                  static_cast<unsigned char>(sequence[1]) < 0xA0;
  return !c1 && !turns_direction(sequence) && sequence != "\xEF\xBF\xBE" &&
         sequence != "\xEF\xBF\xBF";
}

}  // namespace

std::string clean_text(std::string_view text) {
  std::string out;
  out.reserve(text.size());
  while (!text.empty()) {
    const std::size_t n = sequence_length(text);
    const std::string_view head = text.substr(0, std::max<std::size_t>(n, 1));
    out += n > 0 && is_allowed(head) ? head : kReplacement;
    text.remove_prefix(head.size());
  }
  return out;
}

std::string one_line(std::string_view text) {
  std::string line = clean_text(text);
  std::replace(line.begin(), line.end(), '\n', ' ');
  std::replace(line.begin(), line.end(), '\t', ' ');
  return line;
}

}  // namespace limitgauge::model
