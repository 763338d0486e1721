#include "reports/html/anchors.h"

#include <fmt/format.h>

namespace limitgauge::reports::html {

std::string stage_anchor(std::size_t stage) {
  return "stage-" + std::to_string(stage + 1);
}

std::string finding_anchor(std::size_t stage, const std::string& finding) {
  return stage_anchor(stage) + "-" + finding;
}

std::string line_anchor(std::size_t stage, std::size_t program_stage, std::uint32_t line) {
  return fmt::format("{}-program-{}-line-{}", stage_anchor(stage), program_stage + 1, line);
}

std::string finding_attributes(std::size_t stage, const std::string& finding) {
  return fmt::format(" id=\"{}\" data-finding=\"{}:{}\"", finding_anchor(stage, finding), stage,
                     finding);
}

std::string finding_link(std::size_t stage, const std::string& finding, const std::string& text) {
  return fmt::format("<a href=\"#{}\" data-finding=\"{}:{}\">{}</a>",
                     finding_anchor(stage, finding), stage, finding, text);
}

}  // namespace limitgauge::reports::html
