#pragma once

#include <cstddef>
#include <vector>

#include "simulator/process/finding.h"
#include "simulator/process/process_limits.h"
#include "simulator/process/turning/turn_meeting.h"
#include "simulator/stock/stock_model.h"

namespace limitgauge::simulator {

/// Checks what bodies that the spindle or a head carries meet along the moves of a pass during
/// which no rotary axis turns. The rules are those of process_check.h.
///
/// Most bodies are far from everything: of many moves at once it is shown that the body, its tip in
/// the middle of all of theirs, keeps farther away than they reach from there. What is left is
/// looked through move by move, against the stock after the move's own flutes have cut, or before
/// where the move goes up.
class CarriedCheck {
 public:
  /// Throws std::invalid_argument for a mesh that bounds no solid.
  CarriedCheck(const StockModel& before, const Pass& pass, const ProcessLimits& limits);

  /// What is wrong, in the order of moves, then of bodies, then of stock and fixtures. The same for
  /// any number of threads. Throws Interrupted.
  std::vector<Finding> findings(const model::RunControl& control) const;

 private:
  struct Thing {
    std::string name;
    Material solid;
  };
  struct Body {
    std::string name;
    MeshSolid solid;
    model::Pose from_tip;
  };
  struct Suspect {
    std::size_t move, body, thing;
  };

  void add_suspects(std::size_t first, std::size_t end, const Suspect& pair,
                    std::vector<Suspect>& suspects, const model::RunControl& control) const;
  bool is_clear(std::size_t first, std::size_t end, const Suspect& pair,
                const model::RunControl& control) const;
  std::vector<Suspect> suspects(const model::RunControl& control) const;
  void look_at(const Suspect& suspect, const SweepIndex* cut_by, std::vector<Finding>& findings,
               const model::RunControl& control) const;

  const Pass& pass_;
  double tolerance_mm_, near_miss_mm_;
  std::vector<Thing> things_;  // the stock, then the fixtures
  std::vector<Body> bodies_;
};

}  // namespace limitgauge::simulator
