#pragma once

#include <vector>

#include "engine/model/cutter.h"
#include "simulator/swept_distance.h"

namespace limitgauge::simulator {

enum class ToolPart { cutter, shank, holder };
const char* name(ToolPart part);

/// A convex body of a tool assembly, its base `base_mm` above the tip.
struct ToolBody {
  ToolPart part = ToolPart::cutter;
  CutterProfile profile;
  double base_mm = 0;

  /// `move` is of the tip.
  SweptMove of_tip(const SweptMove& move) const {
    const model::Vec3 from = move.start + model::Vec3{0, 0, base_mm};
    return {from, from + move.delta, move.index};
  }
};

/// The bodies that a cutter's assembly is taken apart into.
struct ToolBodies {
  /// `height_mm` is how far above the tip material may stand.
  ToolBodies(const model::Cutter& cutter, double height_mm);

  ToolBody flutes;
  std::vector<ToolBody> above;  ///< shank and holder parts, from the flutes up
  double top_radius_mm;         ///< of the flutes where they end
  /// Cylinders of the flutes' top radius at the heights, up to `height_mm`, where the stated
  /// assembly is narrower than that or ends: material in them stands above the flutes within the
  /// cutter's own radius. A part as wide as the flutes' top or wider speaks for itself.
  std::vector<ToolBody> over_flutes;

  /// Whether a part above the flutes is as wide as their top or wider.
  bool is_wide(const ToolBody& body) const;
  /// Whether the flutes are nowhere wider than at their top.
  bool widest_at_top() const;
};

}  // namespace limitgauge::simulator
