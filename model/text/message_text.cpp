#include "model/text/message_text.h"

#include <algorithm>
#include <limits>
#include <vector>

#include "model/text/characters.h"
#include "model/text/hexadecimal.h"

namespace limitgauge::model {
namespace {

/// Longer words are nobody's slip, and the distance takes quadratic time and memory.
constexpr std::size_t kLongestCompared = 64;

bool same_letter(char a, char b) {
  return lower(a) == lower(b);
}

/// Optimal string alignment distance: a swap of neighbours is the commonest slip of the keyboard.
std::size_t slips(std::string_view a, std::string_view b) {
  std::vector<std::vector<std::size_t>> d(a.size() + 1, std::vector<std::size_t>(b.size() + 1));
  for (std::size_t i = 0; i <= a.size(); ++i) d[i][0] = i;
  for (std::size_t j = 0; j <= b.size(); ++j) d[0][j] = j;
  for (std::size_t i = 1; i <= a.size(); ++i) {
    for (std::size_t j = 1; j <= b.size(); ++j) {
      const std::size_t change = same_letter(a[i - 1], b[j - 1]) ? 0 : 1;
      d[i][j] = std::min({d[i - 1][j] + 1, d[i][j - 1] + 1, d[i - 1][j - 1] + change});
      if (i > 1 && j > 1 && same_letter(a[i - 1], b[j - 2]) && same_letter(a[i - 2], b[j - 1]))
        d[i][j] = std::min(d[i][j], d[i - 2][j - 2] + 1);
    }
  }
  return d[a.size()][b.size()];
}

struct Nearest {
  std::string_view word;
  std::size_t slips = std::numeric_limits<std::size_t>::max();
};

Nearest nearest(std::string_view word, std::span<const std::string_view> known) {
  Nearest best;
  for (const std::string_view one : known) {
    const std::size_t apart =
        slips(word.substr(0, kLongestCompared), one.substr(0, kLongestCompared));
    if (apart < best.slips) best = {one, apart};
  }
  return best;
}

}  // namespace

std::string in_quotes(std::string_view text) {
  constexpr std::size_t kLongest = 40;
  std::string quoted = "'";
  // What is shown may come from anywhere: no control characters reach the reader's terminal.
  for (const char c : text.substr(0, kLongest)) quoted += c >= ' ' && c <= '~' ? c : '?';
  quoted.append(text.size() > kLongest ? "...'" : "'");
  return quoted;
}

std::string in_quotes(char c) {
  const auto byte = static_cast<unsigned char>(c);
  if (byte >= 0x20 && byte < 0x7F) return in_quotes(std::string_view(&c, 1));
  return "byte 0x" + hexadecimal(byte);
}

std::string nearest_word(std::string_view word, std::span<const std::string_view> known) {
  return std::string(nearest(word, known).word);
}

std::string meant_word(std::string_view word, std::span<const std::string_view> known) {
  if (word.size() > kLongestCompared) return {};
  const Nearest best = nearest(word, known);
  const std::size_t allowed = std::max<std::size_t>(1, std::max(word.size(), best.word.size()) / 3);
  return best.slips <= allowed && best.slips < word.size() ? std::string(best.word) : std::string();
}

}  // namespace limitgauge::model
