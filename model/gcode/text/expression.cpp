#include "model/gcode/text/expression.h"

#include <cmath>
#include <stdexcept>
#include <string>

#include "model/base/tolerance.h"
#include "model/gcode/text/functions.h"
#include "model/gcode/text/operators.h"
#include "model/gcode/text/plain_number.h"
#include "model/text/characters.h"
#include "model/text/message_text.h"
#include "model/text/number_text.h"

namespace limitgauge::model::gcode {
namespace {

/// Brackets, signs, `#`. LinuxCNC's lines are shorter than 256 bytes.
constexpr int kMostDepth = 100;
/// No name of an operator or function is longer.
constexpr std::size_t kLongestWord = 6;
constexpr int kLoosest = 1;

/// Reads values by recursive descent, at most 100 within each other.
class ValueReader {
 public:
  ValueReader(Cursor& cursor, const Parameters& parameters, const Fail& fail,
              const ControlRules& rules, double steps = 0)
      : cursor_(cursor), parameters_(parameters), fail_(fail), rules_(rules), steps_(steps) {}

  double value();
  /// Values joined by operators, without brackets around them.
  double calculation() { return chain(kLoosest); }
  /// Whether the value read last is a vacant variable and nothing else.
  bool vacant() const { return vacant_; }
  int whole_value();
  ParameterName parameter_name();

 private:
  double signed_value();
  [[noreturn]] double missing() const;
  double bracketed();
  double chain(int loosest);
  double number();
  double spaced_number();
  double parameter();
  double function();
  double arc_tangent(double y);
  double exists();
  double joined(const OperatorText& found, double left, std::size_t at);
  void check_order(const OperatorText& found, const OperatorText* other, std::size_t at) const;
  double macro_joined(const OperatorText& found, double left, double right, std::size_t at);
  void take(char c);
  char peek();
  std::string word_ahead() const;
  void skip_word(std::size_t letters);
  double checked(const Computed& computed, std::size_t at) const;
  [[noreturn]] void fail(std::size_t at, const std::string& wrong,
                         const std::string& expected) const;

