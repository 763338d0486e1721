#pragma once

#include <string>
#include <vector>

#include "model/gcode/turning/turning_path.h"

namespace limitgauge::model::test {

inline constexpr double kReach_mm = 70;

/// C on A, both off the machine's zero.
inline MachineSetup turning_trunnion(Control control = Control::fanuc) {
  MachineSetup machine;
  machine.control = control;
  machine.tools = {{1, 80, 6}};
  machine.loaded_tool = 1;
  machine.work_offsets[0] = WorkOffset{{10, 20, -30}, 0};
  machine.start_mm = Vec3{0, 0, 200};
  machine.kinematics =
      Kinematics{MachineKind::table_table,
                 {{'A', {1, 0, 0}, {3, -7, -60}, -120, 120}, {'C', {0, 0, 1}, {5, 2, -30}}}};
  return machine;
}

inline MachineSetup turning_heads() {
  MachineSetup machine = turning_trunnion();
  machine.kinematics =
      Kinematics{MachineKind::head_head,
                 {{'C', {0, 0, 1}, {0, 0, 200}}, {'B', {0, 1, 0}, {0, 1, 150}, -110, 110}}};
  return machine;
}

inline MachineSetup turning_head_table() {
  MachineSetup machine = turning_trunnion();
  machine.kinematics =
      Kinematics{MachineKind::head_table,
                 {{'B', {0, 1, 0}, {0, 1, 150}, -110, 110}, {'C', {0, 0, 1}, {5, 2, -30}}}};
  return machine;
}

inline PathOptions turning_options(const MachineSetup& machine, double chord_error_mm = 0.001) {
  PathOptions options;
  options.chord_error_mm = chord_error_mm;
  options.machine_in_part = {90, {7, 8, 9}};
  options.start_mm = Vec3{10, 20, 170};
  options.kinematics = machine.kinematics;
  options.reach_mm = kReach_mm;
  options.around_mm = {{-50, -50, -50}, {50, 50, 50}};
  return options;
}

inline std::vector<std::size_t> moves_of(const TurningPath& made, std::uint32_t line) {
  std::vector<std::size_t> moves;
  for (std::size_t i = 0; i < made.path.moves.size(); ++i)
    if (made.path.moves[i].line == line) moves.push_back(i);
  return moves;
}

inline const std::string kApproach = "G21 G90 G94 G43 H1\nG0 X0 Y0 Z100\n";
inline const std::string kCentred = "G21 G90 G94\nG43.4 H1\nG0 X0 Y0 Z100\n";

}  // namespace limitgauge::model::test
