#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "engine/strategy/locations/envelope.h"

namespace limitgauge::engine::strategy {

/// A straight line that is no vertical.
struct Line {
  PlanePoint at;
  double slope = 0;
  double height(double s) const { return at.z + slope * (s - at.s); }
};

/// All straight lines that pass below some points and above others, which come in ascending s
/// (O'Rourke 1981). Two of them bound the rest: the steepest touches a lower point on its left and
/// an upper one on its right, the least steep the other way round. Amortised constant time a point.
class LinkFan {
 public:
  enum class Turn { up, down };

  /// The line must pass at or below, at or above `p`. The points must leave a line.
  void add_upper(const PlanePoint& p);
  void add_lower(const PlanePoint& p);
  /// Which way the lines would have to turn to pass between `lower` and `upper`, both at one s
  /// right of all points; nothing where one of them passes.
  std::optional<Turn> misses(const PlanePoint& upper, const PlanePoint& lower) const;

  const Line& steepest() const { return *steepest_; }
  const Line& least() const { return *least_; }
  /// Where the steepest (turn up) or least steep line (turn down) touches last.
  const PlanePoint& last_touch(Turn turn) const {
    return turn == Turn::up ? last_upper_ : last_lower_;
  }
  /// A line well inside.
  Line middle() const;

 private:
  /// The points of one kind that may still be touched, as a convex chain; `touched` is the one that
  /// bounds the fan now.
  struct Chain {
    std::vector<PlanePoint> points;
    std::size_t touched = 0;
  };
  /// Least (side 1) or greatest (side -1) slope of lines from the chain to `p`.
  static std::optional<double> tangent(Chain& chain, const PlanePoint& p, double side);
  static void append(Chain& chain, const PlanePoint& p, double side);

  Chain uppers_, lowers_;
  std::optional<Line> steepest_, least_;
  PlanePoint last_upper_, last_lower_;
};

}  // namespace limitgauge::engine::strategy
