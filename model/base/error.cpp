#include "model/base/error.h"

#include "model/text/clean_text.h"

namespace limitgauge::model {
namespace {

std::string message(const SourcePlace& place, const std::string& wrong,
                    const std::string& expected) {
  std::string text = one_line(place.file);
  if (place.line > 0) text.append(":").append(std::to_string(place.line));
  if (place.line > 0 && place.column > 0) text.append(":").append(std::to_string(place.column));
  text += (text.empty() ? "error: " : ": error: ") + one_line(wrong);
  if (!expected.empty()) text += "; expected " + one_line(expected);
  return text;
}

}  // namespace

InputError::InputError(SourcePlace place, const std::string& wrong, const std::string& expected)
    : std::runtime_error(message(place, wrong, expected)),
      place_(std::move(place)),
      wrong_(wrong),
      expected_(expected) {}

InputError InputError::with(const std::string& more) const {
  if (expected_.empty()) return {place_, wrong_ + "; " + more};
  return {place_, wrong_, expected_ + "; " + more};
}

ResourceError::ResourceError(const std::string& what) : std::runtime_error(clean_text(what)) {}

}  // namespace limitgauge::model
