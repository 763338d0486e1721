#pragma once

#include <vector>

#include "model/part/cutter.h"

namespace limitgauge::simulator {

/// A convex, non-decreasing function of the radius from 0 to `end()`: straight pieces and arcs that
/// hang below their centres.
class ConvexMeridian {
 public:
  void add_line(double end, double height_at_axis, double slope);
  /// height = centre_height − √(radius² − (ρ − centre_rho)²)
  void add_arc(double end, double centre_rho, double centre_height, double radius);

  double end() const { return pieces_.back().end; }
  double height(double rho) const;
  /// True where height(√(across² + w²)), w >= 0, grows with w at least as fast as `slope`.
  bool steeper(double rho, double w, double slope) const;
  /// The w >= 0 that minimises height(√(across² + w²)) − slope·w within the radius, for slope >= 0
  /// and 0 <= across <= end(). Closed form on straight pieces and on arcs about the axis; on other
  /// arcs by Newton steps within a bracket until w no longer changes.
  double foot(double across, double slope) const;

 private:
  struct Piece {
    double end, height, slope, centre, radius;  // radius 0: a line
  };
  const Piece& piece_at(double rho) const;
  static bool steeper_at(const Piece& piece, double rho, double w, double slope);
  static double foot_in(const Piece& piece, double across, double slope, double w0, double w1);
  std::vector<Piece> pieces_;
};

/// The fluted part of a cutter, tip at the origin, as what lies between two heights at each radius.
/// Worked out from the cutter itself, on its own: the level set's CutterProfile is tested against
/// it.
class DexelProfile {
 public:
  /// Throws std::invalid_argument for a cutter that model::require_valid refuses.
  explicit DexelProfile(const model::Cutter& cutter);

  double largest_radius() const { return lower_.end(); }
  /// Underside and upper side, from 0 to largest_radius(); the upper one is mirrored: minus its
  /// height is convex.
  const ConvexMeridian& lower() const { return lower_; }
  const ConvexMeridian& minus_upper() const { return minus_upper_; }
  /// The lowest height of the upper side: that of the widest place.
  double least_upper() const { return -minus_upper_.height(largest_radius()); }
  double length() const { return length_; }
  bool is_ball() const { return ball_; }

 private:
  ConvexMeridian lower_, minus_upper_;
  double length_ = 0;
  bool ball_ = false;
};

}  // namespace limitgauge::simulator
