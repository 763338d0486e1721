#include "reports/html/stage/stage_parts.h"

#include <fmt/format.h>

#include <map>

#include "reports/html/markup.h"
#include "reports/run/finding_list.h"
#include "reports/run/program_lines.h"
#include "reports/text/text.h"

namespace limitgauge::reports::html {
namespace {

constexpr std::size_t kFindingsShown = 20;
constexpr std::uint32_t kLinesAround = 3;
/// Longer listings are folded away; a link to a line unfolds them.
constexpr std::size_t kMostOpenLines = 60;

/// The names of the findings by the line that they name, of one stage's program.
using Marks = std::map<std::uint32_t, std::string>;

/// Whose listing it is, and whose program.
struct Listed {
  std::size_t stage = 0, program = 0;
};

std::string row(const Listed& where, const ProgramLine& line, const Marks& marks) {
  const auto mark = marks.find(line.line);
  const bool marked = mark != marks.end();
  return fmt::format(
      "<tr id=\"{}\" data-program=\"{}\" data-line=\"{}\"{}><td>{}</td><th scope=\"row\">{}</th>"
      "<td><code>{}</code></td></tr>\n",
      line_anchor(where.stage, where.program, line.line), where.program, line.line,
      marked ? " class=\"named\"" : "", marked ? mark->second : "", line.line,
      escape_markup(line.text));
}

std::string listing(const StageResult& stage, const Listed& where, const Marks& marks) {
  std::vector<std::uint32_t> wanted;
  for (const auto& [line, names] : marks) wanted.push_back(line);
  const std::vector<ProgramLine> lines =
      program_lines(*stage.ran->program_text, wanted, kLinesAround);
  if (lines.empty()) return {};
  std::string rows;
  std::uint32_t before = 0;
  for (const ProgramLine& line : lines) {
    if (before > 0 && line.line > before + 1)
      rows += "<tr class=\"gap\"><td></td><th scope=\"row\">⋮</th><td></td></tr>\n";
    rows += row(where, line, marks);
    before = line.line;
  }
  return fmt::format(
      "<details class=\"listing\"{}><summary>Program lines of the findings</summary>\n"
      "<table class=\"program\"><caption>{}</caption>\n{}</table></details>\n",
      lines.size() <= kMostOpenLines ? " open=\"\"" : "", escape_markup(program_file(stage)), rows);
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
    if (cut.ran && cut.ran->program_text) out += listing(cut, {index, stage}, marks);
  }
  return out;
}

}  // namespace limitgauge::reports::html
