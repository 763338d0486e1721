#pragma once

#include <cstddef>

#include "model/base/run_control.h"
#include "simulator/process/turning/turn_effort.h"
#include "simulator/process/turning/turning_body.h"
#include "simulator/stock/material.h"

namespace limitgauge::simulator {

/// A search that takes more is given up, after some seconds. A turn that comes near nothing takes
/// dozens, one that slides along a face some hundreds.
inline constexpr std::size_t kMostTurnLooks = 1'000'000;

/// What a turn's searches look through: `body` among `solid`, which stands still in the frame that
/// `pose` leads to, from t = `from` to `to`. Of the solid is gone what the moves of `pass` below
/// `end` sweep, where there is one.
struct TurnSearch {
  const Material* solid = nullptr;
  MovingShape body;
  const TurningPose* pose = nullptr;
  double from = 0, to = 1;  ///< may be the same
  std::size_t most_looks = kMostTurnLooks;
  const SweepIndex* pass = nullptr;
  std::uint32_t end = 0;

  MaterialAtMove material() const { return {solid, pass, end}; }
};

/// The deepest place of the body in the solid; none if it is nowhere deeper than `tolerance_mm`.
/// Branch and bound over blocks of space and stretches of time. The promises are those of
/// deepest_contact (contact_search.h): what is deeper than 1.5 tolerances is never missed, and the
/// depth is a lower bound. Throws Interrupted.
TurnAnswer deepest_turn_contact(const TurnSearch& search, double tolerance_mm,
                                const model::RunControl& control);

/// The least distance between the body and the solid, if it is below `within_mm`. The promises are
/// those of least_gap (gap_search.h): of the solid counts what has room for a ball of half a
/// tolerance's radius; the distance is never too small, and at most a tolerance too large next to
/// faces and right-angled edges. Throws Interrupted.
TurnAnswer least_turn_gap(const TurnSearch& search, double within_mm, double tolerance_mm,
                          const model::RunControl& control);

}  // namespace limitgauge::simulator
