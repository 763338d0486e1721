#include "reports/run/program_lines.h"

#include "reports/html/stage/stage_parts.h"
#include "tests/reports/sample_result.h"
#include "tests/support/catch.h"

namespace limitgauge::reports {
namespace {

const std::string kProgram = "one\ntwo\r\nthree\nfour\nfive\nsix\nseven";

std::string numbers_of(const std::vector<ProgramLine>& lines) {
  std::string numbers;
  for (const ProgramLine& line : lines)
    numbers.append(numbers.empty() ? "" : " ").append(std::to_string(line.line));
  return numbers;
}

}  // namespace

TEST_CASE("lines of a program by number", "[unit][report]") {
  const std::vector<std::uint32_t> wanted = {7, 2, 0, 2};
  const auto alone = program_lines(kProgram, wanted, 0);
  REQUIRE(alone.size() == 2);
  CHECK(alone[0].text == "two");
  CHECK(alone[1].text == "seven");
  CHECK(numbers_of(program_lines(kProgram, wanted, 1)) == "1 2 3 6 7");
  CHECK(numbers_of(program_lines(kProgram, wanted, 100)) == "1 2 3 4 5 6 7");
  const std::vector<std::uint32_t> far = {4000000000U};
  CHECK(program_lines(kProgram, far, 3).empty());
}

TEST_CASE("a long line is cut, stray bytes are shown as such", "[unit][report]") {
  const std::vector<std::uint32_t> first = {1};
  const auto lines = program_lines(std::string(1000, 'G') + "\n", first, 0);
  CHECK(lines[0].text.size() == 159 + std::string("…").size());
  CHECK(program_lines("G1\x01X\n", first, 0)[0].text == "G1\xEF\xBF\xBDX");
}

TEST_CASE("the page shows the program at its findings as text", "[unit][report]") {
  RunResult result = sample_result(Outcome::passed);
  StageResult& stage = result.stages.front();
  REQUIRE(stage.ran);
  stage.ran->deviation->gouges.resize(1);
  stage.ran->deviation->gouges[0].stage = 0;
  stage.ran->deviation->gouges[0].line = 5;
  stage.ran->deviation->uncuts.clear();
  stage.ran->process.clear();
  stage.ran->program_text =
      std::make_shared<const std::string>("a\nb\nc\nd\nG1 <script>alert(1)</script>\nf\n");
  const std::string page = html::program_part(result, 0);
  CHECK_THAT(page, ContainsSubstring("<td>G1</td><th scope=\"row\">5</th><td><code>G1 "
                                     "&lt;script&gt;"));
  CHECK(page.find("<script>") == std::string::npos);
  CHECK_THAT(page, ContainsSubstring("<th scope=\"row\">2</th>"));
  stage.ran->deviation->gouges[0].line = 0;
  CHECK(html::program_part(result, 0).empty());
}

}  // namespace limitgauge::reports
