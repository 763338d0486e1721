#include "model/gcode/machine/coordinate_systems.h"

#include <algorithm>

#include "model/base/angle.h"
#include "model/gcode/control/control_rules.h"

namespace limitgauge::model::gcode {

Vec3 Frame::to_machine(const Vec3& work_mm) const {
  return origin_mm + turned(work_mm + g92_mm, rotation_deg) + Vec3{0, 0, length_offset_mm};
}

Vec3 Frame::to_work(const Vec3& machine_mm) const {
  return turned(machine_mm - origin_mm - Vec3{0, 0, length_offset_mm}, -rotation_deg) - g92_mm;
}

namespace {

constexpr std::array<bool, 3> kAll = {true, true, true};

std::optional<WorkOffset> stated_offset(const MachineSetup& machine, std::size_t index) {
  if (index < kWorkOffsets) return machine.work_offsets[index];
  const auto found = machine.extended_offsets.find(static_cast<int>(index - kWorkOffsets) + 1);
  return found == machine.extended_offsets.end() ? std::nullopt : std::optional(found->second);
}

}  // namespace

CoordinateSystems::CoordinateSystems(const MachineSetup& machine)
    : systems_(kWorkOffsets +
               static_cast<std::size_t>(rules_of(machine.control).extended_systems)) {
  for (std::size_t i = 0; i < systems_.size(); ++i) {
    const std::optional<WorkOffset> stated = stated_offset(machine, i);
    if (!stated && !machine.assume_fresh_machine) continue;
    const WorkOffset offset = stated.value_or(WorkOffset{});
    systems_[i] = {offset.origin_mm, offset.rotation_deg, kAll, kAll, {}, !stated};
    frame_is_taken_ = false;
  }
  if (frame_is_taken_) systems_[0].usable = kAll;
}

Frame CoordinateSystems::frame(std::size_t index) const {
  return {systems_[index].origin_mm, systems_[index].rotation_deg, g92_mm_, 0};
}

bool CoordinateSystems::lie_as(const CoordinateSystems& other) const {
  const auto same = [](const CoordinateSystem& a, const CoordinateSystem& b) {
    return a.origin_mm == b.origin_mm && a.rotation_deg == b.rotation_deg;
  };
  return g92_mm_ == other.g92_mm_ && std::equal(systems_.begin(), systems_.end(),
                                                other.systems_.begin(), other.systems_.end(), same);
}

void CoordinateSystems::state(std::size_t index, int axis, double origin_mm) {
  CoordinateSystem& system = systems_[index];
  system.origin_mm[axis] = origin_mm;
  system.usable[axis] = system.stated[axis] = true;
  system.set_by_program[static_cast<std::size_t>(axis)] = true;
}

void CoordinateSystems::touch(std::size_t index, const Vec3& machine_mm, const Vec3& work_mm,
                              const std::array<bool, 3>& set) {
  CoordinateSystem& system = systems_[index];
  const bool is_turned = system.rotation_deg != 0;
  const Vec3 origin_mm = machine_mm - turned(work_mm + g92_mm_, system.rotation_deg);
  for (int axis = 0; axis < 3; ++axis) {
    // A turned system's X and Y both depend on both words; LinuxCNC keeps the other coordinate.
    const bool moves = set[axis] || (is_turned && axis < 2 && (set[0] || set[1]));
    if (moves) system.origin_mm[axis] = origin_mm[axis];
    if (set[axis]) system.usable[axis] = true;
    if (set[axis]) system.set_by_program[static_cast<std::size_t>(axis)] = true;
  }
}

void CoordinateSystems::set_g92(int axis, double offset_mm) {
  g92_mm_[axis] = offset_mm;
  saved_g92_mm_ = g92_mm_;
  g92_applies_ = g92_was_set_ = true;
}

void CoordinateSystems::cancel_g92(bool forget) {
  g92_applies_ = false;
  g92_mm_ = {};
  if (!forget) return;
  saved_g92_mm_ = {};
  g92_was_set_ = true;
}

void CoordinateSystems::restore_g92() {
  g92_applies_ = true;
  g92_mm_ = saved_g92_mm_;
}

}  // namespace limitgauge::model::gcode
