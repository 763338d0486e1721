#include "model/gcode/text/lexer.h"

#include <algorithm>
#include <utility>

#include "model/gcode/text/plain_number.h"
#include "model/text/characters.h"
#include "model/text/message_text.h"

namespace limitgauge::model::gcode {
namespace {

constexpr std::string_view kByteOrderMark = "\xEF\xBB\xBF";

/// RS274/NGC has no use for more; a file that is one long line must not fill the memory.
constexpr std::size_t kMostItems = 100;

/// Where the line of a `%` begins that stands before all else.
std::optional<std::size_t> opening_percent(std::string_view text) {
  const std::size_t first = text.find_first_not_of(" \t\r\n");
  if (first == std::string_view::npos || text[first] != '%') return std::nullopt;
  const std::size_t line_end = text.rfind('\n', first);
  return line_end == std::string_view::npos ? 0 : line_end + 1;
}

}  // namespace

Lexer::Lexer(std::string_view text, std::string name, const Parameters& parameters,
             const ControlRules& rules)
    : rules_(rules),
      parameters_(parameters),
      fail_([this](std::size_t at, const std::string& wrong, const std::string& expected) {
        fail(at, wrong, expected);
      }) {
  if (text.starts_with(kByteOrderMark)) text.remove_prefix(kByteOrderMark.size());
  texts_.push_back({std::move(name), text, nullptr, 0, 1,
                    rules.idle_percent ? std::nullopt : opening_percent(text)});
}

Lexer::Bookmark Lexer::add(std::string name, std::string text) {
  const Text& last = texts_.back();
  const auto lines =
      static_cast<std::uint32_t>(std::count(last.text.begin(), last.text.end(), '\n') + 2);
  auto own = std::make_unique<const std::string>(std::move(text));
  std::string_view view = *own;
  if (view.starts_with(kByteOrderMark)) view.remove_prefix(kByteOrderMark.size());
  texts_.push_back({std::move(name), view, std::move(own), last.begin + last.text.size() + 2,
                    last.first_line + lines, opening_percent(view)});
  return {texts_.back().begin, texts_.back().first_line};
}

const Lexer::Text& Lexer::text_at(std::size_t at) const {
  if (texts_.size() == 1) return texts_.front();
  const auto behind =
      std::upper_bound(texts_.begin(), texts_.end(), at,
                       [](std::size_t place, const Text& text) { return place < text.begin; });
  return *(behind - 1);
}

std::size_t Lexer::text_index(Bookmark bookmark) const {
  return static_cast<std::size_t>(&text_at(bookmark.at) - texts_.data());
}

SourcePlace Lexer::place(std::uint32_t line, std::uint32_t column) const {
  const auto behind = std::upper_bound(
      texts_.begin(), texts_.end(), line,
      [](std::uint32_t place, const Text& text) { return place < text.first_line; });
  const Text& text = behind == texts_.begin() ? texts_.front() : *(behind - 1);
  return {text.name, static_cast<int>(line - text.first_line + 1), static_cast<int>(column)};
}

void Lexer::fail_at(std::uint32_t line, std::uint32_t column, const std::string& wrong,
                    const std::string& expected) const {
  throw InputError(place(line, column), wrong, expected);
}

void Lexer::fail(std::size_t at, const std::string& wrong, const std::string& expected) const {
  fail_at(line_, column_of(at), wrong, expected);
}

void Lexer::skip_blanks() {
  while (!at_end() && is_blank(here())) ++cursor_.at;
}

/// False at the end of the text.
bool Lexer::take_line() {
  line_ = next_.line;
  line_at_ = next_.at;
  const Text& text = text_at(next_.at);
  in_text_ = static_cast<std::size_t>(&text - texts_.data());
  const std::size_t at = next_.at - text.begin;
  if (at >= text.text.size()) {
    cursor_ = {};
    return false;
  }
  const std::size_t end = std::min(text.text.find('\n', at), text.text.size());
  cursor_ = {text.text.substr(at, end - at), 0};
  next_ = {text.begin + end + 1, next_.line + 1};
  skip_blanks();
  return true;
}

Lexer::Percent Lexer::percent() const {
  if (at_end() || here() != '%') return Percent::none;
  const Text& text = texts_[in_text_];
  return text.opening_percent == line_at_ - text.begin ? Percent::opening : Percent::closing;
}

void Lexer::check_percent() const {
  const bool opens = percent() == Percent::opening;
  const std::size_t text = cursor_.line.find_first_not_of(" \t\r", cursor_.at + 1);
  if (text != std::string_view::npos && !(opens && rules_.leader))
    fail(text, "text after '%'", "'%' alone on its line");
  const Text& own = texts_[in_text_];
  const std::size_t behind = line_at_ - own.begin + cursor_.line.size();
  const bool is_last = own.text.find_first_not_of(" \t\r\n\x1A%", behind) == std::string_view::npos;
  if (!opens && !(rules_.trailing_percent && is_last) && !own.opening_percent)
    fail(cursor_.at, "'%' ends a program that no '%' began", "'%' on the first line too");
}

bool Lexer::next(Block& block) {
  block.clear();
  const Bookmark before = next_;
  if (!take_line()) {
    if (in_text_ == 0 && begins_with_percent())
      fail(0, "the program that '%' began does not end; it may have been cut off",
           "'%', M2 or M30");
    return false;
  }
  block.line = block.main_line = line_;
  const Percent found = percent();
  if (found != Percent::none && rules_.idle_percent) {
    // Grbl has no use for it, and Siemens's files begin with a line as %_N_PART_MPF.
    set_rest_aside(block);
    return true;
  }
  if (found != Percent::none) check_percent();
  if (found == Percent::closing) next_ = before, ended_by_percent_ = true;
  if (found == Percent::none) read_line(block);
  // Macro B knows blocks that set variables, and others.
  if (rules_.macro_b && !block.settings.empty() && !block.words.empty())
    block.notes.emplace_back("variables that are set beside words are set after these are read");
  return found != Percent::closing;
}

bool Lexer::see_plain(PlainLine& line) {
  const Text& text = text_at(next_.at);
  const std::size_t at = next_.at - text.begin;
  if (at >= text.text.size()) return false;
  const char* const begin = text.text.data() + at;
  const char* const end = read_plain_line(begin, text.text.data() + text.text.size(), line);
  if (end == nullptr) return false;
  const auto bytes = static_cast<std::size_t>(end - begin);
  if (bytes > kMostLineBytes) return false;
  line.line = next_.line;
  behind_plain_ = {next_.at + bytes + 1, next_.line + 1};
  return true;
}

void Lexer::read_line(Block& block) {
  if (cursor_.line.size() > kMostLineBytes)
    fail(kMostLineBytes, "a line of more than 10000 bytes", "a line that ends sooner");
  if (!at_end() && here() == '/') {
    block.block_delete = true;
    ++cursor_.at;
    while (rules_.numbered_skips && !at_end() && is_digit(here())) ++cursor_.at;
    skip_blanks();
  }
  if (!at_end() && upper(here()) == 'N') {
    read_line_number(cursor_.at++);
    skip_blanks();
  }
  if (begins_o_word()) return read_o_word(block);
  if (rules_.program_names && !at_end() && here() == '<') return set_rest_aside(block);
  if (rules_.dollar_lines && !at_end() && here() == '$') return read_dollar(block);
  if (rules_.macro_b && read_macro(block)) return;
  if (rules_.r_parameters) return read_siemens_items(block);
  read_items(block);
}

bool Lexer::begins_o_word() const {
  if (at_end() || rules_.r_parameters) return false;
  return upper(here()) == 'O' || (rules_.colon_numbers && here() == ':');
}

void Lexer::set_rest_aside(Block& block) {
  std::string_view text = cursor_.line.substr(cursor_.at);
  while (is_blank(text.back())) text.remove_suffix(1);
  block.set_aside.emplace_back(text);
  cursor_.at = cursor_.line.size();
}

void Lexer::read_dollar(Block& block) {
  block.dollar = cursor_.line.substr(cursor_.at);
  while (is_blank(block.dollar.back())) block.dollar.remove_suffix(1);
  cursor_.at = cursor_.line.size();
}

void Lexer::read_items(Block& block) {
  for (std::size_t items = 0; !at_end(); skip_blanks()) {
    if (++items > kMostItems + 1)
      fail(cursor_.at, "more than 100 words and comments in one line", "a line that ends sooner");
    const char c = here();
    if (is_letter(c)) {
      read_word(block);
    } else if (c == '(' || c == ';') {
      read_comment(block);
    } else if (c == '#') {
      read_setting(block);
    } else if (rules_.polar_words && (c == '@' || c == '^')) {
      read_word(block);
    } else if (rules_.numbered_skips && c == '/') {
      // What stands behind it is left out where the switch is on.
      block.block_delete = true;
      ++cursor_.at;
      while (!at_end() && is_digit(here())) ++cursor_.at;
    } else {
      fail_at_stray(cursor_.at);
    }
  }
}

void Lexer::read_comment(Block& block) {
  const std::size_t begin = cursor_.at;
  skip_comment();
  std::string_view text = cursor_.line.substr(begin, cursor_.at - begin);
  while (is_blank(text.back())) text.remove_suffix(1);
  block.comments.push_back({column_of(begin), text});
}

void Lexer::skip_comment() {
  const std::size_t begin = cursor_.at++;
  if (cursor_.line[begin] == ';') {
    check_behind_semicolon(begin);
    cursor_.at = cursor_.line.size();
    return;
  }
  while (!at_end() && here() != ')') {
    if (here() == '(') fail(cursor_.at, "a comment inside a comment", "')' first");
    ++cursor_.at;
  }
  if (at_end()) fail(begin, "the comment does not end in its line", "')'");
  ++cursor_.at;
}

void Lexer::read_word(Block& block) {
  const std::size_t begin = cursor_.at++;
  const char letter = upper(cursor_.line[begin]);
  if (letter == 'N') fail(begin, "N after other words", "N at the beginning of the line");
  if (letter == 'O') fail_at_letter_o(begin);
  double value = 0;
  if (!read_plain_value(value)) {
    const std::optional<double> found = read_general_value(begin, block);
    if (!found) {
      block.notes.push_back(in_quotes(cursor_.line.substr(begin, cursor_.at - begin)) +
                            " is left out, as a word of a vacant variable is");
      return;
    }
    value = *found;
  }
  block.words.push_back(
      {letter, value, column_of(begin), cursor_.line.substr(begin, cursor_.at - begin)});
}

/// A number with at most one sign and no blanks inside; false without moving for all else.
bool Lexer::read_plain_value(double& value) {
  const char* const data = cursor_.line.data();
  const char* const limit = data + cursor_.line.size();
  const char* at = data + cursor_.at;
  const bool negative = at < limit && *at == '-';
  if (negative || (at < limit && *at == '+')) ++at;
  const std::optional<PlainNumber> number = read_plain_number(at, limit);
  if (!number) return false;
  at = number->end;
  while (at < limit && is_blank(*at)) ++at;
  if (at < limit && (is_digit(*at) || *at == '.')) return false;
  cursor_.at = static_cast<std::size_t>(number->end - data);
  value = negative ? -number->value : number->value;
  return true;
}

std::optional<double> Lexer::read_general_value(std::size_t word_begin, const Block& block) {
  check_known_word(word_begin);
  if (!value_begins(cursor_))
    fail(word_begin,
         "the number of " + in_quotes(cursor_.line[word_begin]) + " is missing or malformed",
         "a number, a parameter, a function or an expression in brackets");
  if (!rules_.rounds_calculated) return read_value_or_vacant(cursor_, parameters_, fail_, rules_);
  constexpr int kUnits = 4006;
  const bool in_inches = inches_stated(block).value_or(parameters_.numbered(kUnits) == 20);
  return read_value_or_vacant(cursor_, parameters_, fail_, rules_,
                              steps_in_unit(upper(cursor_.line[word_begin]), in_inches));
}

void Lexer::read_setting(Block& block) {
  const std::size_t begin = cursor_.at++;
  if (!rules_.expressions) fail(begin, std::string(rules_.title) + " has no parameters", "numbers");
  Setting setting{{}, 0, column_of(begin)};
  setting.parameter = read_parameter_name(cursor_, parameters_, fail_, rules_);
  const ParameterName& name = setting.parameter;
  if (name.name.empty() ? !Parameters::is_settable(name.number)
                        : !Parameters::is_settable(name.name))
    fail(begin,
         "parameter " + in_quotes(cursor_.line.substr(begin, cursor_.at - begin)) +
             " belongs to the machine",
         "a code that sets it, as G10, or another parameter");
  if (rules_.macro_b && name.number >= Parameters::kFirstMacroSystem && name.number != 3000 &&
      name.number != 3006)
    fail(begin, "variable #" + std::to_string(name.number) + " belongs to the control",
         "G10 for offsets, or variables below #1000");
  skip_blanks();
  if (at_end() || here() != '=')
    fail(cursor_.at, "a parameter at the beginning of a word", "'=' and a value");
  ++cursor_.at;
  setting.value = read_setting_value(cursor_, parameters_, fail_, rules_);
  block.settings.push_back(std::move(setting));
}

/// LinuxCNC takes decimals too.
void Lexer::read_line_number(std::size_t word_begin) {
  skip_blanks();
  if (at_end() || !is_digit(here()))
    fail(word_begin, "the number of 'N' is missing or malformed", "digits");
  double value = 0;
  if (!read_plain_value(value)) read_value(cursor_, parameters_, fail_);
}

}  // namespace limitgauge::model::gcode
