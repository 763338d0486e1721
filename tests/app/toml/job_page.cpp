#include "tests/app/toml/job_page.h"
#include "tests/support/folders.h"

#include <fstream>
#include <sstream>
#include <stdexcept>

namespace limitgauge::app {
namespace {

std::string trimmed(const std::string& text) {
  const std::size_t first = text.find_first_not_of(' ');
  if (first == std::string::npos) return {};
  return text.substr(first, text.find_last_not_of(' ') - first + 1);
}

/// `| a | b |` as {"a", "b"}; nothing for other lines.
std::vector<std::string> cells_of(const std::string& line) {
  std::vector<std::string> cells;
  if (line.empty() || line.front() != '|') return cells;
  std::istringstream row(line.substr(1));
  for (std::string cell; std::getline(row, cell, '|');) cells.push_back(trimmed(cell));
  return cells;
}

}  // namespace

std::map<std::string, DocumentedKey> documented_keys(const std::string& page) {
  std::map<std::string, DocumentedKey> keys;
  std::ifstream lines(tests::fixtures().string() + "/../docs/" + page);
  for (std::string line; std::getline(lines, line);) {
    const std::vector<std::string> cells = cells_of(line);
    if (cells.size() < 5 || cells[0].size() < 3 || cells[0].front() != '`') continue;
    const std::string key = cells[0].substr(1, cells[0].size() - 2);
    if (!keys.emplace(key, DocumentedKey{cells[1], cells[2], cells[3]}).second)
      throw std::runtime_error("docs/" + page + " has " + key + " twice");
  }
  return keys;
}

std::vector<std::string> jobs_with_every_key() {
  const std::string planned = R"(
[[tool]]
id = "flat8"
type = "flat"
diameter = 8
plunge = true
flute_length = 20
shank = { diameter = 8, length = 30 }
holder = [ { diameter = 30, length = 20 }, { diameter = 50, length = 20 } ]
[[tool]]
id = "bull8"
type = "bull"
diameter = 8
corner_radius = 1
max_ramp_angle = 5
[[tool]]
id = "taper1"
type = "taper"
diameter = 1
corner_radius = 0.5
angle = 5
[[stage]]
name = "rough"
tool = "flat8"
strategy = "contour"
step = 0.5
allowance = 0.3
tolerance = 0.05
feed = 1200
plunge_feed = 300
link_feed = 900
direction = "climb"
entry = "helix"
ramp_angle = 4
floor = -1
[stage.gate]
gouge = 0.1
uncut = 1
coverage = 0.9
unreachable = 0.5
unavoidable = 2
[[stage]]
name = "finish"
tool = "bull8"
strategy = "steep_shallow"
step = 0.3
scallop = 0.01
tolerance = 0.01
feed = 1000
angle = 30
pattern = "one_way"
boundary_pass = true
steep_angle = 40
overlap = 0.5
)";
  const std::string first = R"(name = "first"
[surface]
cage = "cages/quick-dome.obj"
precision = 0.02
transform = { scale = 2, rotate_z = 90, translate = [1, 2, 3] }
[stock]
shape = "box"
size = [50, 50, 20]
corner = [-25, -25, -5]
[machine]
rapid = 8000
clearance = 3
acceleration = 400
travel = { x = [-200, 200], y = [-200, 200], z = [-50, 200] }
[post]
dialect = "grbl"
decimals = 3
arcs = 0.005
line_numbers = true
cl_data = true
[simulation]
voxel = 0.2
near_miss = 0.5
contact_tolerance = 0.05
[verification]
resolution = 0.002
[report]
pictures = false
stock = "whole"
[[fixture]]
name = "clamp"
file = "findings/clamp.obj"
translate = [60, 0, 0]
[tolerances]
zero = [0.005, [-0.002, 0.001], 0]
tool.flat8 = { radius = 0.01, length = 0.005 }
tool.bull8 = { corner_radius = [-0.01, 0], flat = 0.01 }
path = 0.001
runout = 0.002
positioning = [0.001, 0.001, 0.002]
margin = true
)";
  const std::string foreign = R"(name = "foreign"
