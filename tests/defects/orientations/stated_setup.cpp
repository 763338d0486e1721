#include "tests/defects/orientations/stated_setup.h"

#include "tests/defects/orientations/machine.h"
#include "tests/support/printed.h"

namespace limitgauge::tests::defects {
namespace {

std::string turns_text(const StatedSetup& setup) {
  std::string text = "rotate = [";
  for (const auto& [axis, angle] : setup.turns)
    text += "{ axis = " + toml_numbers(axis) + printed(", angle = %.17g }, ", angle);
  return text + "]\n";
}

}  // namespace

std::string toml_numbers(const model::Vec3& v) {
  return printed("[%.17g, %.17g, %.17g]", v.x, v.y, v.z);
}

model::Pose StatedSetup::pose() const {
  model::Pose pose;
  if (style == Style::flip) {
    pose = turned_about(flip == 'x' ? model::Vec3{1, 0, 0} : model::Vec3{0, 1, 0}, 180);
  } else {
    for (const auto& [axis, angle] : turns) pose = turned_about(axis, angle) * pose;
  }
  pose.shift_mm = origin_mm;
  return pose;
}

std::string StatedSetup::text() const {
  std::string text = "[[setup]]\nname = \"vice\"\n";
  if (style == Style::flip) text += std::string("flip = \"") + flip + "\"\n";
  if (style == Style::turns) text += turns_text(*this);
  if (style == Style::matrix) {
    const auto rows = pose().rows;
    text += "matrix = [" + toml_numbers(rows[0]) + ", " + toml_numbers(rows[1]) + ", " +
            toml_numbers(rows[2]) + "]\n";
  }
  return text + "origin = " + toml_numbers(origin_mm) + "\n";
}

}  // namespace limitgauge::tests::defects
