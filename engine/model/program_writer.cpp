#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <optional>
#include <stdexcept>
#include <string_view>

#include "engine/model/error.h"
#include "engine/model/program.h"
#include "engine/model/words.h"

namespace limitgauge::model {
namespace {

constexpr int kMostDecimals = 9;
constexpr int kSpindleDecimals = 3;
constexpr std::size_t kBlockBytes = 1 << 16;
/// As the reader's limit; the fixed notation of such a number fits the buffer.
constexpr double kLargestCoordinateMm = 1e9;

/// A number in fixed decimals without trailing zeros, and what a reader will make of it.
struct FixedNumber {
  std::array<char, 32> digits{};
  std::size_t length = 0;
  double value = 0;

  std::string_view text() const { return {digits.data(), length}; }
};

FixedNumber fixed(double value, int decimals) {
  FixedNumber number;
  const auto [end, error] =
      std::to_chars(number.digits.data(), number.digits.data() + number.digits.size(), value,
                    std::chars_format::fixed, decimals);
  number.length = end - number.digits.data();
  if (decimals > 0) {
    number.length = number.text().find_last_not_of('0') + 1;
    if (number.text().back() == '.') --number.length;
  }
  if (number.text() == "-0") number.digits[0] = '0', number.length = 1;
  std::from_chars(number.digits.data(), number.digits.data() + number.length, number.value);
  return number;
}

/// Builds the text in blocks and counts its lines.
class ProgramText {
 public:
  explicit ProgramText(std::ostream& out) : out_(out) {}

  void line(std::string_view words) {
    text_.append(words);
    end_line();
  }
  /// One word, with a blank between it and the word before.
  void word(char letter, std::string_view number) {
    if (text_.size() > line_begin_) text_.push_back(' ');
    text_.push_back(letter);
    text_.append(number);
  }
  void end_line() {
    text_.push_back('\n');
    ++line_;
    if (text_.size() >= kBlockBytes) flush();
    line_begin_ = text_.size();
  }
  void flush() {
    out_.write(text_.data(), static_cast<std::streamsize>(text_.size()));
    text_.clear();
    if (!out_) throw ResourceError("the program cannot be written; is the disk full?");
  }
  std::uint32_t line_number() const { return line_; }

