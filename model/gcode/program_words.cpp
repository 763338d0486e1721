#include "model/gcode/program_words.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

#include "model/base/tolerance.h"
#include "model/text/fixed_number.h"

namespace limitgauge::model {
namespace {

constexpr int kSpindleDecimals = 3;
/// RS274/NGC's and Fanuc's; Grbl takes more.
constexpr int kLastLineNumber = 99999;
constexpr int kMostToolNumber = 9999;

/// Largest size of a number that the dialect takes with so many decimals.
double largest_number(const DialectRules& rule, int decimals) {
  return std::min(kLargestCoordinateMm, std::pow(10.0, rule.most_digits - decimals) - 1);
}

void require_point(const Vec3& point, double largest_mm) {
  for (const int axis : {0, 1, 2}) {
    if (!(std::abs(point[axis]) <= largest_mm))
      throw std::invalid_argument("a toolpath point is not finite or beyond any machine");
  }
}

void require_feed(const Move& move, const DialectRules& rule) {
  const double slowest =
      rule.feed_decimals ? std::pow(10.0, -*rule.feed_decimals) : kLeastFeed_mm_min;
  const double fastest =
      rule.feed_decimals ? largest_number(rule, *rule.feed_decimals) : kLargestFeed_mm_min;
  if (move.kind == MoveKind::feed && !(move.feed_mm_min >= static_cast<float>(slowest) &&
                                       move.feed_mm_min <= static_cast<float>(fastest)))
    throw std::invalid_argument("a feed move's feed rate is 0, or beyond what the dialect takes");
}

void require_options(const WriterOptions& options, const DialectRules& rule) {
  if (options.decimals < 0 || options.decimals > rule.most_decimals)
    throw std::invalid_argument("a program is written with 0 to " +
                                std::to_string(rule.most_decimals) + " decimals");
  if (options.tool_number < 0 || options.tool_number > kMostToolNumber)
    throw std::invalid_argument("tool number must lie between 0 and 9999");
  if (!(options.spindle_rpm >= 0 && options.spindle_rpm <= 1e9))
    throw std::invalid_argument("spindle speed must lie between 0 and 1e9");
  if (options.arc_tolerance_mm &&
      !(*options.arc_tolerance_mm > 0 && std::isfinite(*options.arc_tolerance_mm)))
    throw std::invalid_argument("the tolerance of arcs must be greater than 0");
}

}  // namespace

void require_writable(const Toolpath& path, const WriterOptions& options) {
  const DialectRules& rule = rules(options.dialect);
  require_options(options, rule);
  const double largest_mm = largest_number(rule, options.decimals);
  require_point(path.start, largest_mm);
  for (const Move& move : path.moves) require_point(move.to, largest_mm), require_feed(move, rule);
}

void ProgramWords::begin_word() {
  if (!text_.at_line_begin()) return text_.append(" ");
  if (!line_numbers_) return;
  number_ = number_ % kLastLineNumber + 1;
  text_.append("N" + std::to_string(number_) + " ");
}

void ProgramWords::feed(float feed_mm_min, const DialectRules& rule) {
  if (!rule.feed_decimals) return word('F', feed_text(feed_mm_min));
  word('F', fixed(feed_mm_min, *rule.feed_decimals, rule.point_always).text());
}

void ProgramWords::write_head(const WriterOptions& options) {
  const DialectRules& rule = rules(options.dialect);
  if (rule.percents) {
    plain_line("%");
    const std::string digits = std::to_string(std::max(1, options.tool_number));
    plain_line("O" + std::string(4 - digits.size(), '0') + digits);
  }
  for (const std::string& text : {options.program_name, options.comment}) {
    for (const std::string& line : comment_lines(options.dialect, text)) plain_line(line);
  }
  for (std::string_view rest = rule.modes; !rest.empty();) {
    const std::size_t end = rest.find('\n');
    line(rest.substr(0, end));
    rest.remove_prefix(end + 1);
  }
  if (options.arc_tolerance_mm && rule.arc_mode) line("G91.1");
  write_spindle(options);
}

void ProgramWords::write_spindle(const WriterOptions& options) {
  const DialectRules& rule = rules(options.dialect);
  if (rule.tool_change) {
    word('T', std::to_string(options.tool_number));
    line("M6");
  }
  if (options.spindle_rpm == 0) return;
  const int decimals = rule.feed_decimals ? 0 : kSpindleDecimals;
  word('M', "3");
  word('S', fixed(options.spindle_rpm, decimals).text());
  end_line();
}

void ProgramWords::write_end(const DialectRules& rule) {
  line("M5");
  line("M30");
  if (rule.percents) plain_line("%");
  text_.flush();
}

}  // namespace limitgauge::model
