#include "app/serve/byte_ranges.h"

#include <algorithm>
#include <limits>
#include <utility>

#include "app/serve/http_request.h"
#include "model/text/characters.h"

namespace limitgauge::app {
namespace {

/// A number too large for its type is the largest: no file has as many bytes.
std::optional<std::uint64_t> position_of(std::string_view digits) {
  constexpr std::uint64_t kLargest = std::numeric_limits<std::uint64_t>::max();
  std::uint64_t number = 0;
  for (const char c : digits) {
    if (!model::is_digit(c)) return std::nullopt;
    const auto digit = static_cast<std::uint64_t>(c - '0');
    number = number > (kLargest - digit) / 10 ? kLargest : number * 10 + digit;
  }
  return number;
}

/// "FIRST-LAST", "FIRST-" or "-COUNT". False where it is none of them; adds nothing where no byte
/// of it is there.
bool add_range(std::string_view spec, std::uint64_t bytes, std::vector<ByteRange>& ranges) {
  const std::size_t dash = spec.find('-');
  if (dash == spec.npos || spec.size() == 1) return false;
  const auto first = position_of(spec.substr(0, dash)), last = position_of(spec.substr(dash + 1));
  if (!first || !last) return false;
  if (dash == 0) {
    // The last bytes of an empty file are there, and none: no range can say so, the whole can.
    if (bytes == 0 && *last > 0) return false;
    const std::uint64_t count = std::min(*last, bytes);
    if (count > 0) ranges.push_back({bytes - count, bytes - 1});
    return true;
  }
  const bool open = dash + 1 == spec.size();
  if (!open && *last < *first) return false;
  if (*first < bytes) ranges.push_back({*first, open ? bytes - 1 : std::min(*last, bytes - 1)});
  return true;
}

bool has_overlap(std::vector<ByteRange> ranges) {
  std::sort(ranges.begin(), ranges.end(),
            [](const ByteRange& a, const ByteRange& b) { return a.first < b.first; });
  return std::adjacent_find(ranges.begin(), ranges.end(),
                            [](const ByteRange& a, const ByteRange& b) {
                              return b.first <= a.last + 1;
                            }) != ranges.end();
}

std::vector<ByteRange> made_one(std::vector<ByteRange> ranges) {
  if (!has_overlap(ranges)) return ranges;
  std::sort(ranges.begin(), ranges.end(),
            [](const ByteRange& a, const ByteRange& b) { return a.first < b.first; });
  std::vector<ByteRange> merged;
  for (const ByteRange& range : ranges) {
    if (!merged.empty() && range.first <= merged.back().last + 1)
      merged.back().last = std::max(merged.back().last, range.last);
    else
      merged.push_back(range);
  }
  return merged;
}

bool asks_for_bytes(std::string_view unit) {
  constexpr std::string_view kUnit = "bytes";
  return std::equal(unit.begin(), unit.end(), kUnit.begin(), kUnit.end(),
                    [](char a, char b) { return model::lower(a) == b; });
}

}  // namespace

std::optional<std::vector<ByteRange>> ranges_of(std::string_view field, std::uint64_t bytes) {
  const std::size_t equals = field.find('=');
  if (equals == field.npos || !asks_for_bytes(field.substr(0, equals))) return std::nullopt;
  std::string_view rest = field.substr(equals + 1);
  std::vector<ByteRange> ranges;
  std::size_t count = 0;
  for (bool more = true; more;) {
    const std::size_t comma = rest.find(',');
    const std::string_view spec = without_blanks_around(rest.substr(0, comma));
    more = comma != rest.npos;
    if (more) rest.remove_prefix(comma + 1);
    if (spec.empty()) continue;
    if (++count > kMostRanges || !add_range(spec, bytes, ranges)) return std::nullopt;
  }
  if (count == 0) return std::nullopt;
  return made_one(std::move(ranges));
}

}  // namespace limitgauge::app