  Cursor& cursor_;
  const Parameters& parameters_;
  const Fail& fail_;
  const ControlRules& rules_;
  double steps_;  // in a unit, that ROUND rounds to; 0: to whole numbers
  int depth_ = 0;
  bool vacant_ = false;
};

}  // namespace

void ValueReader::fail(std::size_t at, const std::string& wrong,
                       const std::string& expected) const {
  fail_(at, wrong, expected);
  throw std::logic_error("the reader of values was given a Fail that returns");
}

double ValueReader::checked(const Computed& computed, std::size_t at) const {
  if (!computed.wrong.empty())
    fail(at, std::string(computed.wrong), std::string(computed.expected));
  return computed.value;
}

/// The next character that is no blank, in lower case; 0 at the end of the line.
char ValueReader::peek() {
  while (cursor_.at < cursor_.line.size() && is_blank(cursor_.line[cursor_.at])) ++cursor_.at;
  return cursor_.at < cursor_.line.size() ? lower(cursor_.line[cursor_.at]) : '\0';
}

void ValueReader::take(char c) {
  const char found = peek();
  if (found != c)
    fail(cursor_.at,
         found == '\0' ? "the line ends within a value" : in_quotes(found) + " within a value",
         in_quotes(c));
  ++cursor_.at;
}

/// The next characters without blanks, in lower case; enough to know a name by.
std::string ValueReader::word_ahead() const {
  std::string word;
  for (std::size_t at = cursor_.at; at < cursor_.line.size() && word.size() <= kLongestWord; ++at) {
    const char c = cursor_.line[at];
    if (!is_blank(c)) word += lower(c);
  }
  return word;
}

void ValueReader::skip_word(std::size_t letters) {
  for (; letters > 0; --letters) {
    peek();
    ++cursor_.at;
  }
}

double ValueReader::value() {
  const char c = peek();
  vacant_ = false;
  if (!rules_.expressions && (c == '[' || c == '#' || is_letter(c)))
    fail(cursor_.at, std::string(rules_.title) + " has no parameters and expressions", "a number");
  if (++depth_ > kMostDepth)
    fail(cursor_.at, "more than 100 values within each other", "a simpler expression");
  const double result = c == '+' || c == '-'      ? signed_value()
                        : c == '['                ? bracketed()
                        : c == '#'                ? parameter()
                        : is_letter(c)            ? function()
                        : is_digit(c) || c == '.' ? number()
                                                  : missing();
  --depth_;
  return result;
}

double ValueReader::signed_value() {
  const bool negative = cursor_.line[cursor_.at++] == '-';
  if (const char c = peek(); !rules_.expressions && (c == '+' || c == '-')) missing();
  return negative ? -value() : value();
}

double ValueReader::missing() const {
  const bool ends = cursor_.at >= cursor_.line.size();
  fail(cursor_.at,
       ends ? "the line ends where a value is missing"
            : in_quotes(cursor_.line[cursor_.at]) + " where a value is missing",
       "a number, a parameter, a function or an expression in brackets");
}

double ValueReader::bracketed() {
  const std::size_t begin = cursor_.at;
  take('[');
  const double result = chain(kLoosest);
  const char c = peek();
  if (c == '\0') fail(begin, "'[' is not closed in its line", "']'");
  if (c != ']') fail(cursor_.at, in_quotes(c) + " behind a value", "an operator or ']'");
  ++cursor_.at;
  return result;
}

/// Values joined by operators that bind as closely as `loosest` or closer.
double ValueReader::chain(int loosest) {
  double left = value();
  const OperatorText* before = nullptr;
  while (true) {
    if (peek() == ']') return left;
    const std::size_t at = cursor_.at;
    const OperatorText* const found = operator_at(word_ahead());
    if (found == nullptr || found->precedence < loosest) return left;
    skip_word(found->text.size());
    if (before != nullptr) check_order(*found, before, at);
    left = joined(*found, left, at);
    before = found;
  }
}

double ValueReader::joined(const OperatorText& found, double left, std::size_t at) {
  const bool left_is_vacant = vacant_;
  const bool logical = rules_.macro_b && found.precedence == 1;
  const double right = logical ? value() : chain(found.precedence + 1);
  const bool any_vacant = left_is_vacant || vacant_, both_vacant = left_is_vacant && vacant_;
  vacant_ = false;
  if (any_vacant && found.operation == Operator::equal) return both_vacant ? 1 : 0;
  if (any_vacant && found.operation == Operator::not_equal) return both_vacant ? 0 : 1;
  if (rules_.macro_b) return macro_joined(found, left, right, at);
  return checked(apply(found.operation, left, right), at);
}

/// LinuxCNC's logical operators bind otherwise than Fanuc's: what would come out differently needs
/// brackets.
void ValueReader::check_order(const OperatorText& found, const OperatorText* other,
                              std::size_t at) const {
  if (!rules_.macro_b || other == nullptr || other->operation == found.operation) return;
  const bool mixed = found.precedence == 1 || other->precedence == 1;
  if (mixed || (found.precedence == 2 && other->precedence == 2))
    fail(at, in_quotes(found.text) + " beside " + in_quotes(other->text) + " in one bracket",
         "brackets around each of them");
}

double ValueReader::macro_joined(const OperatorText& found, double left, double right,
                                 std::size_t at) {
  const auto whole_bits = [&](double operand) {
    if (std::abs(operand - std::round(operand)) > kWholeCount || std::abs(operand) > 1e9)
      fail(at, in_quotes(found.text) + " of " + shortest(operand), "whole numbers");
    return static_cast<long long>(std::llround(operand));
  };
  const OperatorText* const next = peek() == ']' ? nullptr : operator_at(word_ahead());
  const bool logical = found.precedence == 1;
  if (logical) check_order(found, next, at);
  if (found.operation == Operator::modulo && right != 0) return std::fmod(left, right);
  if (found.operation == Operator::power) fail(at, "'**' is no operator of macro B", "brackets");
  if (!logical) return checked(apply(found.operation, left, right), at);
  const long long a = whole_bits(left), b = whole_bits(right);
  const long long bits = found.operation == Operator::logical_and  ? a & b
                         : found.operation == Operator::logical_or ? a | b
                                                                   : a ^ b;
  return static_cast<double>(bits);
}

double ValueReader::number() {
  const char* const begin = cursor_.line.data() + cursor_.at;
  const char* const limit = cursor_.line.data() + cursor_.line.size();
  const std::optional<PlainNumber> found = read_plain_number(begin, limit);
  if (!found) return spaced_number();
  const std::size_t begin_at = cursor_.at;
  const auto end_at = static_cast<std::size_t>(found->end - cursor_.line.data());
  cursor_.at = end_at;
  const char next = peek();
  const bool goes_on = is_digit(next) || next == '.';
  cursor_.at = goes_on ? begin_at : end_at;
  return goes_on ? spaced_number() : found->value;
}

/// A number with blanks between its numerals, or what only looks like a number.
double ValueReader::spaced_number() {
  const std::size_t begin = cursor_.at;
  std::size_t end = begin;
  std::string gathered;
  for (char c = peek(); is_digit(c) || c == '.'; c = peek()) {
    gathered += c;
    end = ++cursor_.at;
  }
  cursor_.at = end;
  const char* const limit = gathered.data() + gathered.size();
  const std::optional<PlainNumber> found = read_plain_number(gathered.data(), limit);
  if (found && found->end == limit) return found->value;
  const bool well_formed = gathered != "." && gathered.find('.') == gathered.rfind('.');
  if (well_formed) fail(begin, in_quotes(gathered) + " is too large or too small", "fewer digits");
  fail(begin, in_quotes(gathered) + " is not a number", "digits and one decimal point");
}

int ValueReader::whole_value() {
  peek();
  const std::size_t begin = cursor_.at;
  const double found = value();
  const double below = std::floor(found), rest = found - below;
  if (rest > kWholeCount && rest <= 1 - kWholeCount)
    fail(begin, shortest(found) + " where a whole number is needed", "a whole number");
  const double whole = rest > 1 - kWholeCount ? below + 1 : below;
  constexpr double kLargest = 1e9;
  if (std::abs(whole) > kLargest)
    fail(begin, shortest(found) + " where a whole number is needed", "at most 1e9");
  return static_cast<int>(whole);
}

ParameterName ValueReader::parameter_name() {
  if (peek() == '<') return {0, read_name(cursor_, fail_)};
  const std::size_t begin = cursor_.at;
  const int number = whole_value();
  if (number == 0 && rules_.macro_b) return {};
  if (number < 1 || number > Parameters::kLargest)
    fail(begin, "parameter number " + std::to_string(number), "1 to 5999");
  return {number, {}};
}

double ValueReader::parameter() {
  const std::size_t begin = cursor_.at;
  take('#');
  const ParameterName name = parameter_name();
  const std::optional<double> found =
      name.name.empty() ? parameters_.numbered(name.number) : parameters_.named(name.name);
  if (!found && rules_.macro_b && name.name.empty() &&
      name.number <= Parameters::kLargestMacroLocal) {
    vacant_ = true;
    return 0;
  }
  const bool is_system = rules_.macro_b && name.number >= Parameters::kFirstMacroSystem;
  if (!found && is_system)
    fail(begin, "what #" + std::to_string(name.number) + " is here on the control nothing states",
         "a program without it");
  if (!found)
    fail(begin,
         "parameter " +
             (name.name.empty() ? "#" + std::to_string(name.number)
                                : in_quotes("#<" + name.name + ">")) +
             " was never set",
         "a setting before it is read");
  return *found;
}

double ValueReader::function() {
  const std::size_t begin = cursor_.at;
  std::string name;
  for (char c = peek(); is_letter(c) && name.size() <= kLongestWord; c = peek()) {
    name += c;
    ++cursor_.at;
  }
  const std::optional<Function> found = function_named(name);
  if (!found)
    fail(begin, in_quotes(name) + " is no function",
         "ABS, ACOS, ASIN, ATAN, COS, EXISTS, EXP, FIX, FUP, LN, ROUND, SIN, SQRT or TAN");
  if (peek() != '[') fail(cursor_.at, "a function without its argument", "'['");
  if (*found == Function::exists) return exists();
  const double argument = bracketed();
  vacant_ = false;
  if (*found == Function::atan) return arc_tangent(argument);
  if (rules_.macro_b) return checked(apply_macro(*found, argument, steps_), begin);
  return checked(apply(*found, argument), begin);
}

double ValueReader::arc_tangent(double y) {
  if (peek() != '/') fail(cursor_.at, "ATAN with one argument", "ATAN[y]/[x]");
  ++cursor_.at;
  if (peek() != '[') fail(cursor_.at, "ATAN without its second argument", "ATAN[y]/[x]");
  // Parameter 6004#0 chooses between -180 to 180 degrees and 0 to 360.
  if (rules_.macro_b && y < 0)
    fail(cursor_.at,
         "ATAN of a negative value is an angle above 180 degrees or below 0, as the "
         "control is set",
         "ATAN of 0 or more, its sign turned afterwards");
  return arc_tangent_deg(y, bracketed());
}

/// As LinuxCNC, a number names a parameter whether it was set or not.
double ValueReader::exists() {
  take('[');
  take('#');
  const ParameterName name = parameter_name();
  take(']');
  return name.name.empty() || parameters_.named(name.name) ? 1 : 0;
}

bool value_begins(Cursor cursor) {
  const auto next = [&cursor] {
    while (cursor.at < cursor.line.size() && is_blank(cursor.line[cursor.at])) ++cursor.at;
    return cursor.at < cursor.line.size() ? cursor.line[cursor.at++] : '\0';
  };
  const char c = next();
  if (is_letter(c)) return is_letter(next());
  return is_digit(c) || c == '.' || c == '+' || c == '-' || c == '#' || c == '[';
}

double read_value(Cursor& cursor, const Parameters& parameters, const Fail& fail,
                  const ControlRules& rules) {
  return ValueReader(cursor, parameters, fail, rules).value();
}

std::optional<double> read_value_or_vacant(Cursor& cursor, const Parameters& parameters,
                                           const Fail& fail, const ControlRules& rules,
                                           double steps) {
  ValueReader reader(cursor, parameters, fail, rules, steps);
  const double value = reader.value();
  return reader.vacant() ? std::nullopt : std::optional(value);
}

std::optional<double> read_setting_value(Cursor& cursor, const Parameters& parameters,
                                         const Fail& fail, const ControlRules& rules) {
  ValueReader reader(cursor, parameters, fail, rules);
  const double value = rules.macro_b ? reader.calculation() : reader.value();
  return reader.vacant() ? std::nullopt : std::optional(value);
}

int read_whole_value(Cursor& cursor, const Parameters& parameters, const Fail& fail,
                     const ControlRules& rules) {
  return ValueReader(cursor, parameters, fail, rules).whole_value();
}

ParameterName read_parameter_name(Cursor& cursor, const Parameters& parameters, const Fail& fail,
                                  const ControlRules& rules) {
  return ValueReader(cursor, parameters, fail, rules).parameter_name();
}

std::string read_name(Cursor& cursor, const Fail& fail) {
  const std::size_t begin = cursor.at++;
  std::string name;
  for (; cursor.at < cursor.line.size() && cursor.line[cursor.at] != '>'; ++cursor.at) {
    const char c = cursor.line[cursor.at];
    if (c == '(' || c == ';' || c == '<') fail(cursor.at, in_quotes(c) + " within a name", "'>'");
    if (!is_blank(c)) name += lower(c);
  }
  if (cursor.at >= cursor.line.size()) fail(begin, "the name does not end in its line", "'>'");
  if (name.empty()) fail(begin, "a name without a letter", "'<', a name and '>'");
  ++cursor.at;
  return name;
}

}  // namespace limitgauge::model::gcode