surface = { cage = "foreign/plate.obj" }
[stock]
shape = "mesh"
file = "findings/clamp.obj"
scale = 2
translate = [1, 0, 0]
[machine]
acceleration = 400
junction_deviation = 0.02
start = [0, 0, 120]
home = [0, 0, 300]
second_home = [0, 0, 200]
control = "haas"
subprograms = "foreign"
[machine.work_offsets]
G54 = [1, 2, 3]
G55 = { origin = [0, 0, 0], rotate_z = 90 }
G56 = [0, 0, 0]
G57 = [0, 0, 0]
G58 = [0, 0, 0]
G59 = [0, 0, 0]
"G59.1" = [0, 0, 0]
"G59.2" = [0, 0, 0]
"G59.3" = [0, 0, 0]
[program_frame]
offset = [0, 0, 1]
rotate_z = 90
[[tool]]
id = "drill6"
type = "drill"
diameter = 6
point_angle = 118
number = 1
length = 80
[[tool]]
id = "apt10"
type = "apt"
diameter = 10
corner_radius = 1
tip_angle = 0
side_angle = 0
e = 4
f = 1
number = 2
[[stage]]
name = "a"
program = "foreign/plate.ngc"
program_tool = 1
[[stage]]
name = "b"
tool = "apt10"
program = "foreign/plate.ngc"
program_section = 2
[[stage]]
name = "c"
tool = "apt10"
program = "foreign/plate.ngc"
program_comment = "FINISH"
[[stage]]
name = "d"
tool = "drill6"
program = "foreign/plate.ngc"
program_tool = 1
[published]
source = "a paper"
patches = 12
depth = [7, 8]
sampling_interval = [1, 4]
seconds = 10
memory_mb = 20
[[published.stage]]
name = "a"
planes = 100
seconds = 1
memory_mb = 2
)";
  const std::string bar = R"(name = "bar"
surface = { cage = "cages/quick-dome.obj" }
stock = { shape = "cylinder", diameter = 40, height = 12, base = [0, 0, -5] }
)";
  const std::string mesh = R"(name = "mesh"
surface = { mesh = "findings/clamp.obj" }
stock = { shape = "box", size = [60, 60, 60], corner = [-30, -30, -30] }
[[tool]]
id = "flat6"
type = "flat"
diameter = 6
[[stage]]
name = "a"
tool = "flat6"
program = "foreign/plate.ngc"
)";
  const std::string sides = R"(name = "sides"
surface = { cage = "cages/quick-dome.obj" }
stock = { shape = "box", size = [60, 60, 60], corner = [-30, -30, -30] }
[[setup]]
name = "front"
origin = [1, 2, 3]
rotate = [{ axis = [0, 0, 1], angle = 90 }]
[setup.work_offsets]
G54 = [1, 2, 3]
G55 = { origin = [0, 0, 0], rotate_z = 90 }
G56 = [0, 0, 0]
G57 = [0, 0, 0]
G58 = [0, 0, 0]
G59 = [0, 0, 0]
"G59.1" = [0, 0, 0]
"G59.2" = [0, 0, 0]
"G59.3" = [0, 0, 0]
[[setup]]
name = "back"
flip = "x"
[[setup]]
name = "side"
matrix = [[1, 0, 0], [0, 0, -1], [0, 1, 0]]
[[fixture]]
name = "clamp"
file = "findings/clamp.obj"
setup = "back"
[[tool]]
id = "flat6"
type = "flat"
diameter = 6
[[stage]]
name = "a"
setup = "back"
tool = "flat6"
program = "foreign/plate.ngc"
)";
  const std::string turning = R"(name = "turning"
surface = { cage = "cages/quick-dome.obj" }
stock = { shape = "box", size = [26, 26, 9], corner = [-13, -13, -4] }
[machine]
kinematics = "table-table"
tool_centred = true
[[machine.axis]]
word = "A"
direction = [1, 0, 0]
point = [0, 0, -50]
limits = [-120, 30]
[[fixture]]
name = "clamp"
file = "findings/clamp.obj"
axis = "A"
[[tool]]
id = "flat6"
type = "flat"
diameter = 6
[[stage]]
name = "a"
tool = "flat6"
program = "foreign/plate.ngc"
)";
  const std::string leaning = R"(name = "leaning"
surface = { cage = "cages/quick-dome.obj" }
[stock]
shape = "box"
size = [50, 50, 20]
corner = [-25, -25, -5]
[machine]
kinematics = "table-table"
[[machine.axis]]
word = "A"
direction = [1, 0, 0]
point = [0, 0, -50]
limits = [-120, 30]
[[tool]]
id = "ball6"
type = "ball"
diameter = 6
[[stage]]
name = "finish"
tool = "ball6"
strategy = "zigzag"
step = 1
tolerance = 0.02
feed = 1000
tilt = 20
lead = 5
lean_from = "surface"
[[stage]]
name = "again"
tool = "ball6"
strategy = "zigzag"
step = 1
tolerance = 0.02
feed = 1000
tilt = "auto"
)";
  return {first + planned, foreign, bar + planned, mesh, sides, turning, leaning};
}

}  // namespace limitgauge::app
