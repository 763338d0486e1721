#include "model/gcode/cycles/cutter_compensation_queue.h"

#include <numbers>

#include "model/text/number_text.h"

namespace limitgauge::model::gcode {
namespace {

/// LinuxCNC's slack for an arc that was cut short beyond its start, radians; it is stated in the
/// program's length unit there.
constexpr double kSlackMm = 0.0254;
constexpr double kSlackInch = 0.001;

std::string degrees(double radians) {
  return six_digits(std::abs(radians) * 180 / std::numbers::pi) + " degrees";
}

}  // namespace

void CompensationQueue::push(const PlaneFrame& frame, const WaitingMotion& waiting) {
  if (waiting_.size() >= kMostWaiting)
    fail(waiting.motion,
         "more than " + std::to_string(kMostWaiting) +
             " moves at one point of a contour with cutter compensation",
         "a move along the contour");
  if (waiting_.empty()) {
    leading_arc_.reset();
    if (waiting.motion.kind == MotionKind::arc) leading_arc_ = waiting.motion;
  }
  waiting_.push_back(waiting);
  waiting_.back().motion.plane = frame.plane();
}

void CompensationQueue::release() {
  for (const WaitingMotion& waiting : waiting_) out_(waiting.motion);
  waiting_.clear();
  start_.reset();
}

void CompensationQueue::release_at(const PlaneFrame& frame, Vec2 end) {
  if (waiting_.empty()) return;
  for (WaitingMotion& waiting : waiting_) move_end(frame, waiting, end);
  release();
  starts_at(end);
}

void CompensationQueue::move_end(const PlaneFrame& frame, WaitingMotion& waiting, Vec2 end) const {
  Motion& motion = waiting.motion;
  motion.to = frame.lifted(end, motion.to);
  if (!start_) return;
  if (motion.kind == MotionKind::arc) {
    const double sweep = sweep_of(*start_, end, {motion.centre1, motion.centre2}, motion.turns);
    const double slack = inches_ ? kSlackInch : kSlackMm;
    if (std::abs(sweep) > std::abs(waiting.sweep) + slack)
      fail(motion,
           "the cutter would have to turn " + degrees(sweep) + " along an arc of " +
               degrees(waiting.sweep),
           "smooth corners, or inner ones that leave the cutter room");
  } else if (dot(waiting.direction, end - *start_) < 0) {
    fail(motion, "a straight move too short for the cutter in its inner corners",
         "inner corners that leave the cutter room");
  }
}

void CompensationQueue::fail(const Motion& motion, const std::string& wrong,
                             const std::string& expected) const {
  throw InputError(place_(motion.line), wrong, expected);
}

}  // namespace limitgauge::model::gcode
