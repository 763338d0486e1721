#include "reports/html/program_part.h"

#include <fmt/format.h>

#include <map>

#include "reports/program_lines.h"
#include "reports/text.h"

namespace limitgauge::reports::html {
namespace {

constexpr std::size_t kFindingsShown = 20;
constexpr std::uint32_t kLinesAround = 3;

/// The names of the findings by the line that they name, of one stage's program.
using Marks = std::map<std::uint32_t, std::string>;

std::string row(const ProgramLine& line, const Marks& marks) {
  const auto mark = marks.find(line.line);
  const bool marked = mark != marks.end();
  return fmt::format("<tr{}><td>{}</td><th scope=\"row\">{}</th><td><code>{}</code></td></tr>\n",
                     marked ? " class=\"named\"" : "", marked ? mark->second : "", line.line,
                     escape_markup(line.text));
}

std::string listing(const StageResult& stage, const Marks& marks) {
  std::vector<std::uint32_t> wanted;
  for (const auto& [line, names] : marks) wanted.push_back(line);
  std::string rows;
  std::uint32_t before = 0;
  for (const ProgramLine& line : program_lines(*stage.ran->program_text, wanted, kLinesAround)) {
    if (before > 0 && line.line > before + 1)
      rows += "<tr class=\"gap\"><td></td><th>⋮</th><td></td></tr>\n";
    rows += row(line, marks);
    before = line.line;
  }
  if (rows.empty()) return {};
  const std::string source = stage.program.empty() ? stage.name + "/toolpath.ngc" : stage.program;
  return fmt::format(
      "<table class=\"program\"><caption>Program lines of the findings: {}</caption>\n{}</table>\n",
      escape_markup(source), rows);
}

}  // namespace

std::string program_part(const RunResult& result, std::size_t index) {
  std::map<std::size_t, Marks> by_stage;
  for (const NamedLine& named : named_lines(result, index, kFindingsShown)) {
    std::string& names = by_stage[named.stage][named.line];
    names += (names.empty() ? "" : ", ") + named.name;
  }
  std::string out;
  for (const auto& [stage, marks] : by_stage) {
    if (stage >= result.stages.size()) continue;
    const StageResult& cut = result.stages[stage];
    if (cut.ran && cut.ran->program_text) out += listing(cut, marks);
  }
  return out;
}

}  // namespace limitgauge::reports::html
