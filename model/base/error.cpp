#include "model/base/error.h"

namespace limitgauge::model {
namespace {

std::string message(const SourcePlace& place, const std::string& wrong,
                    const std::string& expected) {
  std::string text = place.file;
  if (place.line > 0) text.append(":").append(std::to_string(place.line));
  if (place.line > 0 && place.column > 0) text.append(":").append(std::to_string(place.column));
  text += (text.empty() ? "error: " : ": error: ") + wrong;
  if (!expected.empty()) text += "; expected " + expected;
  return text;
}

}  // namespace

InputError::InputError(SourcePlace place, const std::string& wrong, const std::string& expected)
    : std::runtime_error(message(place, wrong, expected)), place_(std::move(place)) {}

}  // namespace limitgauge::model
