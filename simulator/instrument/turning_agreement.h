#pragma once

#include <cstddef>
#include <optional>

#include "model/base/run_control.h"
#include "simulator/instrument/dexel_agreement.h"

namespace limitgauge::simulator {

/// The second instrument of a pass that turns its tool as it goes, which no lines are cut by: an
/// evaluator of its own says of places whether the cutter comes there, by poses along each move and
/// the meridian that lines have. It shares nothing with the level set's distances.
///
/// `before` are the lines of the stock before the pass, `after` those that were taken from
/// `level_set`, the stock after it (dexels_from), with the same box and spacing. On at most `lines`
/// lines, spread evenly:
///
/// - An end that the pass has made is looked at on both sides of the surface, a micrometre away
///   along φ's gradient (kAgreement_mm) and, where that does not hold, ten times as far and so on:
///   the cutter comes to the outer place and not to the inner one. worst_end_mm is 0, or the
///   nearest distance at which that does not hold.
/// - Other ends: the cutter does not come to the inner place.
/// - The middles of material: there was some before, and the cutter does not come there. Of gaps:
///   there was none, or the cutter comes there. worst_side_mm is the largest |φ| of one that is
///   wrong.
///
/// Nothing is proven by it: a move's poses are kPosesOfMove, more where it turns far (between two
/// of them no place leaves the straight line by more than 0.1 µm), and a golden section about the
/// deepest of them, so that a place inside is never called outside by less than the evaluator
/// misses between two poses, which for a move of length v and turn ω is at most (ω² L + 2 ω v) /
/// 8n² for n poses, L being how far the place is from the tip. Volumes are those of compare_stocks,
/// `after` being no volume of its own. The same for any number of threads. Throws
/// std::invalid_argument for a pass without axes and for lines that are not the same.
StockAgreement compare_turning(const DexelStock& before, const DexelStock& after,
                               const StockModel& level_set, const Pass& pass, std::size_t lines,
                               const model::RunControl& control,
                               std::optional<double> level_set_volume_mm3 = {});

/// Poses at which each move is looked at first, at least.
inline constexpr int kPosesOfMove = 16;

}  // namespace limitgauge::simulator
