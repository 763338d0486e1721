#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "model/part/toolpath.h"
#include "simulator/instrument/dexel_removal.h"

namespace limitgauge::reports::page {

/// A toolpath has at most so many segments on a page.
inline constexpr std::size_t kMostSegments = 40'000;

/// A toolpath as a page draws it: consecutive moves joined to straight segments where there are too
/// many of them.
struct PathView {
  struct Segment {
    model::Vec3 to;
    model::MoveKind kind = model::MoveKind::rapid;  ///< feed where any of its moves is
    float feed_mm_min = 0;             ///< of moves of several feeds their mean in time
    float rate_mm3_min = 0;            ///< material removed over the segment's time
    std::uint32_t line = 0, move = 0;  ///< of its last move
    double end_s = 0;                  ///< machining time when it is done
  };
  model::Vec3 start;
  std::vector<Segment> segments;
  /// How the tool stands where each segment ends, in between along the great circle; empty of a
  /// tool that stands along +Z.
  std::vector<model::Vec3> axes;
  model::Vec3 start_axis{0, 0, 1};
  std::size_t moves = 0;       ///< of the path
  double within_mm = 0;        ///< no tip of a move is further from its segment
  double axis_within_deg = 0;  ///< where a move ends, no axis is further from its segment's arc
  bool has_rates = false;      ///< what the moves removed is known
};

struct PathViewOptions {
  double rapid_mm_min = 0;
  /// The whole path's. The time of each move, its length at the programmed feed, is scaled so that
  /// they add up to it; 0: as programmed.
  double machining_time_s = 0;
  std::size_t most_segments = kMostSegments;
  const model::ToolAxes* axes = nullptr;  ///< of a path that turns its tool
};

/// `path` in at most `most_segments` (no less than 1). Moves of one kind and feed are joined where
/// the tips stay within a distance of the segment that joins them; the distance grows until they
/// fit; of a path that turns its tool, within an angle that grows along. Beyond a 500th of the
/// path's extent moves of different feeds are joined as well, beyond a 50th rapids with feeds.
/// Takes a few passes over the moves, each linear but for the logarithm of a segment's moves.
PathView path_view(const model::Toolpath& path, std::span<const simulator::MoveRemoval> removal,
                   const PathViewOptions& options);

}  // namespace limitgauge::reports::page