 private:
  std::ostream& out_;
  std::string text_;
  std::size_t line_begin_ = 0;
  std::uint32_t line_ = 1;
};

std::array<FixedNumber, 3> rounded(const Vec3& point, int decimals) {
  return {fixed(point.x, decimals), fixed(point.y, decimals), fixed(point.z, decimals)};
}

Vec3 values(const std::array<FixedNumber, 3>& point) {
  return {point[0].value, point[1].value, point[2].value};
}

/// Parentheses and line ends would end a comment, and not every controller reads more than ASCII.
std::string comment_line(std::string_view text) {
  std::string line = "(";
  for (const char c : text) {
    const bool printable = c >= ' ' && c <= '~';
    line += c == '(' ? '[' : c == ')' ? ']' : printable ? c : ' ';
  }
  return line + ")";
}

/// A feed rate that reads back as the same float. Shortest digits of the float first; they could
/// round twice on their way through a double.
std::string feed_text(float feed_mm_min) {
  std::array<char, 64> digits{};
  const auto shortest_end = std::to_chars(digits.data(), digits.data() + digits.size(), feed_mm_min,
                                          std::chars_format::fixed);
  const std::string_view text(digits.data(), shortest_end.ptr - digits.data());
  const std::optional<double> read = parse_number(text);
  if (read && static_cast<float>(*read) == feed_mm_min) return std::string(text);
  const auto end = std::to_chars(digits.data(), digits.data() + digits.size(),
                                 static_cast<double>(feed_mm_min), std::chars_format::fixed);
  return std::string(digits.data(), end.ptr);
}

void require_point(const Vec3& point) {
  for (const int axis : {0, 1, 2}) {
    if (!(std::abs(point[axis]) <= kLargestCoordinateMm))
      throw std::invalid_argument("a toolpath point is not finite or beyond any machine");
  }
}

void require_feed(const Move& move) {
  constexpr float kSlowest = 1e-6F, kFastest = 1e9F;
  if (move.kind == MoveKind::feed &&
      !(move.feed_mm_min >= kSlowest && move.feed_mm_min <= kFastest))
    throw std::invalid_argument("a feed move's feed rate must lie between 1e-6 and 1e9 mm/min");
}

void write_header(const WriterOptions& options, ProgramText& text) {
  if (!options.program_name.empty()) text.line(comment_line(options.program_name));
  for (std::string_view rest = options.comment; !rest.empty();) {
    const std::size_t end = std::min(rest.find('\n'), rest.size());
    text.line(comment_line(rest.substr(0, end)));
    rest.remove_prefix(std::min(end + 1, rest.size()));
  }
  text.line("G21 G90 G94 G17 G40 G49");
  text.word('T', std::to_string(options.tool_number));
  text.line(" M6");
  if (options.spindle_rpm > 0) {
    text.word('M', "3");
    text.word('S', fixed(options.spindle_rpm, kSpindleDecimals).text());
    text.end_line();
  }
}

/// The tool goes to its height first, then over the place.
void write_start(const Toolpath& path, int decimals, ProgramText& text) {
  const std::array<FixedNumber, 3> to = rounded(path.start, decimals);
  text.word('G', "0");
  text.word('Z', to[2].text());
  text.end_line();
  text.word('X', to[0].text());
  text.word('Y', to[1].text());
  text.end_line();
}

/// What the controller holds from earlier lines.
struct ModalState {
  Vec3 at;
  MoveKind kind = MoveKind::rapid;
  float feed_mm_min = 0;
};

void write_axes(const std::array<FixedNumber, 3>& to, const ModalState& state, ProgramText& text) {
  constexpr std::array<char, 3> kAxes = {'X', 'Y', 'Z'};
  bool written = false;
  for (int axis = 0; axis < 3; ++axis) {
    if (to[axis].value == state.at[axis]) continue;
    text.word(kAxes[axis], to[axis].text());
    written = true;
  }
  // A move of no length must still be a line with a motion on it.
  if (!written) text.word(kAxes[0], to[0].text());
}

void write_move(Move& move, ModalState& state, int decimals, ProgramText& text) {
  const std::array<FixedNumber, 3> to = rounded(move.to, decimals);
  if (move.kind != state.kind) text.word('G', move.kind == MoveKind::rapid ? "0" : "1");
  state.kind = move.kind;
  write_axes(to, state, text);
  if (move.kind == MoveKind::rapid) move.feed_mm_min = 0;
  if (move.kind == MoveKind::feed && move.feed_mm_min != state.feed_mm_min) {
    text.word('F', feed_text(move.feed_mm_min));
    state.feed_mm_min = move.feed_mm_min;
  }
  move.to = state.at = values(to);
  move.set_line(text.line_number());
  text.end_line();
}

void require_writable(const Toolpath& path, const WriterOptions& options) {
  if (options.decimals < 0 || options.decimals > kMostDecimals)
    throw std::invalid_argument("a program is written with 0 to 9 decimals");
  if (options.tool_number < 0) throw std::invalid_argument("tool number must not be negative");
  if (!(options.spindle_rpm >= 0 && options.spindle_rpm <= 1e9))
    throw std::invalid_argument("spindle speed must lie between 0 and 1e9");
  require_point(path.start);
  for (const Move& move : path.moves) require_point(move.to), require_feed(move);
}

}  // namespace

void write_program(Toolpath& path, const WriterOptions& options, std::ostream& out) {
  require_writable(path, options);
  ProgramText text(out);
  write_header(options, text);
  write_start(path, options.decimals, text);
  path.start = values(rounded(path.start, options.decimals));
  ModalState state{path.start};
  for (Move& move : path.moves) write_move(move, state, options.decimals, text);
  text.line("M5");
  text.line("M30");
  text.flush();
}

}  // namespace limitgauge::model
