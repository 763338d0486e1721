#pragma once

#include "app/job/job.h"

namespace limitgauge::app {

/// The job with a stage for each stretch of a program during which its rotary axes stand still, and
/// a setup for each way in which they do: what is not turned stays as it was. The last stretch
/// that cuts keeps the stage's name and limits; the others are called NAME.1, NAME.2 and so on by
/// their place and are gated on gouge alone, where they cut: what they leave the next may take.
/// Reads the programs. Throws InputError as reading them does, for a program with more stretches
/// than kMostPieces, and for what does not go with turned parts.
Job oriented(Job job);

/// A program that turns its axes more often turns them while it cuts.
inline constexpr std::size_t kMostPieces = 200;

}  // namespace limitgauge::app
