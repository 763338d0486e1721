#pragma once

#include "app/job/job.h"

namespace limitgauge::app {

/// The job with a stage for each stretch of a program during which its rotary axes stand still, and
/// a setup for each way in which they do: what is not turned stays as it was. The last stretch
/// that cuts keeps the stage's name and limits; the others are called NAME.1, NAME.2 and so on by
/// their place and are gated on gouge alone, where they cut: what they leave the next may take.
/// A stage that cuts while its axes turn (model::cuts_while_turning), or has more stretches than
/// kMostPieces, stays one, in its setup, with the tool turning in the part as it goes.
/// Reads the programs. Throws InputError as reading them does, and for what does not go with turned
/// parts.
Job oriented(Job job);

/// A stage in whose program the axes stand still more often is not taken apart.
inline constexpr std::size_t kMostPieces = 200;

}  // namespace limitgauge::app
