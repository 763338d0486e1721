#include "model/gcode/text/expression.h"

#include "model/gcode/text/characters.h"
#include "model/gcode/text/value_reader.h"

namespace limitgauge::model::gcode {

bool value_begins(Cursor cursor) {
  const auto next = [&cursor] {
    while (cursor.at < cursor.line.size() && is_blank(cursor.line[cursor.at])) ++cursor.at;
    return cursor.at < cursor.line.size() ? cursor.line[cursor.at++] : '\0';
  };
  const char c = next();
  if (is_letter(c)) return is_letter(next());
  return is_digit(c) || c == '.' || c == '+' || c == '-' || c == '#' || c == '[';
}

double read_value(Cursor& cursor, const Parameters& parameters, const Fail& fail) {
  return ValueReader(cursor, parameters, fail).value();
}

int read_whole_value(Cursor& cursor, const Parameters& parameters, const Fail& fail) {
  return ValueReader(cursor, parameters, fail).whole_value();
}

ParameterName read_parameter_name(Cursor& cursor, const Parameters& parameters, const Fail& fail) {
  return ValueReader(cursor, parameters, fail).parameter_name();
}

std::string read_name(Cursor& cursor, const Fail& fail) {
  const std::size_t begin = cursor.at++;
  std::string name;
  for (; cursor.at < cursor.line.size() && cursor.line[cursor.at] != '>'; ++cursor.at) {
    const char c = cursor.line[cursor.at];
    if (c == '(' || c == ';' || c == '<') fail(cursor.at, shown(c) + " within a name", "'>'");
    if (!is_blank(c)) name += lower(c);
  }
  if (cursor.at >= cursor.line.size()) fail(begin, "the name does not end in its line", "'>'");
  if (name.empty()) fail(begin, "a name without a letter", "'<', a name and '>'");
  ++cursor.at;
  return name;
}

}  // namespace limitgauge::model::gcode
