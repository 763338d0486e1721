#pragma once

#include <vector>

#include "engine/strategy/locations/envelope.h"

namespace limitgauge::engine::strategy {

/// A polyline of few points that stays within `error_mm` of `line` everywhere, with the same ends;
/// `line` goes on in ascending s or straight up and down.
///
/// The line is cut into pieces that are flat (functions z(s)) and steep (functions s(z)). Within a
/// piece the tunnel of points up to `error_mm` above and below is a polygon whose ends the result
/// joins by the least number of straight links (greedily by the farthest visible window: Suri 1986,
/// Imai and Iri 1986), in linear time. Points of the result may lie anywhere in the tunnel, which
/// takes 1/√2 of the points that chords between points of the curve would take.
///
/// Bound: at every s (or z) the two differ by at most `error_mm` along z (or s), so each point of
/// either has one of the other within `error_mm`. Distance to a surface changes by no more than the
/// way one moves: a cutter on the result goes deeper than on `line` by at most `error_mm`, and
/// leaves at most that much more.
std::vector<PlanePoint> least_links(const std::vector<PlanePoint>& line, double error_mm);

}  // namespace limitgauge::engine::strategy
