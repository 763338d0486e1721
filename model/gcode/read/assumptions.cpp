#include "model/gcode/read/assumptions.h"

namespace limitgauge::model::gcode {

void Assumptions::add(std::uint32_t line, const std::string& text) {
  if (seen_.size() >= kMost || !seen_.insert(text).second) return;
  out_.push_back("line " + std::to_string(line) + ": " + text);
}

}  // namespace limitgauge::model::gcode
