#include <iomanip>
#include <sstream>

#include "tests/model/gcode/read_text.h"
#include "tests/model/gcode/turning/turning_machines.h"
#include "tests/model/gcode/turning/turning_poses.h"
#include "tests/support/catch.h"

namespace limitgauge::model {
namespace {

using namespace test;

/// What nine decimals of places and angles leave.
constexpr double kDigits_mm = 1e-7;

struct PostedPath {
  std::string cl_data, program;
  std::vector<std::uint32_t> lines;  ///< of the program, one a GOTO
};

std::string figure(double value) {
  std::ostringstream text;
  text << std::fixed << std::setprecision(9) << value;
  return text.str();
}

/// Forty places near each other with axes that lean by up to thirty degrees, as CL data and as a
/// program under tip control.
PostedPath posted_path(const MachineSetup& machine, std::mt19937_64& random) {
  PostedPath posted{"FEDRAT/500\n", kCentred, {}};
  RotaryAngles angles{};
  for (std::uint32_t i = 0; i < 40; ++i) {
    const Vec3 at = random_place(random, 40);
    const Vec3 leaning = normalized(Vec3{0, 0, 1} + random_place(random, 0.3));
    angles = machine.kinematics->angles_for(leaning, angles).value();
    posted.cl_data += "GOTO/";
    posted.program += "G1 F500";
    for (int k = 0; k < 3; ++k) {
      posted.cl_data += figure(at[k]) + ",";
      posted.program += std::string(" ") + "XYZ"[k] + figure(at[k]);
    }
    posted.cl_data +=
        figure(leaning.x) + "," + figure(leaning.y) + ",$\n" + figure(leaning.z) + "\n";
    for (const RotaryAxis& axis : machine.kinematics->axes)
      posted.program += std::string(" ") + axis.word + figure(angles[axis.index()]);
    posted.program += "\n";
    posted.lines.push_back(4 + i);
  }
  posted.cl_data += "FINI\n";
  return posted;
}

}  // namespace

TEST_CASE("CL data and their posting for a machine lead the tool through the same places",
          "[property][gcode]") {
  std::mt19937_64 random(92);
  for (const auto& machine : {turning_trunnion(), turning_heads(), turning_head_table()}) {
    const PostedPath posted = posted_path(machine, random);
    std::istringstream cl(posted.cl_data);
    const Program located = read_program(cl, "five.apt", machine);
    const PathOptions options = turning_options(machine);
    const TurningPath stated = to_turning_path(located, options);
    const TurningPath made = to_turning_path(read_text(posted.program, machine), options);
    REQUIRE(made.path.moves.size() > stated.path.moves.size());
    for (std::size_t i = 0; i < stated.path.moves.size(); ++i) {
      const std::size_t last = moves_of(made, posted.lines[i]).back();
      CHECK(distance(made.path.moves[last].to, stated.path.moves[i].to) < kDigits_mm);
      CHECK(distance(made.axes.to[last], stated.axes.to[i]) < kDigits_mm);
    }
  }
}

}  // namespace limitgauge::model
