#pragma once

#include <cstddef>
#include <string>
#include <string_view>

#include "model/base/error.h"

namespace limitgauge::model {

/// Walks through a one-line specification (`ball:D=6`, `box:90,80,30@-45,-40,-20`) and knows the
/// column of everything it hands out.
class SpecText {
 public:
  /// `what` stands for the file name in errors, as in `tool:1:6: error: ...`.
  SpecText(std::string_view text, std::string what);

  bool at_end() const { return at_ == text_.size(); }
  std::size_t position() const { return at_; }
  /// Takes `c` if it comes next.
  bool take(char c);
  /// Takes everything up to the next of `stops` or the end.
  std::string_view take_until(std::string_view stops);
  /// Takes a finite number that ends at one of `stops` or the end; `what` names it in errors.
  double number(std::string_view stops, const std::string& what);
  /// The same, greater than 0.
  double positive(std::string_view stops, const std::string& what);
  [[noreturn]] void fail_at(std::size_t position, const std::string& wrong,
                            const std::string& expected) const;

 private:
  std::string_view text_;
  std::string what_;
  std::size_t at_ = 0;
};

}  // namespace limitgauge::model
