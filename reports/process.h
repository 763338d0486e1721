#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "simulator/finding.h"

namespace limitgauge::reports {

/// Findings of `kinds`.
std::size_t count(std::span<const simulator::Finding> findings,
                  std::initializer_list<simulator::FindingKind> kinds);
/// Findings that fail a stage.
std::size_t faults(std::span<const simulator::Finding> findings);
/// The kinds that result.json lists as holder collisions.
bool is_holder_collision(simulator::FindingKind kind);
/// What one kind is, in words for people: "rapid through standing material".
const char* words_for(simulator::FindingKind kind);

}  // namespace limitgauge::reports
