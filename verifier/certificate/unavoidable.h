#pragma once

#include <optional>
#include <span>

#include "verifier/gate/deviation.h"
#include "verifier/reach/reach_map.h"
#include "verifier/tolerance.h"

namespace limitgauge::verifier {

struct UnavoidableOptions {
  /// The interval is narrowed to this, or to `share` of its upper end where that is more.
  double resolution_mm = kUnavoidable_mm;
  double share = 0.02;
  /// Ends of the effort; the interval stays valid, and wider, where one is met.
  std::size_t largest_cell_count = 100'000;    ///< cells of S looked at
  std::size_t largest_point_count = 1'000;     ///< points of S a better position was searched for
  std::size_t largest_square_count = 100'000;  ///< squares of tip positions in the lower bound
};

/// What no toolpath with this cutter can remove.
struct Unavoidable {
  Interval uncut_mm;                  ///< certified; never below zero
  std::optional<SurfacePlace> place;  ///< the point of S that `low` was proven for
  bool reached_resolution = false;
  std::size_t cells = 0, points = 0, squares = 0;
};

/// The unavoidable uncut: the largest, over all points s of S, of
///   min over the gouge-free positions T of d(s − T), less the allowance,
/// d being the distance to the fluted part, and gouge-free as in `Reachability` (the wall goes up
/// without end; no closer than the allowance less the contact tolerance). At a point that can be
/// touched it is not above zero, so only the others count. Proofs: CERTIFICATE.md, section 4.
///
/// `map` must be of the same `cells`, and `reachability`, of `cutter`, the one that stands at
/// `cutter_index` among those it was made with. All
/// `free_tips` must be proven gouge-free with a contact tolerance no larger than that of
/// `reachability`; more of them save time; where there are none, they
/// are searched for. The same for any number of threads.
Unavoidable unavoidable_uncut(const SurfaceCells& cells, const ReachMap& map,
                              const Reachability& reachability,
                              std::span<const model::Vec3> free_tips, const model::Cutter& cutter,
                              const UnavoidableOptions& options, const model::RunControl& control,
                              std::size_t cutter_index = 0);

}  // namespace limitgauge::verifier
