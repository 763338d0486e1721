#pragma once

#include <string>
#include <vector>

#include "model/part/cage.h"
#include "tests/defects/bench.h"
#include "tests/defects/orientations/lying.h"

namespace limitgauge::tests::defects {

/// One part, one cutter and one way to lie: an unharmed twin, and what is planted there.
struct LyingPlan {
  std::string surface_name;
  model::Cage cage;  ///< nominal: as the rows are laid, the tool along +Z
  model::Cutter cutter;
  double step_mm = 0, allowance_mm = 0;
  int across = 0;
  Holding holding = Holding::still;
  std::vector<LyingKind> kinds;
  unsigned seed = 0;
};

/// What one job came to.
struct LyingResult {
  std::string label;  ///< part, cutter, how it lies
  Holding holding = Holding::still;
  bool harmed = false;
  LyingKind kind{};
  double size = 0;  ///< degrees or mm; 0 where the kind goes by none
  unsigned seed = 0;
  SideResult gouge, uncut;
  std::string verdict;       ///< of the job
  bool gate_raised = false;  ///< of a twin: to what the oracle holds possible
  std::string process;       ///< what the simulator found on the way, if anything
  std::string broken;        ///< what must never be: no result, a contradiction
  double seconds = 0;

  bool due() const { return gouge.due || uncut.due; }
  bool missed() const {
    return harmed &&
           (verdict != "fail" || (gouge.due && !gouge.failed) || (uncut.due && !uncut.failed));
  }
  bool false_alarm() const { return !harmed && verdict == "fail"; }
  bool located() const {
    return (!gouge.due || (gouge.located && gouge.named)) && (!uncut.due || uncut.located);
  }
  bool contained() const { return gouge.contained && uncut.contained; }
  bool good() const {
    return broken.empty() && !missed() && located() && contained() && (harmed || verdict == "pass");
  }
};

}  // namespace limitgauge::tests::defects
