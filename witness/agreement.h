#pragma once

#include <cstddef>
#include <optional>
#include <string>

#include "model/part/cage.h"

namespace limitgauge::witness {

/// A surface that is held against OpenSubdiv, by the patches of its cage (see LimitPoint).
class SurfaceUnderTest {
 public:
  virtual ~SurfaceUnderTest() = default;
  struct Sample {
    model::Vec3 position;
    std::optional<model::Vec3> normal;  ///< unit; none where no tangent plane is
  };
  virtual int patch_count() const = 0;
  virtual bool has_surface(int patch) const = 0;
  virtual Sample evaluate(int patch, double u, double v) const = 0;
};

/// How far a surface and OpenSubdiv's agree on one cage.
struct Agreement {
  std::string evaluator;  ///< "OpenSubdiv 3.5.0"
  int levels = 0;         ///< of uniform refinement, whose vertices' limits were compared
  std::size_t points = 0;
  std::size_t by_refinement = 0;    ///< of the points: no limit mask, refinement was followed
  std::size_t points_left_out = 0;  ///< of those without a mask, beyond `kMostRefined`
  double worst_mm = 0, bound_mm = 0;
  struct Place {
    int patch = 0;
    double u = 0, v = 0;
    model::Vec3 point;
  };
  std::optional<Place> worst_at;  ///< none where all are equal to the bit

  std::size_t normals = 0;
  std::size_t normals_left_out = 0;  ///< at sharp edges, corners, ends, and folds
  /// Each normal is held against a bound of its own; here is the widest.
  double worst_normal_rad = 0, normal_bound_rad = 0;

  /// Why the two do not show the same surface; empty: they agree within the bounds.
  std::optional<std::string> contradiction;
  double seconds = 0;
};

/// Levels are as many as give no more faces than this, four at most and one at least: there is no
/// cap for a cage of more patches than a sixteenth of this, whose quads have nine points each.
inline constexpr std::size_t kMostFaces = 65'536;
inline constexpr int kMostLevels = 4;
/// Vertices without a limit mask (ends of creases, valence two, sharpness not yet used up).
inline constexpr std::size_t kMostRefined = 4096;

/// Holds `surface` against the limits of `cage` by OpenSubdiv's Far, in double precision. The same
/// result every time, but for `seconds`. A cage that OpenSubdiv refuses is a contradiction as well.
/// `most_levels` of them, 1 to kMostLevels: with one, patches are compared at their corners.
Agreement hold_against(const model::Cage& cage, const SurfaceUnderTest& surface,
                       int most_levels = kMostLevels);

}  // namespace limitgauge::witness
