#pragma once

#include <string>

#include "model/gcode/text/expression.h"
#include "model/gcode/text/operators.h"

namespace limitgauge::model::gcode {

/// Reads values by recursive descent, at most 100 within each other; expression.h tells how they
/// are written.
class ValueReader {
 public:
  ValueReader(Cursor& cursor, const Parameters& parameters, const Fail& fail)
      : cursor_(cursor), parameters_(parameters), fail_(fail) {}

  double value();
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
  int depth_ = 0;
};

}  // namespace limitgauge::model::gcode
