#pragma once

#include <cmath>
#include <optional>
#include <string>
#include <utility>

#include "model/gcode/program.h"
#include "model/geometry/vec2.h"
#include "model/text/number_text.h"

namespace limitgauge::model::gcode {

/// As atan2 has it, a vector without length points along the first axis.
inline Vec2 unit(Vec2 p) {
  const double l = length(p);
  return l > 0 ? p / l : Vec2{1, 0};
}

/// The plane's axes in space.
class PlaneFrame {
 public:
  explicit PlaneFrame(ArcPlane plane = ArcPlane::xy) : plane_(plane) {}

  ArcPlane plane() const { return plane_; }
  Vec2 flat(const Vec3& point) const {
    const auto [first, second, normal] = axes_of(plane_);
    return {point[first], point[second]};
  }
  /// `height` gives the coordinate along the plane's normal.
  Vec3 lifted(Vec2 point, const Vec3& height) const {
    const auto [first, second, normal] = axes_of(plane_);
    Vec3 lifted = height;
    lifted[first] = point.x;
    lifted[second] = point.y;
    return lifted;
  }

 private:
  ArcPlane plane_;
};

/// How far an arc about `centre` turns from `from` to `to`, radians, counter-clockwise positive;
/// `turns` as Motion's. Equal ends are a full turn.
double sweep_of(Vec2 from, Vec2 to, Vec2 centre, double turns);

enum class Corner { smooth, outer, inner };

/// Which bends are no corner, and what a contour that goes back along itself comes to.
struct CornerRule {
  double smooth_rad = 0;    ///< a bend by this or less is none
  double reversal_rad = 0;  ///< a reversal within it is outer, unless:
  bool reversal_is_inner = false;
};

/// What a contour that comes along `before` and goes on along `after` (unit directions) is for a
/// tool on `side` of it (1: left, -1: right).
Corner corner_of(Vec2 before, Vec2 after, double side, const CornerRule& rule);

/// Straight corners outside: where the path along `before` ends and the one along `after` begins,
/// one place unless the contour turns by more than 90 degrees. The paths beside the contour would
/// end and begin at `beside` and `to`.
std::pair<Vec2, Vec2> outer_corner(Vec2 before, Vec2 after, Vec2 beside, Vec2 to, double radius_mm);

/// Where two straight paths meet that run beside their lines at `radius_mm`: `beside` is where the
/// first one ends uncut, over the corner.
Vec2 meet_lines(Vec2 before, Vec2 after, Vec2 beside, double radius_mm);

/// A path at constant distance from an arc.
struct OffsetArc {
  Vec2 centre;
  double radius_mm = 0;
  bool tool_inside = false;
};

/// Where the straight path that runs along `direction` at `height_mm` over the arc's centre, along
/// `normal`, meets the arc: the later place for an arc that the tool runs inside of, the earlier
/// one outside, or the other way round where the arc comes before the line. Empty where they do not
/// meet.
std::optional<Vec2> meet_line_and_arc(const OffsetArc& arc, Vec2 direction, Vec2 normal,
                                      double height_mm, bool arc_comes_first);

/// Where `before` meets `after`, which turns counter-clockwise or not. Empty where they do not
/// meet; their centres differ.
std::optional<Vec2> meet_arcs(const OffsetArc& before, const OffsetArc& after,
                              bool after_is_counter_clockwise);

}  // namespace limitgauge::model::gcode
