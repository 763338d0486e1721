#include <array>
#include <cmath>
#include <optional>
#include <stdexcept>
#include <string_view>

#include "model/base/tolerance.h"
#include "model/gcode/arc_fit.h"
#include "model/gcode/program.h"
#include "model/text/fixed_number.h"
#include "model/text/text_blocks.h"

namespace limitgauge::model {
namespace {

constexpr int kSpindleDecimals = 3;
constexpr int kMostToolNumber = 9999;
/// RS274/NGC's and Fanuc's; Grbl takes more.
constexpr int kLastLineNumber = 99999;
constexpr std::array<char, 3> kAxes = {'X', 'Y', 'Z'};
constexpr std::array<char, 3> kCentres = {'I', 'J', 'K'};

/// Words with blanks between them; N words where they are asked for.
class ProgramText {
 public:
  ProgramText(std::ostream& out, bool line_numbers) : text_(out), line_numbers_(line_numbers) {}

  void word(char letter, std::string_view number) {
    begin_word();
    text_.append({&letter, 1});
    text_.append(number);
  }
  void words(std::string_view words) {
    begin_word();
    text_.append(words);
  }
  void end_line() { text_.end_line(); }
  /// A comment, `%` or a program's number.
  void plain_line(std::string_view line) { text_.line(line); }
  void flush() { text_.flush(); }
  std::uint32_t line_number() const { return text_.line_number(); }

 private:
  void begin_word() {
    if (!text_.at_line_begin()) return text_.append(" ");
    if (!line_numbers_) return;
    number_ = number_ % kLastLineNumber + 1;
    text_.append("N" + std::to_string(number_) + " ");
  }

  TextBlocks text_;
  bool line_numbers_;
  int number_ = 0;
};

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

void require_writable(const Toolpath& path, const WriterOptions& options) {
  const DialectRules& rule = rules(options.dialect);
  require_options(options, rule);
  const double largest_mm = largest_number(rule, options.decimals);
  require_point(path.start, largest_mm);
  for (const Move& move : path.moves) require_point(move.to, largest_mm), require_feed(move, rule);
}

/// What the controller holds from earlier lines.
struct ModalState {
  Vec3 at;
  int motion = 0;
  ArcPlane plane = ArcPlane::xy;
  float feed_mm_min = 0;
};

class Writer {
 public:
  Writer(Toolpath& path, const WriterOptions& options, std::ostream& out)
      : path_(path),
        options_(options),
        rule_(rules(options.dialect)),
        text_(out, options.line_numbers) {}

  void write();

 private:
  FixedNumber number(double value) const {
    return fixed(value, options_.decimals, rule_.point_always);
  }
  void write_header();
  void write_comments();
  void write_spindle();
  void write_start();
  void write_moves_and_arcs();
  void write_move(Move& move);
  void write_arc(const FittedArc& arc, std::size_t first);
  void write_axes(const std::array<FixedNumber, 3>& to);
  void write_motion(int motion);
  void write_feed(float feed_mm_min);
  float rounded_feed(float feed_mm_min) const;
  void round_path();
  void write_footer();

