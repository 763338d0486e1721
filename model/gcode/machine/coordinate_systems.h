#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "model/geometry/vec3.h"
#include "model/machine/machine_setup.h"

namespace limitgauge::model::gcode {

/// Work coordinates to machine coordinates: tip = origin + turn(programmed + G92 offset) + length
/// offset in use - true length of the tool in the spindle. Without a true length (no tool table)
/// the tool is taken to be as long as its own length offset says.
struct Frame {
  Vec3 origin_mm;
  double rotation_deg = 0;  ///< about Z, counter-clockwise seen from above
  Vec3 g92_mm;
  double length_offset_mm = 0;  ///< what G43 added less what the tool truly measures

  Vec3 to_machine(const Vec3& work_mm) const;
  Vec3 to_work(const Vec3& machine_mm) const;
  friend bool operator==(const Frame&, const Frame&) = default;
};

/// One of G54 to G59.3 as the machine states it and the program sets it.
struct CoordinateSystem {
  Vec3 origin_mm;
  double rotation_deg = 0;
  /// Whether the coordinate of an axis means anything: stated, or set from where the tool stands.
  std::array<bool, 3> usable{};
  /// Whether the origin is known in the machine's own coordinates, which G53, G28 and G30 use.
  std::array<bool, 3> stated{};

  /// The program itself has said where it lies along an axis.
  std::array<bool, 3> set_by_program{};

  /// Nothing states it: a fresh machine's, at its zero.
  bool is_fresh = false;

  bool is_set_by_program() const {
    return set_by_program[0] && set_by_program[1] && set_by_program[2];
  }
  bool is_usable() const { return usable[0] && usable[1] && usable[2]; }
};

/// The offsets that lie between the machine's coordinates and the programmed ones: G54 to G59.3
/// with their rotation, and those of G92 and G52, which hold in all nine.
/// Where the machine states none of the nine, its frame is taken to be that of G54: a program is
/// then read as it stands over the part.
class CoordinateSystems {
 public:
  explicit CoordinateSystems(const MachineSetup& machine);

  /// G54 to G59.3, and those of G54.1 P behind them.
  std::size_t count() const { return systems_.size(); }
  std::size_t active() const { return active_; }
  const CoordinateSystem& system(std::size_t index) const { return systems_[index]; }
  const CoordinateSystem& system() const { return systems_[active_]; }
  std::string name() const { return work_offset_name(active_); }
  /// Whether machine coordinates are only G54's, for want of anything stated.
  bool frame_is_taken() const { return frame_is_taken_; }
  const Vec3& g92_mm() const { return g92_mm_; }
  const Vec3& saved_g92_mm() const { return saved_g92_mm_; }
  bool g92_applies() const { return g92_applies_; }
  bool g92_was_set() const { return g92_was_set_; }
  /// Whether all of them lie where those of `other` do.
  bool lie_as(const CoordinateSystems& other) const;
  /// Without a length offset.
  Frame frame(std::size_t index) const;

  void select(std::size_t index) { active_ = index; }
  /// G10 L2: a coordinate of the origin in machine coordinates.
  void state(std::size_t index, int axis, double origin_mm);
  void rotate(std::size_t index, double degrees) { systems_[index].rotation_deg = degrees; }
  /// G10 L20: the origin that makes `work_mm` the coordinates of `machine_mm` (without length
  /// offset); `set` names the axes that it is asked for.
  void touch(std::size_t index, const Vec3& machine_mm, const Vec3& work_mm,
             const std::array<bool, 3>& set);
  /// G92 and G52.
  void set_g92(int axis, double offset_mm);
  void cancel_g92(bool forget);  ///< G92.1, G92.2
  void restore_g92();            ///< G92.3

 private:
  std::vector<CoordinateSystem> systems_;
  std::size_t active_ = 0;
  Vec3 g92_mm_, saved_g92_mm_;
  bool g92_applies_ = false, g92_was_set_ = false, frame_is_taken_ = true;
};

}  // namespace limitgauge::model::gcode
