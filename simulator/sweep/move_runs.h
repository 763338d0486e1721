#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "model/part/toolpath.h"

namespace limitgauge::simulator {

/// Consecutive moves of a path that belong together, by where each run begins.
class MoveRuns {
 public:
  /// `begins(i)` says whether a run begins at move i.
  template <class Begins>
  MoveRuns(std::size_t moves, const Begins& begins) : moves_(moves) {
    for (std::size_t i = 0; i < moves; ++i)
      if (begins(i)) begins_.push_back(static_cast<std::uint32_t>(i));
  }

  /// Where the run that holds `move` begins; of a move before all runs itself.
  std::size_t begin(std::size_t move) const;
  /// One past the run's last move.
  std::size_t end(std::size_t move) const;

 private:
  std::size_t moves_;
  std::vector<std::uint32_t> begins_;
};

/// Runs of moves of one kind in one direction: a straight line that a program may have in pieces.
/// Moves of no length belong to any direction.
MoveRuns straight_runs(const model::Toolpath& path);

/// Runs of neighbouring moves for which `offends(i)`.
template <class Offends>
MoveRuns series_of(std::size_t moves, const Offends& offends) {
  bool within = false;
  return MoveRuns(moves, [&](std::size_t i) {
    const bool before = within;
    within = offends(i);
    return within && !before;
  });
}

/// A feed move for which the program gave no feed.
bool lacks_feed(const model::Move& move);

/// Neighbouring moves that may not touch material, each series for one reason.
struct IdleSeries {
  explicit IdleSeries(const model::Toolpath& path);

  MoveRuns rapids, spindle_stopped, without_feed;
};

}  // namespace limitgauge::simulator
