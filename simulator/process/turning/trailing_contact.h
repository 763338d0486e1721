#pragma once

#include <cstddef>

#include "model/part/toolpath.h"
#include "simulator/process/turning/turn_search.h"

namespace limitgauge::simulator {

/// A move of a pass whose tool turns as it goes. What stands while it goes is what the pass's moves
/// before it left, less what its own flutes have swept by then.
struct TurningCut {
  const model::Pass* pass = nullptr;
  std::size_t move = 0;
};

/// As deepest_turn_contact, of a part above the flutes of `cut`, against what stands when the part
/// gets there: `search` is one of the solid before the move. What the flutes come to only later is
/// met (simulator/PROOFS.md, P13). The move is halved in time until what its flutes sweep within a
/// stretch decides nothing, so that what is deeper than 1.5 tolerances is never missed. All
/// stretches together take no more than the search's looks. Throws Interrupted.
TurnAnswer trailing_contact(const TurnSearch& search, const TurningCut& cut, double tolerance_mm,
                            const model::RunControl& control);

}  // namespace limitgauge::simulator
