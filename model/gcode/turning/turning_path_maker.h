#pragma once

#include "model/gcode/turning/turning_path.h"

namespace limitgauge::model {

/// Lays the motions of a program that turns rotary axes into the part's frame, one after the other
/// (to_turning_path).
class TurningPathMaker {
 public:
  /// Both must outlive it. Throws std::bad_optional_access without options.kinematics.
  TurningPathMaker(const Program& program, const PathOptions& options);

  TurningPath make();

 private:
  /// What an axis turn, or a chord of an arc that turns, is made into.
  struct Turn {
    const Motion& motion;
    TurningMotion turning;
    double minutes = 0, limit_mm = 0;
  };

  void begin(std::size_t first);
  void change_tool(const TipPlace& tip);
  void enter_frame_of(std::size_t motion);
  void stand(const RotaryAngles& angles_deg);
  Vec3 here() const { return path_.moves.empty() ? path_.start : path_.moves.back().to; }
  Vec3 here_in_workpiece() const { return placed_.point_back(here()); }
  Vec3 placed(const Vec3& named_mm) const { return placed_.point(frame_.point(named_mm)); }
  Vec3 on_machine(const Vec3& named_mm) const;
  Vec3 parked_place(Vec3 machine_mm) const;
  Vec3 raised() const;
  double park_height_mm() const;

  void add(const Motion& motion);
  void add_arc(const Motion& arc);
  void park(const Motion& motion);
  void turn(const AxisTurn& turn, const Motion& motion);
  void turn_arc(const AxisTurn& turn, const Motion& arc);
  void swing(const AxisTurn& turn, const Motion& motion);
  double add_turn(const Turn& turn);
  void add_move(const Motion& motion, const Vec3& part_mm, const Vec3& axis, bool rapid);
  void add_straight(const Motion& motion, const Vec3& part_mm, bool rapid) {
    add_move(motion, part_mm, axis_, rapid);
  }
  void require_room(double moves, std::uint32_t line) const;
  void note_error(double error_mm);

  const Program& program_;
  const PathOptions& options_;
  const Kinematics& machine_;
  Pose placed_;  ///< the workpiece, all axes at zero, in the part's frame
  Pose frame_;   ///< from motions to the workpiece
  RotaryAngles angles_deg_{};
  Vec3 axis_{0, 0, 1};  ///< of the tool, in the part's frame
  Vec3 at_mm_;          ///< in the frame of motions
  bool parked_ = false;
  std::size_t next_frame_ = 0;
  double height_mm_ = 0;  ///< of a parked tool, in the machine's frame
  Toolpath path_;
  ToolAxes axes_;
};

}  // namespace limitgauge::model
