#include "reports/run/program_lines.h"

#include <algorithm>
#include <limits>

#include "reports/text/text.h"

namespace limitgauge::reports {
namespace {

constexpr std::size_t kLongestLine = 160;

/// Ascending ranges [first, last] of lines that do not touch.
std::vector<std::pair<std::uint32_t, std::uint32_t>> ranges_of(
    std::span<const std::uint32_t> wanted, std::uint32_t around) {
  constexpr std::uint32_t kMost = std::numeric_limits<std::uint32_t>::max();
  std::vector<std::uint32_t> lines(wanted.begin(), wanted.end());
  std::sort(lines.begin(), lines.end());
  std::vector<std::pair<std::uint32_t, std::uint32_t>> ranges;
  for (const std::uint32_t line : lines) {
    if (line == 0) continue;
    const std::uint32_t first = line > around ? line - around : 1;
    const std::uint32_t last = line > kMost - around ? kMost : line + around;
    if (!ranges.empty() && first <= ranges.back().second) {
      ranges.back().second = std::max(ranges.back().second, last);
    } else {
      ranges.emplace_back(first, last);
    }
  }
  return ranges;
}

ProgramLine shown(std::uint32_t line, std::string_view text) {
  if (text.ends_with('\r')) text.remove_suffix(1);
  // Four bytes make a character at most: nothing that is shown is lost by cutting first.
  return {line, shortened(clean_text(text.substr(0, 4 * kLongestLine)), kLongestLine)};
}

void add_findings(const std::vector<verifier::Finding>& findings, char letter, std::size_t most,
                  std::vector<NamedLine>& named) {
  for (std::size_t i = 0; i < std::min(findings.size(), most); ++i)
    if (findings[i].line > 0)
      named.push_back({letter + std::to_string(i + 1), findings[i].stage, findings[i].line});
}

/// Of a figure over tolerances: the line that made its worst place.
void add_tolerated(const verifier::RobustFigure& figure, const char* name,
                   std::vector<NamedLine>& named) {
  if (figure.place && figure.line > 0) named.push_back({name, figure.stage, figure.line});
}

/// Faults first, each by depth.
bool worse(const simulator::FindingGroup& a, const simulator::FindingGroup& b) {
  if (fails(a.kind) != fails(b.kind)) return fails(a.kind);
  return a.worst.depth_mm > b.worst.depth_mm;
}

}  // namespace

std::vector<ProgramLine> program_lines(std::string_view program,
                                       std::span<const std::uint32_t> wanted,
                                       std::uint32_t around) {
  std::vector<ProgramLine> lines;
  std::uint32_t line = 1;
  std::size_t at = 0;
  for (const auto& [first, last] : ranges_of(wanted, around)) {
    for (; line <= last && at < program.size(); ++line) {
      const std::size_t end = std::min(program.find('\n', at), program.size());
      if (line >= first) lines.push_back(shown(line, program.substr(at, end - at)));
      at = end + 1;
    }
  }
  return lines;
}

std::vector<simulator::FindingGroup> worst_first(std::span<const simulator::Finding> findings) {
  std::vector<simulator::FindingGroup> groups = simulator::group_findings(findings);
  std::stable_sort(groups.begin(), groups.end(), worse);
  return groups;
}

std::vector<NamedLine> named_lines(const RunResult& result, std::size_t index, std::size_t most) {
  std::vector<NamedLine> named;
  if (!result.stages[index].ran) return named;
  const StageRun& ran = *result.stages[index].ran;
  if (ran.deviation) {
    if (const auto& robust = ran.deviation->robust) {
      add_tolerated(robust->gouge, "GT", named);
      add_tolerated(robust->uncut, "UT", named);
    }
    add_findings(ran.deviation->gouges, 'G', most, named);
    add_findings(ran.deviation->uncuts, 'U', most, named);
  }
  const std::vector<simulator::FindingGroup> groups = worst_first(ran.process);
  for (std::size_t i = 0; i < std::min(groups.size(), most); ++i)
    if (groups[i].worst.line > 0)
      named.push_back({"P" + std::to_string(i + 1), index, groups[i].worst.line});
  return named;
}

}  // namespace limitgauge::reports
