#include "app/job/program_parts.h"

#include "model/base/error.h"
#include "tests/support/catch.h"
#include "tests/support/messages.h"

namespace limitgauge::app {
namespace {

/// Twelve motions: T1 from the first, T2 from motion 4, T1 again from motion 8; comments before
/// motions 0, 6 and 8.
model::Program three_loadings() {
  model::Program program;
  program.motions.resize(12);
  program.tool_changes = {{2, 0, 1}, {20, 4, 2}, {40, 8, 1}};
  program.comments = {{1, 0, "ROUGH"}, {30, 6, "FINISH"}, {39, 8, "AGAIN"}, {41, 9, "AGAIN"}};
  return program;
}

JobStage stage_with(const std::string& name, const ProgramPart& part,
                    std::optional<int> tool = {}) {
  JobStage stage;
  stage.name = name;
  stage.part = part;
  stage.tool_number = tool;
  return stage;
}

std::vector<MotionRange> assigned(const model::Program& program,
                                  const std::vector<JobStage>& stages) {
  std::vector<const JobStage*> pointers;
  for (const JobStage& stage : stages) pointers.push_back(&stage);
  return assign_parts(program, "all.ngc", pointers);
}

std::string error_of(const model::Program& program, const std::vector<JobStage>& stages) {
  return tests::message_of<model::InputError>([&] { assigned(program, stages); });
}

ProgramPart section(int number) {
  return {{}, number, ""};
}
ProgramPart tool(int number) {
  return {number, {}, ""};
}
ProgramPart comment(const std::string& text) {
  return {{}, {}, text};
}

}  // namespace

TEST_CASE("parts of a program by the loadings of its tools", "[unit][program]") {
  const auto ranges =
      assigned(three_loadings(), {stage_with("a", section(1), 1), stage_with("b", section(2), 2),
                                  stage_with("c", section(3), 1)});
  REQUIRE(ranges.size() == 3);
  CHECK(ranges[0].first == 0);
  CHECK(ranges[0].last == 4);
  CHECK(ranges[1].first == 4);
  CHECK(ranges[1].last == 8);
  CHECK(ranges[2].first == 8);
  CHECK(ranges[2].last == 12);
}

TEST_CASE("parts of a program by tool and by comment", "[unit][program]") {
  model::Program program = three_loadings();
  program.tool_changes.pop_back();
  const auto by_tool =
      assigned(program, {stage_with("a", tool(1), 1), stage_with("b", tool(2), 2)});
  CHECK(by_tool[1].first == 4);
  CHECK(by_tool[1].last == 12);
  program.tool_changes.pop_back();
  const auto by_comment =
      assigned(program, {stage_with("a", comment("ROUGH")), stage_with("b", comment("FINISH"))});
  CHECK(by_comment[0].last == 6);
  CHECK(by_comment[1].first == 6);
  CHECK(assigned(program, {stage_with("a", {})})[0].last == 12);
}

TEST_CASE("a tool that is taken out or never moves makes no part", "[unit][program]") {
  model::Program program;
  program.motions.resize(6);
  program.tool_changes = {{1, 0, 7}, {2, 0, 3}, {5, 4, 0}, {6, 5, 3}};
  const auto changes = loadings(program);
  REQUIRE(changes.size() == 1);
  CHECK(changes[0].tool == 3);
  CHECK(assigned(program, {stage_with("a", {}, 3)})[0].last == 6);
  // As posts load the first tool again for the next part.
  program.tool_changes.push_back({9, 6, 7});
  CHECK(loadings(program).size() == 1);
  CHECK(assigned(program, {stage_with("a", {}, 3)})[0].last == 6);
}

TEST_CASE("a feed needs a tool that the program has loaded", "[unit][program]") {
  model::Program program = three_loadings();
  const std::vector<JobStage> stages = {stage_with("a", section(1)), stage_with("b", section(2)),
                                        stage_with("c", section(3))};
  const auto feed = [&](std::size_t motion, std::uint32_t line) {
    program.motions[motion].kind = model::MotionKind::feed;
    program.motions[motion].line = line;
  };
  feed(6, 33);
  CHECK(assigned(program, stages).size() == 3);
  program.tool_changes.insert(program.tool_changes.begin() + 2, {31, 5, 0});
  CHECK(error_of(program, stages) ==
        "all.ngc:33: error: a feed with no tool in the spindle, out of which T0 took it in line "
        "31; expected a tool that is loaded before");
  // Rapids may go home without one, and a tool that comes back cuts.
  program.tool_changes[2].motion = 7;
  CHECK(assigned(program, stages).size() == 3);

  program = three_loadings();
  program.tool_changes.front().motion = 2;
  CHECK(assigned(program, stages).size() == 3);
  feed(1, 5);
  CHECK(error_of(program, stages) ==
        "all.ngc:5: error: a feed before the first tool is loaded, T1 in line 2; expected a tool "
        "that is loaded before");
  program.tool_changes.clear();
  CHECK(assigned(program, {stage_with("a", {}, 3)}).size() == 1);
}

TEST_CASE("parts that do not fit are refused with the program's line", "[unit][program]") {
  const model::Program program = three_loadings();
  CHECK(error_of(program, {stage_with("a", {})}) ==
        "all.ngc:20: error: T2 is loaded in the part that stage \"a\" takes, after T1; expected a "
        "stage for each tool, by \"program_tool\" or \"program_section\"; with verify or cut a "
        "--tool "
        "N=... for each");
  CHECK_THAT(error_of(program, {stage_with("a", tool(1), 1), stage_with("b", tool(2), 2)}),
             ContainsSubstring("all.ngc:40: error: stage \"a\" takes T1, which is loaded a second "
                               "time here"));
  CHECK_THAT(error_of(program, {stage_with("a", section(1), 1), stage_with("b", section(2), 3)}),
             ContainsSubstring("all.ngc:20: error: T2 is loaded where stage \"b\" has"));
  CHECK_THAT(error_of(program, {stage_with("a", section(4))}), ContainsSubstring("section 4 of 3"));
  CHECK_THAT(error_of(program, {stage_with("a", tool(9))}), ContainsSubstring("never loaded"));
  CHECK_THAT(error_of(program, {stage_with("a", comment("NO"))}), ContainsSubstring("nowhere"));
  CHECK_THAT(error_of(program, {stage_with("a", comment("AGAIN"))}),
             ContainsSubstring("all.ngc:41: error: stage \"a\" begins at the comment"));
  CHECK_THAT(error_of(program, {stage_with("a", section(2)), stage_with("b", section(1))}),
             ContainsSubstring("stages in the program's order"));
  CHECK_THAT(error_of(program, {stage_with("a", section(1)), stage_with("b", {})}),
             ContainsSubstring("takes the whole program"));
}

}  // namespace limitgauge::app
