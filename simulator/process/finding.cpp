#include "simulator/process/finding.h"

#include <algorithm>

namespace limitgauge::simulator {
namespace {

bool continues(const FindingGroup& group, const Finding& f) {
  return group.last_move + 1 == f.move && group.kind == f.kind && group.part == f.part &&
         group.against == f.against;
}

void extend(FindingGroup& group, const Finding& f) {
  group.last_line = f.line;
  group.last_move = f.move;
  ++group.count;
  if (f.depth_mm > group.worst.depth_mm) group.worst = f;
}

}  // namespace

std::string travel_limit_name(int axis, bool above) {
  return {static_cast<char>('x' + axis), above ? '+' : '-'};
}

const char* name(FindingKind kind) {
  switch (kind) {
    case FindingKind::rapid_through_stock:
      return "rapid_through_stock";
    case FindingKind::shank_in_stock:
      return "shank_in_stock";
    case FindingKind::holder_in_stock:
      return "holder_in_stock";
    case FindingKind::fixture_touched:
      return "fixture_touched";
    case FindingKind::spindle_stopped:
      return "spindle_stopped";
    case FindingKind::feed_missing:
      return "feed_missing";
    case FindingKind::below_flutes:
      return "below_flutes";
    case FindingKind::steep_descent:
      return "steep_descent";
    case FindingKind::cut_while_turning:
      return "cut_while_turning";
    case FindingKind::beyond_travel:
      return "beyond_travel";
    case FindingKind::slight_contact:
      return "slight_contact";
    case FindingKind::near_miss:
      break;
  }
  return "near_miss";
}

std::vector<FindingGroup> group_findings(std::span<const Finding> findings) {
  std::vector<FindingGroup> groups;
  // Groups that the next move may continue: never more than kinds, parts and fixtures.
  std::vector<std::size_t> open;
  for (const Finding& f : findings) {
    std::erase_if(open, [&](std::size_t g) { return groups[g].last_move + 1 < f.move; });
    const auto known = std::find_if(open.begin(), open.end(),
                                    [&](std::size_t g) { return continues(groups[g], f); });
    if (known != open.end()) {
      extend(groups[*known], f);
      continue;
    }
    open.push_back(groups.size());
    groups.push_back({f.kind, f.part, f.against, f.line, f.line, f.move, f.move, 1, f});
  }
  return groups;
}

}  // namespace limitgauge::simulator
