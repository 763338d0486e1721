#pragma once

#include <optional>
#include <vector>

#include "model/gcode/cycles/cutter_compensation.h"
#include "model/gcode/machine/machine_state.h"
#include "model/gcode/text/parameters.h"
#include "model/gcode/text/statement.h"

namespace limitgauge::model::gcode {

/// Modal state saved by M70 and M73 for the running subroutine, brought back by M72, and behind its
/// end where M73 saved it; M71 drops it. What LinuxCNC saves: units, plane, distance and feed
/// modes, F, S, spindle, coolant, coordinate system, return level, cutter compensation and length
/// offset as far as G40, G49 and G43 bring them back; the motion mode stays. The feed rate comes
/// back exactly (LinuxCNC: to one decimal). Source: linuxcnc.org, "M70 Save Modal State" and on.
class SavedStates {
 public:
  SavedStates(MachineState& state, CutterCompensation& compensation, const Parameters& parameters)
      : state_(state), compensation_(compensation), parameters_(parameters) {}

  bool empty() const { return saved_.empty(); }
  /// M70 to M73.
  void carry_out(const Statement& statement);
  /// Brings back what was saved by M73 in calls that have ended. False where that cannot be done;
  /// it is still to do then.
  bool leave_calls();
  /// The error for what leave_calls() cannot do.
  [[noreturn]] static void fail(const Statement& statement, const Word& word);

 private:
  struct Saved {
    std::size_t depth = 0, call = 0;
    bool returns = false;  ///< by M73
    ModalState modal;
    Spindle spindle;
    Coolant coolant;
    std::size_t system = 0;
  };
  bool restore(const Saved& saved);
  Saved* current();

  MachineState& state_;
  CutterCompensation& compensation_;
  const Parameters& parameters_;
  std::vector<Saved> saved_;  // by rising depth
};

}  // namespace limitgauge::model::gcode
