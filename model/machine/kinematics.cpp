#include "model/machine/kinematics.h"

#include <algorithm>

#include "model/text/number_text.h"

namespace limitgauge::model {
namespace {

constexpr Vec3 kUp{0, 0, 1};

Pose rotation(const Pose& pose) {
  Pose turn = pose;
  turn.shift_mm = {};
  return turn;
}

}  // namespace

const char* name(MachineKind kind) {
  switch (kind) {
    case MachineKind::table_table:
      return "table-table";
    case MachineKind::head_table:
      return "head-table";
    case MachineKind::head_head:
      break;
  }
  return "head-head";
}

Pose RotaryAxis::turn(double angle_deg) const {
  Pose pose = turn_about(direction, angle_deg);
  pose.shift_mm = point_mm - pose.direction(point_mm);
  return pose;
}

bool Kinematics::is_head(std::size_t i) const {
  return kind == MachineKind::head_head || (kind == MachineKind::head_table && i == 0);
}

Pose Kinematics::table(const RotaryAngles& angles_deg) const {
  Pose pose;
  for (std::size_t i = 0; i < axes.size(); ++i)
    if (!is_head(i)) pose = pose * axes[i].turn(angles_deg[axes[i].index()]);
  return pose;
}

Pose Kinematics::head(const RotaryAngles& angles_deg) const {
  Pose pose;
  for (std::size_t i = 0; i < axes.size(); ++i)
    if (is_head(i)) pose = pose * axes[i].turn(angles_deg[axes[i].index()]);
  return pose;
}

Vec3 Kinematics::tip_aside_mm(const RotaryAngles& angles_deg, double tool_length_mm) const {
  const Vec3 tool{0, 0, -tool_length_mm};
  return head(angles_deg).point(tool) - tool;
}

Pose Kinematics::head_carrying(char word, const RotaryAngles& angles_deg) const {
  Pose pose;
  for (std::size_t i = 0; i < axes.size(); ++i) {
    if (is_head(i)) pose = pose * axes[i].turn(angles_deg[axes[i].index()]);
    if (axes[i].word == word) break;
  }
  return pose;
}

Pose Kinematics::carried_by(std::optional<char> word, const RotaryAngles& angles_deg) const {
  Pose pose;
  if (!word) return pose;
  for (std::size_t i = 0; i < axes.size(); ++i) {
    if (!is_head(i)) pose = pose * axes[i].turn(angles_deg[axes[i].index()]);
    if (axes[i].word == *word) break;
  }
  return pose;
}

ToolStand Kinematics::stand(const Vec3& gauge_mm, const RotaryAngles& angles_deg,
                            double tool_length_mm) const {
  const Pose part = table(angles_deg), tool = head(angles_deg);
  return {part.point_back(gauge_mm + tool.point({0, 0, -tool_length_mm})),
          part.direction_back(tool.direction(kUp))};
}

Pose Kinematics::upright(const RotaryAngles& angles_deg) const {
  return rotation(head(angles_deg)).inverse() * table(angles_deg);
}

std::string Kinematics::to_text(const RotaryAngles& angles_deg, const char* between) const {
  std::string text;
  for (const RotaryAxis& axis : axes) {
    if (!text.empty()) text += between;
    text += axis.word + six_digits(angles_deg[axis.index()] + 0.0);  // no negative zero
  }
  return text;
}

const RotaryAxis* Kinematics::axis(char word) const {
  const auto found = std::find_if(axes.begin(), axes.end(),
                                  [word](const RotaryAxis& axis) { return axis.word == word; });
  return found == axes.end() ? nullptr : &*found;
}

}  // namespace limitgauge::model
