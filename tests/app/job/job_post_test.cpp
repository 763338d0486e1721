#include "app/job/job_parts.h"

#include <algorithm>
#include <numbers>

#include "app/job/settings.h"
#include "app/run/stage_program.h"
#include "model/base/error.h"
#include "model/gcode/cl_data.h"
#include "model/gcode/program.h"
#include "tests/app/job_text.h"
#include "tests/support/catch.h"
#include "tests/support/messages.h"

namespace limitgauge::app {
namespace {

std::string refusal_of(const std::string& added) {
  return tests::message_of<model::InputError>([&] { read(good_job() + added); });
}

bool says(const std::vector<std::string>& lines, const std::string& what) {
  return std::any_of(lines.begin(), lines.end(),
                     [&](const std::string& line) { return line.find(what) != std::string::npos; });
}

/// A half circle in a plane perpendicular to X, as a row over a dome is.
PlannedStage planned_row() {
  constexpr int kChords = 100;
  PlannedStage planned;
  model::Toolpath& path = planned.path.path;
  path.start = {0.5, 0, 20};
  path.moves.emplace_back(model::Vec3{0.5, -10, 20}, 0.0F, 0, model::MoveKind::rapid);
  path.moves.emplace_back(model::Vec3{0.5, -10, 0}, 300.0F, 0, model::MoveKind::feed);
  for (int i = 1; i <= kChords; ++i) {
    const double angle = std::numbers::pi * (1 - 1.0 * i / kChords);
    path.moves.emplace_back(model::Vec3{0.5, 10 * std::cos(angle), 10 * std::sin(angle)}, 900.0F, 0,
                            model::MoveKind::feed);
  }
  return planned;
}

TEST_CASE("a job's programs are LinuxCNC's unless it says otherwise", "[unit][job]") {
  CHECK(says(read(good_job()).defaulted, "programs: defaults: dialect = linuxcnc, decimals = 4"));
  const Job fanuc = read(good_job() + "[post]\ndialect = \"fanuc\"\n");
  CHECK(fanuc.post.decimals == 3);
  CHECK(says(fanuc.defaulted, "programs: defaults: decimals = 3"));
  const Job stated = read(good_job() + "[post]\ndialect = \"grbl\"\ndecimals = 2\n");
  CHECK(stated.post.dialect == model::Dialect::grbl);
  CHECK(stated.post.decimals == 2);
  CHECK_FALSE(says(stated.defaulted, "programs"));
}

TEST_CASE("[post] and [machine] are refused where they make no sense", "[unit][job]") {
  CHECK_THAT(refusal_of("[post]\ndialect = \"heidenhain\"\n"),
             ContainsSubstring("job.toml:22:11: error: \"dialect\" in [post] is \"heidenhain\"; "
                               "expected one of \"linuxcnc\", \"fanuc\", \"grbl\""));
  CHECK(refusal_of("[post]\ndialect = \"grbl\"\ndecimals = 5\n") ==
        "job.toml:23:12: error: \"decimals\" in [post] is 5 for dialect grbl; expected a whole "
        "number from 0 to 4");
  CHECK_THAT(refusal_of("[post]\ndecimals = 2.5\n"), ContainsSubstring("0 to 9"));
  CHECK_THAT(refusal_of("[post]\ndecimals = -1\n"), ContainsSubstring("0 to 9"));
  CHECK_THAT(refusal_of("[post]\narcs = 0\n"), ContainsSubstring("a number above zero"));
  CHECK_THAT(refusal_of("[post]\narc = 0.1\n"), ContainsSubstring("expected \"arcs\""));
  CHECK_THAT(refusal_of("[post]\ncl_data = 1\n"), ContainsSubstring("true or false"));
  CHECK_THAT(refusal_of("[machine]\nacceleration = 0\n"), ContainsSubstring("a number above zero"));
  CHECK(refusal_of("[machine]\njunction_deviation = 0.1\n") ==
        "job.toml:22:22: error: \"junction_deviation\" without \"acceleration\" would change "
        "nothing; expected both, or neither");
}

TEST_CASE("what the machining time rests on is said", "[unit][settings]") {
  const model::Box3 surface{{-10, -10, -2.5}, {10, 10, 4}};
  const auto said = [&](const Job& job) {
    return assumptions(job, choose_settings(job, surface, kMemory));
  };
  CHECK(says(said(read(good_job())), "rapid rate of 5000 mm/min, no acceleration"));
  const Job job = read(good_job() + "[machine]\nacceleration = 400\n[post]\narcs = 0.002\n");
  CHECK_FALSE(says(said(job), "no acceleration"));
  CHECK(says(said(job),
             "acceleration of 400 mm/s² along the path, corners rounded off by at most "
             "0.01 mm"));
  CHECK(says(said(job), "junction deviation 0.01 mm (default)"));
  CHECK(says(said(job),
             "stage finish: arcs stand for runs of planned moves within 0.002 mm; the "
             "program is measured as it is written, arcs as chords within 0.00025 mm"));
}

TEST_CASE("without arcs, the path of a stage is the planned one as rounded", "[unit][post]") {
  const Job job = read(good_job() + "[post]\ndecimals = 2\n");
  PlannedStage planned = planned_row();
  write_stage_program(job, 0, 0.001, planned);
  CHECK(planned.cl_data.empty());
  CHECK(planned.path.path.moves.size() == 102);
  CHECK(planned.path.path.chord_error_mm == 0);
  CHECK(planned.path.path.moves[2].to == model::Vec3{0.5, -10, 0.31});
  CHECK_THAT(planned.program, ContainsSubstring("(dome finish)\n(ball:D=6,L=24)\n"));
}

TEST_CASE("with arcs, the path of a stage is its program read back", "[unit][post]") {
  const Job job = read(good_job() + "[post]\narcs = 0.002\ncl_data = true\n");
  PlannedStage planned = planned_row();
  const model::Toolpath rows = planned.path.path;
  write_stage_program(job, 0, 0.0001, planned);
  CHECK_THAT(planned.program, ContainsSubstring("\nG19 G2 Y10 Z0 J10"));
  const model::Toolpath& path = planned.path.path;
  // Chords of a half circle of 10 mm within 0.0001 mm: sagitta r h²/8.
  CHECK(path.moves.size() ==
        2 + static_cast<std::size_t>(std::ceil(std::numbers::pi / std::sqrt(8 * 0.0001 / 10))));
  CHECK(path.chord_error_mm > 0.00009);
  CHECK(path.chord_error_mm <= 0.0001);
  CHECK(path.moves.back().to == model::Vec3{0.5, 10, 0});
  CHECK(path.moves[1].line + 1 == path.moves.back().line);
  CHECK(planned.path.memory_bytes == path.moves.size() * sizeof(model::Move));
  // CL data keep the planned points.
  std::istringstream in(planned.cl_data);
  const model::ClData data = model::read_cl_data(in, "toolpath.apt");
  CHECK(data.part == "dome finish");
  CHECK(data.moves.size() == rows.moves.size());
}

TEST_CASE("a path that a dialect cannot express is an input error", "[unit][post]") {
  const Job job = read(good_job() + "[post]\ndialect = \"grbl\"\n");
  PlannedStage planned = planned_row();
  planned.path.path.moves[0].to.x = 12345;
  CHECK_THROWS_WITH(
      write_stage_program(job, 0, 0.001, planned),
      ContainsSubstring("stage \"finish\": a toolpath point is not finite or beyond"));
}

}  // namespace
}  // namespace limitgauge::app
