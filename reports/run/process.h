#pragma once

#include <array>
#include <cstddef>
#include <initializer_list>
#include <span>

#include "simulator/process/finding.h"

namespace limitgauge::reports {

/// In the order of result.json.
inline constexpr std::array kFindingKinds = {
    simulator::FindingKind::rapid_through_stock, simulator::FindingKind::shank_in_stock,
    simulator::FindingKind::holder_in_stock,     simulator::FindingKind::fixture_touched,
    simulator::FindingKind::spindle_stopped,     simulator::FindingKind::feed_missing,
    simulator::FindingKind::below_flutes,        simulator::FindingKind::steep_descent,
    simulator::FindingKind::cut_while_turning,   simulator::FindingKind::beyond_travel,
    simulator::FindingKind::slight_contact,      simulator::FindingKind::near_miss};

/// Findings of `kinds`.
std::size_t count(std::span<const simulator::Finding> findings,
                  std::initializer_list<simulator::FindingKind> kinds);
/// Moves that have a finding of `kind`: one that touches two clamps is one. Findings are in the order
/// of moves.
std::size_t moves_with(std::span<const simulator::Finding> findings, simulator::FindingKind kind);
/// Findings that fail a stage.
std::size_t faults(std::span<const simulator::Finding> findings);
/// The kinds that result.json lists as holder collisions.
bool is_holder_collision(simulator::FindingKind kind);
/// What one kind is, in words for people: "rapid through standing material".
const char* description(simulator::FindingKind kind);

}  // namespace limitgauge::reports
