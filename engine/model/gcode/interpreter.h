#pragma once

#include <optional>

#include "engine/model/gcode/assumptions.h"
#include "engine/model/gcode/machine_state.h"
#include "engine/model/gcode/statement.h"
#include "engine/model/program.h"

namespace limitgauge::model::gcode {

/// Carries out the blocks of a program in LinuxCNC's order of execution and keeps its canonical
/// motions. Axes never programmed stand at 0 and are not known.
class Interpreter {
 public:
  /// `most_motions` bounds what loops and cycles may expand to.
  Interpreter(Program& program, const MachineSetup& machine, std::size_t most_motions);

  /// Returns false when the block ends the program (M2, M30).
  bool execute(const Statement& statement);
  const MachineState& state() const { return state_; }

 private:
  bool is_plain(const Statement& statement) const;
  void move_plainly(const Statement& statement);
  void set_spindle_mode(const Statement& statement);
  void set_speed(const Statement& statement);
  void turn_spindle(const Statement& statement);
  void set_modes(const Statement& statement);
  void set_late_modes(const Statement& statement);
  void carry_out_non_modal(const Statement& statement);
  void go_home(const Statement& statement);
  void move(const Statement& statement, int code);
  void emit(const Statement& statement, Motion motion);
  void count_motion(const Statement& statement) const;

  Program& program_;
  Assumptions assumed_;
  MachineState state_;
  std::size_t most_motions_;
  std::size_t motions_before_spindle_ = 0;
  bool plain_ = false;  ///< blocks of axis words alone may go by move_plainly
};

}  // namespace limitgauge::model::gcode
