#include "tests/defects/orientations/stated_setup.h"

#include <cstdio>

#include "tests/defects/orientations/machine.h"

namespace limitgauge::tests::defects {
namespace {

std::string numbers(const model::Vec3& v) {
  char text[120];
  std::snprintf(text, sizeof text, "[%.17g, %.17g, %.17g]", v.x, v.y, v.z);
  return text;
}

std::string turns_text(const StatedSetup& setup) {
  std::string text = "rotate = [";
  for (const auto& [axis, angle] : setup.turns) {
    char end[60];
    std::snprintf(end, sizeof end, ", angle = %.17g }, ", angle);
    text += "{ axis = " + numbers(axis) + end;
  }
  return text + "]\n";
}

}  // namespace

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
    text +=
        "matrix = [" + numbers(rows[0]) + ", " + numbers(rows[1]) + ", " + numbers(rows[2]) + "]\n";
  }
  return text + "origin = " + numbers(origin_mm) + "\n";
}

}  // namespace limitgauge::tests::defects
