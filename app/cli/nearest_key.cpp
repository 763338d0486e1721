#include "app/cli/nearest_key.h"

#include <algorithm>
#include <limits>
#include <vector>

namespace limitgauge::app {
namespace {

/// Longer words are nobody's slip, and the distance takes quadratic time and memory.
constexpr std::size_t kLongestCompared = 64;

/// Optimal string alignment distance: a swap of neighbours is the commonest slip of the keyboard.
std::size_t edit_distance(std::string_view a, std::string_view b) {
  std::vector<std::vector<std::size_t>> d(a.size() + 1, std::vector<std::size_t>(b.size() + 1));
  for (std::size_t i = 0; i <= a.size(); ++i) d[i][0] = i;
  for (std::size_t j = 0; j <= b.size(); ++j) d[0][j] = j;
  for (std::size_t i = 1; i <= a.size(); ++i) {
    for (std::size_t j = 1; j <= b.size(); ++j) {
      const std::size_t change = a[i - 1] == b[j - 1] ? 0 : 1;
      d[i][j] = std::min({d[i - 1][j] + 1, d[i][j - 1] + 1, d[i - 1][j - 1] + change});
      if (i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1]) {
        d[i][j] = std::min(d[i][j], d[i - 2][j - 2] + 1);
      }
    }
  }
  return d[a.size()][b.size()];
}

}  // namespace

std::string nearest_key(std::string_view word, std::span<const std::string_view> known) {
  std::string_view best;
  std::size_t least = std::numeric_limits<std::size_t>::max();
  for (const std::string_view key : known) {
    const std::size_t distance =
        edit_distance(word.substr(0, kLongestCompared), key.substr(0, kLongestCompared));
    if (distance < least) least = distance, best = key;
  }
  return std::string(best);
}

}  // namespace limitgauge::app
