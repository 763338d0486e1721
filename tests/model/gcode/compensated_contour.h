#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "model/gcode/cycles/cutter_compensation.h"
#include "tests/support/catch.h"

namespace limitgauge::model::test {

/// A compensation whose motions are kept; every motion put in gets the next line, from 1.
class CompensatedContour {
 public:
  explicit CompensatedContour(ArcPlane plane = ArcPlane::xy) : plane_(plane) {}

  /// Contours are described in the plane's axes, so that one description serves every plane.
  Vec3 point(double first, double second, double height = 0) const {
    const auto axes = axes_of(plane_);
    Vec3 point;
    point[axes[0]] = first;
    point[axes[1]] = second;
    point[axes[2]] = height;
    return point;
  }
  void begin(gcode::CompensationSide side, double radius_mm, const Vec3& position_mm,
             gcode::CompensationStyle style = gcode::CompensationStyle::linuxcnc) {
    compensation_.begin(side, radius_mm, plane_, position_mm, style);
  }
  void line(double first, double second, double height = 0) {
    add({.kind = MotionKind::feed, .to = point(first, second, height)});
  }
  void rapid(double first, double second, double height = 0) {
    add({.kind = MotionKind::rapid, .to = point(first, second, height)});
  }
  /// Counter-clockwise for positive `turns`, about the absolute centre `c1`, `c2`.
  void arc(double first, double second, double c1, double c2, double turns, double height = 0) {
    add({.kind = MotionKind::arc,
         .to = point(first, second, height),
         .centre1 = c1,
         .centre2 = c2,
         .turns = turns});
  }
  void add(Motion motion) {
    motion.plane = plane_;
    motion.line = ++line_;
    motion.feed_mm_min = static_cast<float>(100 * line_);
    compensation_.move(motion);
  }
  gcode::CutterCompensation& compensation() { return compensation_; }
  const std::vector<Motion>& motions() const { return motions_; }
  std::uint32_t last_line() const { return line_; }

 private:
  ArcPlane plane_;
  std::uint32_t line_ = 0;
  std::vector<Motion> motions_;
  gcode::CutterCompensation compensation_{
      [this](const Motion& motion) { motions_.push_back(motion); },
      [](std::uint32_t line) {
        return SourcePlace{"contour.ngc", static_cast<int>(line), 1};
      }};
};

/// Coordinates here are below 100 mm and come from a handful of operations.
inline constexpr double kRounding = 1e-12;

inline void check_point(const Vec3& point, const Vec3& expected) {
  CAPTURE(point.x, point.y, point.z, expected.x, expected.y, expected.z);
  CHECK(distance(point, expected) < kRounding);
}

inline void check_line(const Motion& motion, const Vec3& to, std::uint32_t line) {
  CHECK(motion.kind == MotionKind::feed);
  CHECK(motion.line == line);
  check_point(motion.to, to);
}

inline void check_arc(const Motion& motion, const Vec3& to, double c1, double c2, double turns,
                      std::uint32_t line) {
  CHECK(motion.kind == MotionKind::arc);
  CHECK(motion.line == line);
  CHECK(motion.turns == turns);
  check_point(motion.to, to);
  check_point({motion.centre1, motion.centre2, 0}, {c1, c2, 0});
}

}  // namespace limitgauge::model::test
