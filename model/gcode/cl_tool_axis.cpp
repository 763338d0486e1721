#include "model/gcode/cl_tool_axis.h"

#include <cmath>

#include "model/text/message_text.h"
#include "model/text/number_text.h"

namespace limitgauge::model {
namespace {

constexpr Vec3 kUpright{0, 0, 1};
/// What post-processors that write three decimals make of a unit vector, and no more.
constexpr double kUnitRounding = 1e-3;

}  // namespace

void ClToolAxis::set_mode(const ClStatement& statement, const ClLexer& lexer) {
  if (statement.figures.size() > 1)
    lexer.fail(statement.figures[1], "MULTAX with several words", "ON or OFF");
  const std::string mode = statement.figures.empty() ? "ON" : statement.figures[0].text;
  if (mode != "ON" && mode != "OFF")
    lexer.fail(statement.figures[0], "MULTAX with " + in_quotes(mode), "ON or OFF");
  fixed_ = mode == "OFF";
}

Vec3 ClToolAxis::stated(const ClStatement& statement, const std::vector<double>& figures,
                        const ClLexer& lexer) {
  if (figures.size() == 3) {
    if (kept_line_ == 0 && !(axis_ == kUpright)) kept_line_ = statement.major.line;
    return axis_;
  }
  const Vec3 axis{figures[3], figures[4], figures[5]};
  const double size = length(axis);
  if (!(std::abs(size - 1) <= kUnitRounding))
    lexer.fail(statement.figures[3],
               size == 0 ? "a tool axis of length 0" : "a tool axis of length " + six_digits(size),
               "a unit vector, within 0.001");
  return axis / size;
}

Vec3 ClToolAxis::start_at(const ClStatement& statement, const std::vector<double>& figures,
                          const ClLexer& lexer) {
  placed_ = true;
  return axis_ = stated(statement, figures, lexer);
}

Vec3 ClToolAxis::go_to(const ClStatement& statement, const std::vector<double>& figures,
                       const ClLexer& lexer) {
  const Vec3 to = stated(statement, figures, lexer);
  if (fixed_ && placed_ && !(to == axis_))
    lexer.fail(statement.figures[3], "a turn of the tool behind MULTAX/OFF", "MULTAX/ON before it");
  if (placed_ && !(dot(axis_, to) >= 0))
    lexer.fail(statement.figures[3], "a motion that turns the tool by more than 90 degrees",
               "motions of smaller turns: it leaves open which way the tool goes round");
  placed_ = true;
  return axis_ = to;
}

}  // namespace limitgauge::model
