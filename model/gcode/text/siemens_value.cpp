#include "model/gcode/text/siemens_value.h"

#include <array>
#include <cmath>
#include <stdexcept>

#include "model/gcode/text/functions.h"
#include "model/gcode/text/plain_number.h"
#include "model/text/characters.h"
#include "model/text/message_text.h"

namespace limitgauge::model::gcode {
namespace {

constexpr int kMostSiemensDepth = 50;

class SiemensValueReader {
 public:
  SiemensValueReader(Cursor& cursor, const Parameters& parameters, const Fail& fail,
                     std::vector<int>& read)
      : cursor_(cursor), parameters_(parameters), fail_(fail), read_(read) {}
  double sum();

 private:
  double product();
  double value();
  double number();
  double r_parameter();
  double function();
  double function_of(const std::string& name, std::size_t begin, double argument);
  double bracketed();
  double checked(const Computed& computed, std::size_t at) const;
  [[noreturn]] void fail(std::size_t at, const std::string& wrong,
                         const std::string& expected) const;
  char peek();
  bool take_word(std::string_view word);

  Cursor& cursor_;
  const Parameters& parameters_;
  const Fail& fail_;
  std::vector<int>& read_;
  int depth_ = 0;
};

void SiemensValueReader::fail(std::size_t at, const std::string& wrong,
                              const std::string& expected) const {
  fail_(at, wrong, expected);
  throw std::logic_error("the reader of values was given a Fail that returns");
}

double SiemensValueReader::checked(const Computed& computed, std::size_t at) const {
  if (!computed.wrong.empty())
    fail(at, std::string(computed.wrong), std::string(computed.expected));
  return computed.value;
}

char SiemensValueReader::peek() {
  while (cursor_.at < cursor_.line.size() && is_blank(cursor_.line[cursor_.at])) ++cursor_.at;
  return cursor_.at < cursor_.line.size() ? upper(cursor_.line[cursor_.at]) : '\0';
}

bool SiemensValueReader::take_word(std::string_view word) {
  peek();
  if (cursor_.line.size() - cursor_.at < word.size()) return false;
  for (std::size_t i = 0; i < word.size(); ++i)
    if (upper(cursor_.line[cursor_.at + i]) != word[i]) return false;
  cursor_.at += word.size();
  return true;
}

double SiemensValueReader::sum() {
  double left = product();
  for (char c = peek(); c == '+' || c == '-'; c = peek()) {
    const std::size_t at = cursor_.at++;
    const double right = product();
    left = checked(finite(c == '+' ? left + right : left - right), at);
  }
  return left;
}

double SiemensValueReader::product() {
  double left = value();
  while (true) {
    const char c = peek();
    const std::size_t at = cursor_.at;
    const bool whole = take_word("DIV"), rest = !whole && take_word("MOD");
    if (!whole && !rest && c != '*' && c != '/') return left;
    if (!whole && !rest) ++cursor_.at;
    const double right = value();
    if (c == '*') {
      left = checked(finite(left * right), at);
      continue;
    }
    if (right == 0) fail(at, "a division by zero", "another divisor");
    const double quotient = left / right;
    left = checked(finite(rest    ? std::fmod(left, right)
                          : whole ? std::trunc(quotient)
                                  : quotient),
                   at);
  }
}

double SiemensValueReader::value() {
  const char c = peek();
  if (++depth_ > kMostSiemensDepth)
    fail(cursor_.at, "more than 50 values within each other", "a simpler expression");
  double result = 0;
  if (c == '+' || c == '-') {
    ++cursor_.at;
    result = c == '-' ? -value() : value();
  } else if (c == '(') {
    result = bracketed();
  } else if (is_digit(c) || c == '.') {
    result = number();
  } else if (c == 'R' && cursor_.at + 1 < cursor_.line.size() &&
             is_digit(cursor_.line[cursor_.at + 1])) {
    result = r_parameter();
  } else if (is_letter(c)) {
    result = function();
  } else {
    fail(cursor_.at, "a value is missing", "a number, an R parameter or parentheses");
  }
  --depth_;
  return result;
}

double SiemensValueReader::number() {
  const char* const begin = cursor_.line.data() + cursor_.at;
  const auto found = read_plain_number(begin, cursor_.line.data() + cursor_.line.size());
  if (!found) fail(cursor_.at, "this is not a number", "digits and one decimal point");
  cursor_.at = static_cast<std::size_t>(found->end - cursor_.line.data());
  return found->value;
}

double SiemensValueReader::r_parameter() {
  const std::size_t begin = cursor_.at++;
  const int number = read_r_number(cursor_, fail_);
  const auto found = parameters_.numbered(kFirstRParameter + number);
  if (!found)
    fail(begin, "parameter R" + std::to_string(number) + " was never set",
         "a setting before it is read");
  read_.push_back(number);
  return *found;
}

double SiemensValueReader::bracketed() {
  const std::size_t begin = cursor_.at++;
  const double result = sum();
  if (peek() != ')') fail(begin, "'(' is not closed in its line", "')'");
  ++cursor_.at;
  return result;
}

double SiemensValueReader::function() {
  const std::size_t begin = cursor_.at;
  std::string name;
  while (cursor_.at < cursor_.line.size() && is_letter(cursor_.line[cursor_.at]))
    name += lower(cursor_.line[cursor_.at++]);
  if (peek() != '(')
    fail(begin, in_quotes(name) + " is no value", "a number, an R parameter or a function");
  return function_of(name, begin, bracketed());
}

double SiemensValueReader::function_of(const std::string& name, std::size_t begin,
                                       double argument) {
  if (name == "pot") return checked(finite(argument * argument), begin);
  if (name == "trunc") return std::trunc(argument);
  constexpr std::array<std::string_view, 8> kShared = {"sin",  "cos",  "tan", "asin",
                                                       "acos", "sqrt", "abs", "round"};
  for (const std::string_view known : kShared)
    if (known == name) return checked(apply(*function_named(name), argument), begin);
  const bool mode = name == "ic" || name == "ac" || name == "dc" || name == "acp" || name == "acn";
  fail(begin,
       in_quotes(name) + (mode ? " states one word in another distance mode: it is not carried out"
                               : " is no function that is carried out"),
       mode ? "G90 or G91" : "SIN, COS, TAN, ASIN, ACOS, SQRT, ABS, POT, TRUNC or ROUND");
}

}  // namespace

double read_siemens_value(Cursor& cursor, const Parameters& parameters, const Fail& fail,
                          std::vector<int>& read) {
  return SiemensValueReader(cursor, parameters, fail, read).sum();
}

int read_r_number(Cursor& cursor, const Fail& fail) {
  const std::size_t begin = cursor.at;
  int number = 0;
  for (; cursor.at < cursor.line.size() && is_digit(cursor.line[cursor.at]); ++cursor.at) {
    number = number * 10 + (cursor.line[cursor.at] - '0');
    if (number >= kRParameters) fail(begin, "an R parameter beyond R999", "R0 to R999");
  }
  if (cursor.at == begin) fail(begin, "R without its number", "R0 to R999");
  return number;
}

}  // namespace limitgauge::model::gcode
