#include "model/text/spec_text.h"

#include <algorithm>
#include <optional>
#include <utility>

#include "model/text/message_text.h"
#include "model/text/number_text.h"

namespace limitgauge::model {

SpecText::SpecText(std::string_view text, std::string what) : text_(text), what_(std::move(what)) {}

bool SpecText::take(char c) {
  if (at_end() || text_[at_] != c) return false;
  ++at_;
  return true;
}

std::string_view SpecText::take_until(std::string_view stops) {
  const std::size_t begin = at_;
  at_ = std::min(text_.find_first_of(stops, at_), text_.size());
  return text_.substr(begin, at_ - begin);
}

double SpecText::number(std::string_view stops, const std::string& what) {
  const std::size_t begin = at_;
  const std::string_view text = take_until(stops);
  const std::optional<double> value = parse_number(text);
  if (!value)
    fail_at(begin, what + " " + in_quotes(text) + " is not a number",
            "a number of millimetres or degrees");
  return *value;
}

double SpecText::positive(std::string_view stops, const std::string& what) {
  const std::size_t begin = at_;
  const double value = number(stops, what);
  if (value <= 0) fail_at(begin, what + " is " + shortest(value), "more than 0");
  return value;
}

void SpecText::fail_at(std::size_t position, const std::string& wrong,
                       const std::string& expected) const {
  throw InputError({what_, 1, static_cast<int>(position) + 1}, wrong, expected);
}

}  // namespace limitgauge::model
