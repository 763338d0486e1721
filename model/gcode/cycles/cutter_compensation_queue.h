#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "model/base/error.h"
#include "model/gcode/cycles/cutter_compensation_plane.h"
#include "model/gcode/program.h"

namespace limitgauge::model::gcode {

/// A compensated motion whose end in the plane may still move.
struct WaitingMotion {
  Motion motion;
  Vec2 direction;    ///< of a straight one as programmed; no length: it may go anywhere
  double sweep = 0;  ///< of an arc as programmed, radians
};

/// Motions that wait for the corner at their end: the last one in the plane and those along the
/// plane's normal behind it, which end over the same point.
class CompensationQueue {
 public:
  using Out = std::function<void(const Motion&)>;
  using Place = std::function<SourcePlace(std::uint32_t line)>;

  /// More than these wait only in a program that never leaves the point; it is refused, so that the
  /// memory held here stays below 150 MiB.
  static constexpr std::size_t kMostWaiting = 1000000;

  CompensationQueue(Out out, Place place) : out_(std::move(out)), place_(std::move(place)) {}

  std::size_t size() const { return waiting_.size(); }
  bool empty() const { return waiting_.empty(); }
  /// The arc that the queue begins with or, where it is empty, began with when it was let out last.
  const std::optional<Motion>& leading_arc() const { return leading_arc_; }

  /// Throws InputError at a motion beyond kMostWaiting.
  void push(const PlaneFrame& frame, const WaitingMotion& waiting);
  /// A motion that nothing changes any more, behind those let out.
  void pass(const Motion& motion) const { out_(motion); }
  /// Lets all out as they are; where the next one starts is not known until starts_at().
  void release();
  /// Lets all out with `end` for their end in the plane, which becomes the start of the next one.
  /// Throws InputError where a motion would have to run backwards to get there.
  void release_at(const PlaneFrame& frame, Vec2 end);
  /// Where the next motion starts.
  void starts_at(Vec2 start) { start_ = start; }
  void use_inches(bool inches) { inches_ = inches; }

 private:
  void move_end(const PlaneFrame& frame, WaitingMotion& waiting, Vec2 end) const;
  [[noreturn]] void fail(const Motion& motion, const std::string& wrong,
                         const std::string& expected) const;

  Out out_;
  Place place_;
  std::vector<WaitingMotion> waiting_;
  std::optional<Motion> leading_arc_;
  std::optional<Vec2> start_;  // empty: an entry arc, or what waited was let out early
  bool inches_ = false;
};

}  // namespace limitgauge::model::gcode
