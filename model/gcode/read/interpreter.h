#pragma once

#include <optional>

#include "model/gcode/cycles/canned_cycle.h"
#include "model/gcode/cycles/cutter_compensation.h"
#include "model/gcode/machine/machine_state.h"
#include "model/gcode/machine/saved_state.h"
#include "model/gcode/program.h"
#include "model/gcode/read/assumptions.h"
#include "model/gcode/text/parameters.h"
#include "model/gcode/text/plain_line.h"
#include "model/gcode/text/statement.h"

namespace limitgauge::model::gcode {

/// Carries out the blocks of a program in LinuxCNC's order of execution and keeps its canonical
/// motions. Axes never programmed stand where the machine's start has them, or at 0, and are not
/// known.
class Interpreter {
 public:
  /// The machine's own parameters are given to `parameters`, which like `lexer` outlives this and
  /// is not read after it. `most_motions` bounds what loops and cycles may expand to.
  Interpreter(Program& program, const MachineSetup& machine, const Lexer& lexer,
              Parameters& parameters, std::size_t most_motions);
  Interpreter(const Interpreter&) = delete;
  Interpreter& operator=(const Interpreter&) = delete;

  /// Rounds what variables and expressions give to what the control's increments can say, where it
  /// does so.
  void round_calculated(Block& block);
  /// Returns false when the block ends the program (M2, M30).
  bool execute(const Statement& statement);
  /// Carries out a line of the main program that calls, loops and jumps have nothing to do with.
  /// False where more of it must be known than where it leads; nothing has been done then.
  bool move_plainly(const PlainLine& line);
  /// Whether move_plainly may take the next line.
  bool goes_plainly() const { return plain_; }
  /// At the end of the program: lets out the motions that cutter compensation still holds.
  void finish();

 private:
  void set_system_parameters(Parameters& parameters, const ControlRules& rules);
  bool is_plain(const Statement& statement) const;
  bool may_be_plain() const;
  bool keeps_modes(const PlainLine& line) const;
  std::optional<Vec3> plain_end(const PlainLine& line) const;
  Motion plain_motion(const Vec3& to_mm);
  bool listen(const Statement& statement);
  void note_least_increments(std::uint32_t line, bool calculated);
  void note_doubtful_lengths(const Statement& statement);
  void cancel_cycle(const Statement& statement);
  void note_return_level(const Statement& statement);
  void note_hole_axis(const Statement& statement);
  void note_pecks(const Statement& statement, int code);
  void move_plainly(const Statement& statement);
  void carry_out_m(const Statement& statement);
  void carry_out_g(const Statement& statement, std::optional<int> motion);
  void watch_still_blocks(const Statement& statement, const Vec3& from_mm);
  bool stop(const Statement& statement);
  void set_spindle_mode(const Statement& statement);
  void set_speed(const Statement& statement);
  void turn_spindle(const Statement& statement);
  void pause_spindle(const Statement& statement, int code);
  void set_coolant(const Statement& statement);
  void check_polar_plane(const Statement& statement) const;
  void set_plane(const Statement& statement);
  void set_units(const Statement& statement);
  void set_late_modes(const Statement& statement);
  void note_taken_modes(const Statement& statement);
  void carry_out_non_modal(const Statement& statement);
  void go_home(const Statement& statement);
  void move_home(const Statement& statement);
  void move(const Statement& statement, int code);
  void move_straight(const Statement& statement, int code);
  void cycle(const Statement& statement, int code);
  void tap(const Statement& statement, int code);
  SpindleState spindle_state() const;
  void note_spindle(const Motion& motion);

  bool turns(const Statement& statement) const;
  void check_turn(const Statement& statement, std::optional<int> motion) const;
  void note_frame();
  bool keeps_height(double z_mm) const;
  void note_named(const Statement& statement);
  void list_turn(const Statement& statement, const Motion& motion, const TurningMotion& turn);
  void turn(const Statement& statement, int code);
  double minutes_of(const Statement& statement, const Motion& motion, double way_mm,
                    const TurningMotion& turn) const;
  void turn_in_joints(const Statement& statement, const RotaryAngles& to_deg, bool rapid);
  void set_tip_control(const Statement& statement);
  void go_to(const Statement& statement, const Vec3& to_mm, const RotaryAngles& to_deg, bool rapid);
  RotaryAngles turn_home(const Statement& statement, const RotaryAngles& by_deg);
  void check_park(const Statement& statement, bool was_parked, const RotaryAngles& to_deg) const;
  /// Does `work` while places move X, Y and Z of the machine, whatever the control makes of them.
  template <typename Work>
  void in_joints(const Work& work) {
    if (!state_.orientation.transforms()) return work();
    const Orientation modes = state_.orientation;
    state_.keeping_tool([&] {
      state_.orientation.tool_centred = state_.orientation.dynamic_offset = false;
      state_.orientation.plane.reset();
    });
    work();
    state_.keeping_tool([&] {
      state_.orientation.tool_centred = modes.tool_centred;
      state_.orientation.dynamic_offset = modes.dynamic_offset;
      state_.orientation.plane = modes.plane;
    });
  }
  template <typename Work>
  void in_joints_if(bool joints, const Work& work) {
    if (joints) return in_joints(work);
    work();
  }

  void emit(const Statement& statement, Motion motion);
  void send(std::uint32_t line, Motion& motion);
  void put(Motion& motion);
  void to_machine(Motion& motion) const;
  void check_count(const Statement& statement) const;
  std::size_t motions_so_far() const { return program_.motions.size() + compensation_.waiting(); }

  Program& program_;
  Assumptions assumed_;
  MachineState state_;
  const CoordinateSystems systems_at_start_;
  const ToolTable tools_at_start_;
  std::uint32_t offsets_line_ = 0;  ///< of the last code that set some
  CutterCompensation compensation_;
  SavedStates saved_;
  CannedCycles cycles_;
  std::size_t most_motions_;
  std::size_t motions_before_spindle_ = 0;
  /// Blocks since the last motion beside a contour; empty: there was none.
  std::optional<int> still_blocks_;
  bool doubts_lengths_ = false;   ///< lengths without a point are still to be told of
  bool doubts_decimals_ = false;  ///< and such with more decimals than the control takes
  bool lack_of_speed_is_told_ = false;
  bool left_hand_is_told_ = false;
  bool plain_ = false;  ///< blocks of axis words alone may go by move_plainly
};

}  // namespace limitgauge::model::gcode
