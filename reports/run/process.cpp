#include "reports/run/process.h"

#include <algorithm>

namespace limitgauge::reports {

using simulator::Finding;
using simulator::FindingKind;

std::size_t count(std::span<const Finding> findings, std::initializer_list<FindingKind> kinds) {
  return static_cast<std::size_t>(
      std::count_if(findings.begin(), findings.end(), [&](const Finding& f) {
        return std::find(kinds.begin(), kinds.end(), f.kind) != kinds.end();
      }));
}

std::size_t moves_with(std::span<const Finding> findings, FindingKind kind) {
  std::size_t moves = 0;
  const Finding* last = nullptr;
  for (const Finding& f : findings) {
    if (f.kind != kind) continue;
    if (!last || last->move != f.move) ++moves;
    last = &f;
  }
  return moves;
}

std::size_t faults(std::span<const Finding> findings) {
  return static_cast<std::size_t>(std::count_if(findings.begin(), findings.end(),
                                                [](const Finding& f) { return fails(f.kind); }));
}

bool is_holder_collision(FindingKind kind) {
  return kind == FindingKind::shank_in_stock || kind == FindingKind::holder_in_stock;
}

const char* description(FindingKind kind) {
  switch (kind) {
    case FindingKind::rapid_through_stock:
      return "rapid through standing material";
    case FindingKind::shank_in_stock:
      return "shank in the material";
    case FindingKind::holder_in_stock:
      return "holder in the material";
    case FindingKind::fixture_touched:
      return "fixture touched";
    case FindingKind::spindle_stopped:
      return "cut with the spindle at rest";
    case FindingKind::feed_missing:
      return "feed move without a feed rate";
    case FindingKind::below_flutes:
      return "cut deeper than the flutes";
    case FindingKind::steep_descent:
      return "descent too steep for the cutter";
    case FindingKind::cut_while_turning:
      return "cut while rotary axes turn";
    case FindingKind::beyond_travel:
      return "beyond the travel limits";
    case FindingKind::slight_contact:
      return "contact within the tolerance";
    case FindingKind::near_miss:
      break;
  }
  return "near miss";
}

}  // namespace limitgauge::reports
