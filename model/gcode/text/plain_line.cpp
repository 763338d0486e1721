#include "model/gcode/text/plain_line.h"

#include <algorithm>

#include "model/gcode/text/plain_number.h"
#include "model/text/characters.h"

namespace limitgauge::model::gcode {
namespace {

const char* behind_blanks(const char* at, const char* limit) {
  while (at < limit && is_blank(*at)) ++at;
  return at;
}

/// Behind N and its digits and the blanks around them, where these begin the line.
const char* behind_line_number(const char* at, const char* limit) {
  at = behind_blanks(at, limit);
  if (at >= limit || upper(*at) != 'N') return at;
  const char* const digits = ++at;
  while (at < limit && is_digit(*at)) ++at;
  return at == digits ? nullptr : behind_blanks(at, limit);
}

bool is_number(const DigitRun& run) {
  return run.count > 0 && run.is_exact() && !run.more;
}

/// G0 or G1 whose number begins at `at`; null for all else.
const char* read_code(const char* at, const char* limit, PlainLine& line) {
  const DigitRun run = read_digits(at, limit);
  if (!is_number(run) || run.has_point || run.whole > 1 || line.motion) return nullptr;
  line.motion = run.whole == 0 ? 0 : 10;
  return run.end;
}

/// The coordinate whose number begins at `at`; null for all else.
const char* read_axis(const char* at, const char* limit, std::size_t axis, PlainLine& line) {
  const bool negative = at < limit && *at == '-';
  if (negative || (at < limit && *at == '+')) ++at;
  const DigitRun run = read_digits(at, limit);
  if (!is_number(run) || line.states(axis)) return nullptr;
  line.axes[axis] = negative ? -run.value() : run.value();
  line.stated |= 1U << axis;
  line.has_whole_number |= !run.has_point && run.whole != 0;
  line.most_decimals = std::max(line.most_decimals, run.decimals);
  return run.end;
}

}  // namespace

const char* read_plain_line(const char* begin, const char* limit, PlainLine& line) {
  line = {};
  const char* at = behind_line_number(begin, limit);
  while (at != nullptr && at < limit && *at != '\n') {
    const char letter = upper(*at++);
    if (letter >= 'X' && letter <= 'Z') {
      at = read_axis(at, limit, static_cast<std::size_t>(letter - 'X'), line);
    } else if (letter == 'G') {
      at = read_code(at, limit, line);
    } else {
      return nullptr;
    }
    if (at != nullptr) at = behind_blanks(at, limit);
  }
  return line.stated != 0 ? at : nullptr;
}

}  // namespace limitgauge::model::gcode
