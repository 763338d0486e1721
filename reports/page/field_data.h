#pragma once

#include "reports/page/surface_data.h"

namespace limitgauge::reports::page {

/// What a shown sample says of its place, as flags.
inline constexpr std::uint8_t kUnreachable = 1, kRawStock = 2, kFromNearby = 4;

/// Index in the field of the sample whose values each shown sample carries, in the page's order:
/// its own; of a thinned grid, where a sample that it stands for is deeper than a threshold of
/// findings, the deepest of those. No place beyond a limit thus gets lost from the map, and places
/// within the limits show what was measured there.
std::vector<std::size_t> carried_samples(const verifier::StageDeviation& deviation,
                                         const PageGrid& grid);

/// "field" of a stage on surface number `surface`.
Json field_data(const verifier::StageDeviation& deviation, const PageGrid& grid,
                std::size_t surface, Blob& blob);

}  // namespace limitgauge::reports::page
