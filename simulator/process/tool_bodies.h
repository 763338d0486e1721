#pragma once

#include <vector>

#include "model/part/cutter.h"
#include "simulator/sweep/swept_distance.h"

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

/// The bodies that a cutter's assembly is taken apart into. The parts of an assembly are one body,
/// whatever pieces it is stated in:
///  - how deep a place lies in the material does not depend on the part that reaches it, so that
///    against stock the deepest of the parts is the deepest of the assembly;
///  - how deep a place lies in the assembly does: a thin slice is nowhere deeper than half its
///    thickness. Parts of one kind and diameter that follow each other are one cylinder, and
///    `joined` are cylinders through several parts.
struct ToolBodies {
  /// `height_mm` is how far above the tip material may stand.
  ToolBodies(const model::Cutter& cutter, double height_mm);

  ToolBody flutes;
  std::vector<ToolBody> above;  ///< shank and holder parts, from the flutes up
  double top_radius_mm;         ///< of the flutes where they end
  /// Of each part, where it has neighbours that are no narrower (the flutes too, above their nose),
  /// the cylinder of its radius through all of them; and the flutes through parts no narrower.
  ///
  /// All lie in the assembly, so that a depth in one of them is none too large. Nor is it much too
  /// small: a ball of radius r in the assembly, its middle (ρ, z) in the meridian, shows that at
  /// all heights within r/√2 of z the assembly is ρ + r/√2 wide at least. So the cylinder of that
  /// radius between those heights lies in the assembly, and, above the nose, in the cylinder of the
  /// narrowest part there: (ρ, z) is at least r/√2 deep in it, and exactly r where all are of one
  /// diameter.
  std::vector<ToolBody> joined;
  /// What material may not meet above the flutes beside parts as wide as their top or wider, which
  /// speak for themselves: the narrower parts, which may stand under a ledge as a T-slot cutter's
  /// neck does, and where the stated assembly ends, up to `height_mm`, a cylinder of the flutes'
  /// top radius.
  std::vector<ToolBody> over_flutes;

  /// The flutes, then what is above them.
  std::vector<ToolBody> parts() const;
  /// Whether a part above the flutes is as wide as their top or wider.
  bool is_wide(const ToolBody& body) const;
  /// Whether it is no wider than anything between it and the flutes, nor than their top: straight
  /// down, it comes to nothing but where they have been.
  bool trails(const ToolBody& body) const;
  /// Whether the flutes are nowhere wider than at their top.
  bool widest_at_top() const;
  /// The part at a height above the tip; beyond the last part, that one.
  ToolPart part_at(double height_mm) const;

 private:
  void join_parts(const model::Cutter& cutter);
};

}  // namespace limitgauge::simulator
