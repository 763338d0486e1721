#pragma once

#include <optional>
#include <utility>

#include "model/part/cage.h"

namespace limitgauge::app {

/// The first two faces, or one twice, that have the same corners in opposite order: there the
/// surface lies back on itself, faces both ways and bounds nothing, so that what is gouge on one
/// side is uncut on the other. Corners are the same within kLeastLengthMm. Holes do not count.
std::optional<std::pair<model::Index, model::Index>> folded_faces(const model::Cage& cage);

}  // namespace limitgauge::app
