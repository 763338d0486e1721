#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "engine/surface/section/section_chain.h"
#include "engine/tolerance.h"
#include "model/part/cutter.h"

namespace limitgauge::engine::strategy {

using model::Vec3;

/// Which bodies of a cutter keep clear: the fluted part alone, or shank and holder too.
enum class Assembly { flutes, whole };

/// The cutter location surface of a cutter over triangles: how low the tip may go so that the
/// fluted part, continued upwards, grown by an allowance in every direction, touches nothing.
///
/// The grown cutter is convex, so over each triangle the lowest tip height is a concave function
/// of (x, y); the surface is the greatest of these. Heights are exact for the triangles but for
/// `kHeightError_mm`, never below the truth. Const queries may run in parallel.
class CutterLocations {
 public:
  /// Two triangles a cell of every grid, split as surface::Grid says. `allowance_mm` holds the
  /// distance to be kept and the error of the triangles. Throws std::invalid_argument for a
  /// cutter that is none or a negative allowance.
  CutterLocations(std::vector<surface::Grid> grids, const model::Cutter& cutter,
                  double allowance_mm, Assembly assembly = Assembly::whole);

  /// Lowest height of the tip over (x, y), mm; nothing where no triangle is under the cutter.
  std::optional<double> tip_z(double x, double y) const;
  /// The same where that is above `least_mm`, nothing elsewhere: the faster, the less it is above.
  std::optional<double> tip_z_above(double x, double y, double least_mm) const;

  /// By how much the straight move of the tip from `a` to `b` must be lifted to touch nothing:
  /// negative by how much it might sink; nothing where no triangle is under it. Exact over the
  /// whole move, not at samples, but for kHeightError_mm; never below the truth.
  std::optional<double> lift(const Vec3& a, const Vec3& b) const;
  /// The same where that is above `least_mm`, nothing elsewhere: the faster, the less it is above.
  std::optional<double> lift_above(const Vec3& a, const Vec3& b, double least_mm) const;
  /// Whether the move needs no lift beyond `slack_mm` (faster than lift()).
  bool clears(const Vec3& a, const Vec3& b, double slack_mm) const;

  /// XY extent of where tip_z is anything, and the greatest height in it.
  const model::Box3& extent() const;
  /// The same of the fluted part alone: beyond it shank or holder are all that touches.
  const model::Box3& fluted_extent() const;

 private:
  struct Tree;
  std::shared_ptr<const Tree> tree_;
};

}  // namespace limitgauge::engine::strategy
