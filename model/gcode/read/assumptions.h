#pragma once

#include <cstdint>
#include <set>
#include <string>
#include <vector>

namespace limitgauge::model::gcode {

/// What the reader takes for granted, each once, with the line that needed it first.
class Assumptions {
 public:
  explicit Assumptions(std::vector<std::string>& out) : out_(out) {}

  void add(std::uint32_t line, const std::string& text);

 private:
  static constexpr std::size_t kMost = 1000;
  std::vector<std::string>& out_;
  std::set<std::string> seen_;
};

}  // namespace limitgauge::model::gcode
