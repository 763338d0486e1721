#include "model/gcode/turning/turning_program.h"

#include <cmath>
#include <sstream>

#include "model/gcode/cl_data.h"
#include "model/gcode/turning/turning_path.h"
#include "model/text/fixed_number.h"
#include "tests/model/gcode/read_text.h"
#include "tests/model/gcode/turning/turning_machines.h"
#include "tests/support/catch.h"
#include "tests/support/messages.h"

namespace limitgauge::model {
namespace {

using namespace test;

constexpr double kBall_mm = 3, kBend_mm = 0.001;
constexpr Vec3 kSpindleUp{0, 0, 1};

Vec3 leaning(double tilt_rad, double azimuth_rad) {
  return {std::sin(tilt_rad) * std::cos(azimuth_rad), std::sin(tilt_rad) * std::sin(azimuth_rad),
          std::cos(tilt_rad)};
}

/// A ball's centre round a circle, the tool leaning by `tilt_rad` from azimuth 0 on.
TurningPath circling(double tilt_rad, double turns = 1) {
  TurningPath made;
  made.path.start = {20, 0, 60 - kBall_mm};
  const auto add = [&](const Vec3& centre, const Vec3& axis, MoveKind kind) {
    made.path.moves.emplace_back(centre - axis * kBall_mm, kind == MoveKind::feed ? 500.0F : 0.0F,
                                 0U, kind);
    made.axes.to.push_back(axis);
  };
  const int count = static_cast<int>(90 * turns);
  add({20, 0, 60}, leaning(tilt_rad, 0), MoveKind::rapid);
  for (int i = 0; i <= count; ++i) {
    const double a = 2 * 3.14159265358979 * turns * i / count;
    add({20 * std::cos(a), 20 * std::sin(a), 10}, leaning(tilt_rad, a), MoveKind::feed);
  }
  const Vec3 last = made.path.moves.back().to + made.axes.to.back() * kBall_mm;
  add({last.x, last.y, 60}, made.axes.to.back(), MoveKind::rapid);
  add({last.x, last.y, 60}, kSpindleUp, MoveKind::rapid);
  return made;
}

RotaryPath posted(const TurningPath& path, const MachineSetup& machine) {
  const PathOptions options = turning_options(machine);
  const WorkOffset g54 = machine.work_offsets[0].value();
  const Pose part = pose_of(options.machine_in_part).inverse();
  Pose work = part;
  work.shift_mm -= g54.origin_mm;
  return rotary_path(path.path, path.axes,
                     {*machine.kinematics, work, part, kBall_mm, kBend_mm, 4});
}

TurningPath read_again(const RotaryPath& path, const MachineSetup& machine) {
  std::ostringstream out;
  TurningWriter writer{{}, machine.control, *machine.kinematics};
  writer.text.dialect = dialect_for(machine.control);
  const std::uint32_t line = write_turning_program(path, writer, out);
  const Program program = read_text(out.str(), machine);
  PathOptions options = turning_options(machine, 0.01);
  while (program.motions[options.first].line < line) ++options.first;
  return to_turning_path(program, options);
}

double off_circle_mm(const Vec3& centre) {
  return std::hypot(std::hypot(centre.x, centre.y) - 20, centre.z - 10);
}

}  // namespace

TEST_CASE("a leaning ball's program leads its centre where it was planned", "[property][gcode]") {
  const TurningPath path = circling(0.5);
  std::vector<MachineSetup> machines = {turning_trunnion(), turning_trunnion(Control::haas),
                                        turning_trunnion(Control::linuxcnc), turning_heads(),
                                        turning_head_table()};
  for (const MachineSetup& machine : machines) {
    INFO(name(machine.control) << ", " << name(machine.kinematics->kind));
    const TurningPath made = read_again(posted(path, machine), machine);
    CHECK(distance(made.path.start, path.path.start) < 1e-4);
    CHECK(distance(made.axes.to.back(), kSpindleUp) < 1e-9);
    double worst = 0;
    for (std::size_t i = 0; i < made.path.moves.size(); ++i)
      if (made.path.moves[i].kind == MoveKind::feed)
        worst = std::max(worst, off_circle_mm(made.path.moves[i].to + made.axes.to[i] * kBall_mm));
    // Chords of the circle, the rounding of places, and the bend.
    CHECK(worst < 20 * (1 - std::cos(3.14159265358979 / 90)) + 2e-4 + kBend_mm);
  }
}

TEST_CASE("rotary axes keep to their limits, or the path is refused", "[unit][gcode]") {
  MachineSetup machine = turning_trunnion();
  machine.kinematics->axes[1].low_deg = -400, machine.kinematics->axes[1].high_deg = 400;
  for (const RotaryPlace& place : posted(circling(0.5, 1), machine).to)
    CHECK(std::abs(place.angles_deg[2]) <= 400);
  machine.kinematics->axes[1].low_deg = -170, machine.kinematics->axes[1].high_deg = 170;
  CHECK_THAT(tests::message_of<std::invalid_argument>([&] { posted(circling(0.5, 1), machine); }),
             ContainsSubstring("do not bring it within their limits"));
  machine.kinematics->axes[0].low_deg = -10, machine.kinematics->axes[0].high_deg = 10;
  CHECK_THROWS_AS(posted(circling(0.5), machine), std::invalid_argument);
}

TEST_CASE("CL data with tool axes read back as they were written", "[unit][cl]") {
  const TurningPath path = circling(0.4);
  std::ostringstream out;
  write_cl_data(path.path, parse_cutter("ball:D=6"), {"PART", 1, 6}, out, &path.axes);
  std::istringstream in(out.str());
  const ClData read = read_cl_data(in, "rows.apt");
  REQUIRE(read.moves.size() == path.path.moves.size());
  REQUIRE(read.axes.size() == path.axes.to.size());
  CHECK(read.from == rounded(path.path.start, 6));
  for (std::size_t i = 0; i < read.moves.size(); ++i) {
    CHECK(distance(read.moves[i].to, path.path.moves[i].to) < 1e-6);
    CHECK(distance(read.axes[i], path.axes.to[i]) < 1e-8);
    CHECK(read.moves[i].kind == path.path.moves[i].kind);
  }
}

}  // namespace limitgauge::model
