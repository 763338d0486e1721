#pragma once

#include <array>
#include <optional>

#include "engine/model/gcode/statement.h"
#include "engine/model/program.h"

namespace limitgauge::model::gcode {

/// Carries out the blocks of a program in RS274/NGC's order of execution and keeps its canonical
/// motions. Power-on state as LinuxCNC's: G17 G21 G40 G49 G54 G80 G90 G91.1 G94, no feed rate; axes
/// never programmed stand at 0 and are not known.
class Interpreter {
 public:
  explicit Interpreter(Program& program) : program_(program) {}

  /// Returns false when the block ends the program (M2, M30).
  bool execute(const Statement& statement);

 private:
  void list_ignored(const Statement& statement);
  void list_messages(const Block& block);
  void check_companions(const Statement& statement) const;
  void set_feed(const Statement& statement);
  void change_tool(const Statement& statement);
  void set_spindle(const Statement& statement);
  void set_modes(const Statement& statement);
  std::optional<int> motion_of(const Statement& statement) const;
  void move(const Statement& statement, int code);
  Vec3 end_of(const Statement& statement);
  void arc(const Statement& statement, bool counter_clockwise, Motion& motion) const;
  std::array<double, 2> centre_words(const Statement& statement) const;
  double turns(const Statement& statement) const;
  void add_ignored(std::uint32_t line, std::string word);

  Program& program_;
  Vec3 position_mm_;
  std::array<bool, 3> known_{};
  double unit_mm_ = 1;
  double feed_mm_min_ = 0;
  ArcPlane plane_ = ArcPlane::xy;
  bool incremental_ = false, centre_absolute_ = false;
  std::optional<int> motion_mode_;
  std::optional<double> selected_tool_, loaded_tool_;
  std::optional<bool> spindle_on_;  // empty: no word of it yet
  bool speed_is_zero_ = false;
  std::size_t motions_before_spindle_ = 0;
};

}  // namespace limitgauge::model::gcode
