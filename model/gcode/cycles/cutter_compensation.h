#pragma once

#include <cstddef>
#include <string>

#include "model/base/error.h"
#include "model/gcode/control/control_rules.h"
#include "model/gcode/cycles/cutter_compensation_queue.h"
#include "model/gcode/program.h"

namespace limitgauge::model::gcode {

enum class CompensationSide { left, right };  ///< G41, G42

/// Cutter radius compensation in the active plane as LinuxCNC 2.9 carries it out: the path that
/// keeps the cutter beside the programmed contour. The first motion enters: a straight one ends
/// beside its programmed end, an arc gets another radius and ends there too. Outer corners are
/// rounded by an arc of the cutter's radius about the contour's corner (a rapid cuts it straight),
/// inner corners cut short where the offsets meet; a change of direction by less than 0.05 radians
/// is taken as smooth and left as it is. CompensationStyle says what others do instead. After G40
/// the next motion, which must be straight, goes to its programmed end. Motions come in and go out
/// in the active work frame; those put in at a corner carry line, feed rate and flags of the motion
/// behind it.
///
/// Throws InputError at a motion's line where the contour cannot be followed: an entry no longer
/// than the radius, an arc no wider than the cutter inside it, an inner corner that the cutter does
/// not fit into, an arc right after G40. As in LinuxCNC only neighbours are looked at: a slot
/// narrower than the cutter gouges, and so does a motion that was cut short backwards when the next
/// is a smooth one or an arc round an outer corner.
/// Source: linuxcnc.org, "Cutter Compensation", and its interpreter's moves.
class CutterCompensation {
 public:
  using Out = CompensationQueue::Out;
  using Place = CompensationQueue::Place;

  /// `place` gives the place in the program of a motion's line, for errors.
  CutterCompensation(Out out, Place place);

  /// From begin() to end(), also with a radius of 0, which lets every motion through as it is.
  bool active() const { return stage_ != Stage::off; }
  /// The tool is kept beside what is programmed.
  bool shifts() const { return active() && radius_mm_ != 0; }
  /// Motions need not come through move(): nothing is on, and no rule looks at the next one.
  bool idle() const { return stage_ == Stage::off && !just_left_; }
  /// G41 or G42; the next motion is the entry. `radius_mm` may be negative: the other side.
  /// `position_mm` is where the tool is. Throws std::invalid_argument for G19, which LinuxCNC
  /// refuses, and std::logic_error while active.
  void begin(CompensationSide side, double radius_mm, ArcPlane plane, const Vec3& position_mm,
             CompensationStyle style = CompensationStyle::linuxcnc);
  /// G40: what waits is let out; the next move leaves the contour.
  void end();
  /// The next motion's block names a place in the plane: after G40 it leaves the contour, be that
  /// the contour's own end.
  void name_place() { place_is_named_ = true; }
  /// A programmed motion; while no compensation is on it goes straight through. Arcs lie in the
  /// plane of begin().
  void move(const Motion& motion);
  /// Lets out what waits for its next neighbour, the end of the contour so far being its end: at
  /// the program's end and at M0, M1 and M60. As in LinuxCNC the motion behind starts from there,
  /// into an inner corner too.
  void flush();
  /// Motions that were taken in and not yet let out; they come before the next one's.
  std::size_t waiting() const { return queue_.size(); }
  /// LinuxCNC takes an arc to be cut short beyond its start when it turns by 0.0254 radians more
  /// than programmed under G21, by 0.001 under G20.
  void use_inches(bool inches) { queue_.use_inches(inches); }

 private:
  /// Of `entered` the end of the entry waits for the motion behind it.
  enum class Stage { off, entering, entered, following };

  void pass_beside(Motion motion);
  void enter(const Motion& motion);
  void enter_straight(const Motion& motion);
  void enter_arc(const Motion& motion);
  void follow_straight(const Motion& motion);
  void follow_arc(const Motion& motion);
  /// Between the paths beside two motions; `to` is where the second one's begins.
  void go_to_corner(const Motion& motion, Vec2 after, Vec2 to);
  void round_corner(const Motion& motion, Vec2 to);
  void cut_corner(const Motion& motion, Vec2 after, Vec2 to);
  void pass_straight(Motion motion, Vec2 to);
  Corner corner_to(const Motion& motion, Vec2 after) const;
  Vec2 corner_before(const Motion& motion, Vec2 after) const;
  Vec2 corner_before_line(const Motion& line, Vec2 direction) const;
  Vec2 corner_before_arc(const Motion& arc) const;
  Vec2 corner_of_arcs(const Motion& before, const Motion& arc) const;
  void push_straight(Motion motion, Vec2 direction, Vec2 end);
  void push_arc(Motion arc, Vec2 end, double sweep);

  bool inside(const Motion& arc) const { return arc.turns * side_ > 0; }
  Vec2 tangent_at_start(const Motion& arc) const;
  /// Of the contour so far, at its end.
  Vec2 normal() const { return unit(beside_mm_ - end_mm()); }
  Vec2 direction() const { return -side_ * quarter_turn(normal()); }
  Vec2 end_mm() const { return frame_.flat(programmed_mm_); }
  void check_entry(const Motion& motion) const;
  void check_width(const Motion& arc, double arc_radius_mm) const;
  [[noreturn]] void fail(const Motion& motion, const std::string& wrong,
                         const std::string& expected) const;

  Place place_;
  CompensationQueue queue_;
  Stage stage_ = Stage::off;
  bool just_left_ = false, place_is_named_ = false;
  double side_ = 1;  // 1: the tool is left of the contour, -1: right
  double radius_mm_ = 0;
  PlaneFrame frame_;
  CompensationStyle style_ = CompensationStyle::linuxcnc;
  Vec3 programmed_mm_;  // end of the contour so far; the tool's place while entering
  Vec2 beside_mm_;      // where the tool ends beside it, if nothing cuts it short
};

}  // namespace limitgauge::model::gcode
