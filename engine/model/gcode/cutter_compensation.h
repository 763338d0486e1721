#pragma once

#include <deque>
#include <functional>
#include <optional>

#include "engine/model/error.h"
#include "engine/model/program.h"

namespace limitgauge::model::gcode {

enum class CompensationSide { left, right };  ///< G41, G42

/// Cutter radius compensation in the active plane as LinuxCNC carries it out: the path that keeps
/// the cutter beside the programmed contour. The first move enters (a straight one, or an arc by
/// LinuxCNC's rule), corners are rounded outside by an arc about the contour's corner and cut short
/// inside where the offsets meet, G40 leaves with the next straight move. Motions come in and go
/// out in the active work frame. A contour that cannot be followed (an arc tighter inside than the
/// radius, an inner corner too short for the cutter) throws InputError at the motion's line.
class CutterCompensation {
 public:
  using Out = std::function<void(const Motion&)>;
  /// `place` gives the place in the program of a motion's line, for errors.
  using Place = std::function<SourcePlace(std::uint32_t line)>;

  CutterCompensation(Out out, Place place);

  bool active() const;
  /// G41 or G42. `radius_mm` may be negative: the other side. `position_mm` is where the tool is.
  void begin(CompensationSide side, double radius_mm, ArcPlane plane, const Vec3& position_mm);
  /// G40: what waits is let out; the next move leaves the contour.
  void end();
  /// A programmed motion; while no compensation is on it goes straight through.
  void move(const Motion& motion);
  /// Lets out what waits for its next neighbour: at the end of the program, and before what a
  /// contour cannot run through.
  void flush();
};

}  // namespace limitgauge::model::gcode