  Toolpath& path_;
  const WriterOptions& options_;
  const DialectRules& rule_;
  ProgramText text_;
  ModalState state_;
};

void Writer::write() {
  write_header();
  write_start();
  if (options_.arc_tolerance_mm) {
    write_moves_and_arcs();
  } else {
    for (Move& move : path_.moves) write_move(move);
  }
  write_footer();
}

void Writer::write_header() {
  if (rule_.percents) {
    text_.plain_line("%");
    const std::string digits = std::to_string(std::max(1, options_.tool_number));
    text_.plain_line("O" + std::string(4 - digits.size(), '0') + digits);
  }
  write_comments();
  for (std::string_view rest = rule_.modes; !rest.empty();) {
    const std::size_t end = rest.find('\n');
    text_.words(rest.substr(0, end));
    text_.end_line();
    rest.remove_prefix(end + 1);
  }
  if (options_.arc_tolerance_mm && rule_.arc_mode) text_.words("G91.1"), text_.end_line();
  write_spindle();
}

void Writer::write_comments() {
  for (const std::string& text : {options_.program_name, options_.comment}) {
    for (const std::string& line : comment_lines(options_.dialect, text)) text_.plain_line(line);
  }
}

void Writer::write_spindle() {
  if (rule_.tool_change) {
    text_.word('T', std::to_string(options_.tool_number));
    text_.words("M6");
    text_.end_line();
  }
  if (options_.spindle_rpm == 0) return;
  const int decimals = rule_.feed_decimals ? 0 : kSpindleDecimals;
  text_.word('M', "3");
  text_.word('S', fixed(options_.spindle_rpm, decimals).text());
  text_.end_line();
}

/// The tool goes to its height first, then over the place.
void Writer::write_start() {
  path_.start = rounded(path_.start, options_.decimals);
  text_.word('G', "0");
  text_.word('Z', number(path_.start.z).text());
  text_.end_line();
  text_.word('X', number(path_.start.x).text());
  text_.word('Y', number(path_.start.y).text());
  text_.end_line();
  state_.at = path_.start;
}

void Writer::write_footer() {
  text_.words("M5");
  text_.end_line();
  text_.words("M30");
  text_.end_line();
  if (rule_.percents) text_.plain_line("%");
  text_.flush();
}

/// Arcs go through the points as they are written.
void Writer::round_path() {
  for (Move& move : path_.moves) {
    move.to = rounded(move.to, options_.decimals);
    if (move.kind == MoveKind::feed) move.feed_mm_min = rounded_feed(move.feed_mm_min);
  }
}

void Writer::write_moves_and_arcs() {
  round_path();
  ArcFitter fitter(path_, *options_.arc_tolerance_mm, options_.decimals);
  for (std::size_t i = 0; i < path_.moves.size();) {
    if (const std::optional<FittedArc> arc = fitter.from(i)) {
      write_arc(*arc, i);
      i += arc->moves;
    } else {
      write_move(path_.moves[i++]);
    }
  }
}

void Writer::write_move(Move& move) {
  const std::array<FixedNumber, 3> to = {number(move.to.x), number(move.to.y), number(move.to.z)};
  const bool rapid = move.kind == MoveKind::rapid;
  write_motion(rapid ? 0 : 1);
  write_axes(to);
  move.feed_mm_min = rapid ? 0 : rounded_feed(move.feed_mm_min);
  if (!rapid) write_feed(move.feed_mm_min);
  move.to = state_.at = {to[0].value, to[1].value, to[2].value};
  move.set_line(text_.line_number());
  text_.end_line();
}

void Writer::write_arc(const FittedArc& arc, std::size_t first) {
  const auto [one, two, normal] = axes_of(arc.plane);
  const Move& last = path_.moves[first + arc.moves - 1];
  if (arc.plane != state_.plane) text_.word('G', std::to_string(static_cast<int>(arc.plane)));
  state_.plane = arc.plane;
  write_motion(arc.counter_clockwise ? 3 : 2);
  text_.word(kAxes[one], number(last.to[one]).text());
  text_.word(kAxes[two], number(last.to[two]).text());
  text_.word(kCentres[one], number(arc.offset.x).text());
  text_.word(kCentres[two], number(arc.offset.y).text());
  write_feed(last.feed_mm_min);
  state_.at = last.to;
  for (std::size_t i = first; i < first + arc.moves; ++i)
    path_.moves[i].set_line(text_.line_number());
  text_.end_line();
}

void Writer::write_motion(int motion) {
  if (motion != state_.motion) text_.word('G', std::to_string(motion));
  state_.motion = motion;
}

void Writer::write_axes(const std::array<FixedNumber, 3>& to) {
  bool written = false;
  for (int axis = 0; axis < 3; ++axis) {
    if (to[axis].value == state_.at[axis]) continue;
    text_.word(kAxes[axis], to[axis].text());
    written = true;
  }
  // A move of no length must still be a line with a motion on it.
  if (!written) text_.word(kAxes[0], to[0].text());
}

float Writer::rounded_feed(float feed_mm_min) const {
  if (!rule_.feed_decimals) return feed_mm_min;
  return static_cast<float>(fixed(feed_mm_min, *rule_.feed_decimals).value);
}

void Writer::write_feed(float feed_mm_min) {
  if (feed_mm_min == state_.feed_mm_min) return;
  state_.feed_mm_min = feed_mm_min;
  if (!rule_.feed_decimals) return text_.word('F', feed_text(feed_mm_min));
  text_.word('F', fixed(feed_mm_min, *rule_.feed_decimals, rule_.point_always).text());
}

}  // namespace

void write_program(Toolpath& path, const WriterOptions& options, std::ostream& out) {
  require_writable(path, options);
  Writer(path, options, out).write();
}

}  // namespace limitgauge::model
