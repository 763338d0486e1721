#include "app/job/program_parts.h"

#include <algorithm>
#include <filesystem>
#include <optional>
#include <system_error>

#include "model/base/error.h"

namespace limitgauge::app {
namespace {

using model::Program;
using model::ToolChange;

struct Start {
  std::size_t motion = 0;
  std::uint32_t line = 0;
};

[[noreturn]] void fail(const std::string& file, std::uint32_t line, const std::string& wrong,
                       const std::string& expected) {
  throw model::InputError({file, static_cast<int>(line), 0}, wrong, expected);
}

std::string tool_word(int number) {
  return "T" + std::to_string(number);
}

Start start_of_tool(const std::vector<ToolChange>& changes, const std::string& file,
                    const JobStage& stage) {
  const int tool = *stage.part.tool;
  std::optional<Start> found;
  for (const ToolChange& change : changes) {
    if (change.tool != tool) continue;
    if (found)
      fail(file, change.line,
           "stage \"" + stage.name + "\" takes " + tool_word(tool) +
               ", which is loaded a second time here",
           "\"program_section\": the how-manieth loading of a tool it takes");
    found = {change.motion, change.line};
  }
  if (!found)
    fail(file, 0,
         "stage \"" + stage.name + "\" takes " + tool_word(tool) + ", which is never loaded",
         "the number of a tool that the program loads");
  return *found;
}

Start start_of_section(const std::vector<ToolChange>& changes, const std::string& file,
                       const JobStage& stage) {
  const int section = *stage.part.section;
  if (section < 1 || static_cast<std::size_t>(section) > changes.size())
    fail(file, 0,
         "stage \"" + stage.name + "\" takes section " + std::to_string(section) + " of " +
             std::to_string(changes.size()),
         "the how-manieth loading of a tool, from 1");
  const ToolChange& change = changes[static_cast<std::size_t>(section) - 1];
  return {change.motion, change.line};
}

Start start_of_comment(const Program& program, const std::string& file, const JobStage& stage) {
  std::optional<Start> found;
  for (const model::ProgramComment& comment : program.comments) {
    if (comment.text != stage.part.comment) continue;
    if (found)
      fail(file, comment.line,
           "stage \"" + stage.name + "\" begins at the comment \"" + stage.part.comment +
               "\", which stands here a second time",
           "a comment that stands once on a line of its own");
    found = {comment.motion, comment.line};
  }
  if (!found)
    fail(file, 0,
         "stage \"" + stage.name + "\" begins at the comment \"" + stage.part.comment +
             "\", which is nowhere",
         "the text of a comment that has a line of its own");
  return *found;
}

Start start_of(const Program& program, const std::vector<ToolChange>& changes,
               const std::string& file, const JobStage& stage) {
  if (stage.part.tool) return start_of_tool(changes, file, stage);
  if (stage.part.section) return start_of_section(changes, file, stage);
  if (!stage.part.comment.empty()) return start_of_comment(program, file, stage);
  return {};
}

/// The line of the first of the motions [first, last) that is no rapid.
std::optional<std::uint32_t> first_fed(const Program& program, std::size_t first,
                                       std::size_t last) {
  for (std::size_t i = first; i < last; ++i)
    if (program.motions[i].kind != model::MotionKind::rapid) return program.motions[i].line;
  return std::nullopt;
}

/// What is fed while no tool is in the spindle, or one that nothing names, is no stage's cut.
void require_tools(const Program& program, const std::vector<ToolChange>& loaded,
                   const std::string& file) {
  const std::vector<ToolChange>& changes = program.tool_changes;
  for (std::size_t k = 0; k < changes.size(); ++k) {
    if (changes[k].tool != 0) continue;
    const bool is_last = k + 1 == changes.size();
    const std::size_t end = is_last ? program.motions.size() : changes[k + 1].motion;
    if (const auto line = first_fed(program, changes[k].motion, end))
      fail(file, *line,
           "a feed with no tool in the spindle, out of which T0 took it in line " +
               std::to_string(changes[k].line),
           "a tool that is loaded before");
  }
  if (loaded.empty()) return;
  if (const auto line = first_fed(program, 0, loaded.front().motion))
    fail(file, *line,
         "a feed before the first tool is loaded, " + tool_word(loaded.front().tool) + " in line " +
             std::to_string(loaded.front().line),
         "a tool that is loaded before");
}

/// One tool cuts in a part, and where tools have numbers it is the stage's.
void check_tools(const std::vector<ToolChange>& changes, const std::string& file,
                 const JobStage& stage, const MotionRange& range) {
  std::optional<int> loaded;
  for (const ToolChange& change : changes) {
    if (change.motion >= range.last) break;
    if (change.motion <= range.first) loaded = change.tool;
    const bool within = change.motion >= range.first;
    if (within && loaded && *loaded != change.tool)
      fail(
          file, change.line,
          tool_word(change.tool) + " is loaded in the part that stage \"" + stage.name +
              "\" takes, after " + tool_word(*loaded),
          "a stage for each tool, by \"program_tool\" or \"program_section\"; with verify or cut a "
          "--tool N=... for each");
    if (within) loaded = change.tool;
    if (within && stage.tool_number && *stage.tool_number != change.tool)
      fail(file, change.line,
           tool_word(change.tool) + " is loaded where stage \"" + stage.name + "\" has \"" +
               stage.cutter.id + "\", " + tool_word(*stage.tool_number),
           "the tool whose number the program says");
  }
}

}  // namespace

bool same_program(const JobStage& a, const JobStage& b) {
  const auto file = [](const JobStage& stage) {
    std::error_code failed;
    const auto plain = std::filesystem::weakly_canonical(stage.program, failed);
    return failed ? stage.program : plain;
  };
  return a.program == b.program || (!a.plan && !b.plan && file(a) == file(b));
}

std::vector<ToolChange> loadings(const Program& program) {
  std::vector<ToolChange> all;
  for (const ToolChange& change : program.tool_changes)
    if (change.tool != 0) {
      if (!all.empty() && all.back().motion == change.motion) all.pop_back();
      if (all.empty() || all.back().tool != change.tool) all.push_back(change);
    }
  // Posts load the first tool again at the end, for the next part.
  if (all.size() > 1 && all.back().motion == program.motions.size()) all.pop_back();
  return all;
}

std::vector<MotionRange> assign_parts(const Program& program, const std::string& file,
                                      std::span<const JobStage* const> stages) {
  const std::vector<ToolChange> changes = loadings(program);
  require_tools(program, changes, file);
  std::vector<MotionRange> ranges;
  if (stages.size() > 1) {
    for (const JobStage* stage : stages)
      if (stage->part.whole())
        fail(file, 0, "stage \"" + stage->name + "\" takes the whole program, other stages a part",
             "\"program_tool\", \"program_section\" or \"program_comment\" in each of them");
  }
  for (const JobStage* stage : stages) {
    const Start start = start_of(program, changes, file, *stage);
    if (!ranges.empty() && start.motion <= ranges.back().first)
      fail(file, start.line,
           "stage \"" + stage->name + "\" begins before the stage before it has moved",
           "stages in the program's order");
    if (!ranges.empty()) ranges.back().last = start.motion;
    ranges.push_back({ranges.empty() ? 0 : start.motion, program.motions.size()});
  }
  for (std::size_t i = 0; i < stages.size(); ++i) check_tools(changes, file, *stages[i], ranges[i]);
  return ranges;
}

}  // namespace limitgauge::app
