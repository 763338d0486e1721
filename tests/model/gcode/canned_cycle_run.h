#pragma once

#include <string>

#include "model/gcode/cycles/canned_cycle.h"
#include "model/gcode/text/lexer.h"
#include "model/gcode/text/parameters.h"
#include "model/gcode/text/statement.h"
#include "model/text/number_text.h"

namespace limitgauge::model::test {

/// Carries out blocks of canned cycles one after the other. The blocks have no G words: what those
/// would say stands in `context`.
class CycleRun {
 public:
  gcode::CycleContext context;

  gcode::CycleMotions block(int code, const std::string& words) {
    const gcode::Parameters parameters;
    gcode::Lexer lexer(words, "cycle.ngc", parameters);
    gcode::Block block;
    lexer.next(block);
    context.code = 10 * code;
    const gcode::CycleMotions motions = cycles_.moves(gcode::Statement(block, lexer), context);
    context.position_mm = motions.end_mm;
    return motions;
  }
  /// As block(), as text: `rapid X Y Z` or `feed X Y Z` for each, `stopped` where the spindle is.
  std::string text(int code, const std::string& words) { return text_of(block(code, words).moves); }
  /// Another motion took the tool elsewhere.
  void go_to(const Vec3& position_mm) {
    cycles_.forget();
    context.position_mm = position_mm;
  }

  static std::string text_of(const std::vector<gcode::CycleMove>& moves) {
    std::string text;
    for (const gcode::CycleMove& move : moves) {
      text += move.kind == MotionKind::rapid ? "rapid" : "feed";
      for (int axis = 0; axis < 3; ++axis) text += " " + shortest(move.to_mm[axis]);
      text += move.spindle_stopped ? " stopped\n" : "\n";
    }
    return text;
  }

 private:
  gcode::CannedCycles cycles_;
};

}  // namespace limitgauge::model::test
