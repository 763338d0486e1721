#include "model/base/words.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstdlib>
#include <vector>

namespace limitgauge::model {
namespace {

/// Longer words are nobody's typing error, and the distance takes quadratic time.
constexpr std::size_t kLongestComparedWord = 64;

char lower(char c) {
  return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
}

std::size_t edit_distance(std::string_view a, std::string_view b) {
  std::vector<std::size_t> row(b.size() + 1);
  for (std::size_t j = 0; j <= b.size(); ++j) row[j] = j;
  for (std::size_t i = 1; i <= a.size(); ++i) {
    std::size_t diagonal = row[0];
    row[0] = i;
    for (std::size_t j = 1; j <= b.size(); ++j) {
      const std::size_t replaced = diagonal + (lower(a[i - 1]) == lower(b[j - 1]) ? 0 : 1);
      diagonal = row[j];
      row[j] = std::min({row[j] + 1, row[j - 1] + 1, replaced});
    }
  }
  return row[b.size()];
}

}  // namespace

std::optional<double> parse_number(std::string_view text) {
  if (text.size() > 1 && text[0] == '+' && text[1] != '-') text.remove_prefix(1);
  double value = 0;
  const char* const end = text.data() + text.size();
  const auto [stop, error] = std::from_chars(text.data(), end, value);
  if (error != std::errc() || stop != end || !std::isfinite(value)) return std::nullopt;
  return value;
}

std::string shortest(double value) {
  std::array<char, 32> buffer{};
  const auto end =
      std::to_chars(buffer.data(), buffer.data() + buffer.size(), value == 0 ? 0.0 : value);
  return std::string(buffer.data(), end.ptr);
}

std::string nearest_word(std::string_view word, const std::string_view* known, std::size_t count) {
  std::string_view best;
  std::size_t best_distance = kLongestComparedWord;
  if (word.size() > kLongestComparedWord) return {};
  for (std::size_t i = 0; i < count; ++i) {
    const std::size_t edits = edit_distance(word, known[i]);
    if (edits < best_distance) best = known[i], best_distance = edits;
  }
  const std::size_t allowed = std::max<std::size_t>(1, std::max(word.size(), best.size()) / 3);
  return best_distance <= allowed && best_distance < word.size() ? std::string(best)
                                                                 : std::string();
}

std::string in_quotes(std::string_view text) {
  constexpr std::size_t kLongest = 40;
  std::string quoted = "'";
  // What is shown may come from anywhere: no control characters reach the reader's terminal.
  for (const char c : text.substr(0, kLongest)) quoted += c >= ' ' && c <= '~' ? c : '?';
  quoted.append(text.size() > kLongest ? "...'" : "'");
  return quoted;
}

}  // namespace limitgauge::model
