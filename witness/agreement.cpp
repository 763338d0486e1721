#include "witness/agreement.h"

#include <algorithm>
#include <cmath>
#include <sstream>

#include "model/base/clock.h"
#include "witness/bounds.h"
#include "witness/far_refinement.h"
#include "witness/limit_points.h"
#include "witness/star_limit.h"
#include "witness/tolerance.h"

namespace limitgauge::witness {
namespace {

using model::Cage;
using model::Vec3;

int levels_for(std::size_t patches, int most) {
  int levels = 1;
  for (std::size_t faces = 16 * patches; levels < most && faces <= kMostFaces; faces *= 4) ++levels;
  return levels;
}

class Comparison {
 public:
  Comparison(const Cage& cage, const SurfaceUnderTest& surface, int most_levels)
      : cage_(cage), surface_(surface), most_levels_(most_levels) {}

  Agreement result() {
    found_.evaluator = evaluator_name();
    found_.levels = levels_for(static_cast<std::size_t>(surface_.patch_count()), most_levels_);
    found_.bound_mm =
        bounds_of(cage_, found_.levels + static_cast<int>(model::kInfiniteSharpness) + kStarSteps)
            .position_mm();
    try {
      hold_against(limit_points(cage_, {found_.levels, kMostRefined}));
    } catch (const CageRefused& refused) {
      contradict(std::string("cannot be held against each other: ") + refused.what());
    }
    return found_;
  }

 private:
  void hold_against(const LimitPoints& limits) {
    found_.points_left_out = limits.left_out;
    if (have_the_same_patches(limits))
      for (const LimitPoint& p : limits.points) compare(p);
  }

  bool have_the_same_patches(const LimitPoints& limits) {
    const auto count = static_cast<int>(limits.has_surface.size());
    if (count != surface_.patch_count())
      contradict("have " + std::to_string(surface_.patch_count()) + " and " +
                 std::to_string(count) + " patches");
    for (int patch = 0; patch < count && !found_.contradiction; ++patch)
      if (surface_.has_surface(patch) != limits.has_surface[patch])
        contradict("do not agree whether patch " + std::to_string(patch) + " has a surface");
    return !found_.contradiction;
  }

  void compare(const LimitPoint& p) {
    const SurfaceUnderTest::Sample sample = surface_.evaluate(p.patch, p.u, p.v);
    ++found_.points;
    if (!p.by_mask) ++found_.by_refinement;
    const double apart_mm = distance(sample.position, p.position);
    if (!(apart_mm <= found_.worst_mm)) {  // what is no number is worst
      found_.worst_mm = apart_mm;
      found_.worst_at = {p.patch, p.u, p.v, p.position};
    }
    if (!(apart_mm <= found_.bound_mm)) contradict(p, apart_mm, "mm", found_.bound_mm);
    compare_normals(p, sample);
  }

  void compare_normals(const LimitPoint& p, const SurfaceUnderTest::Sample& sample) {
    const double bound_rad =
        p.normal && sample.normal ? p.normal->turn_per_mm * found_.bound_mm : 2 * kSteady_rad;
    if (!(bound_rad <= kSteady_rad)) {
      ++found_.normals_left_out;
      return;
    }
    ++found_.normals;
    const double angle = angle_between(*sample.normal, p.normal->along);
    found_.normal_bound_rad = std::max(found_.normal_bound_rad, bound_rad);
    if (!(angle <= found_.worst_normal_rad)) found_.worst_normal_rad = angle;
    if (!(angle <= bound_rad)) contradict(p, angle, "rad between their normals", bound_rad);
  }

  void contradict(const LimitPoint& p, double apart, const char* unit, double bound) {
    std::ostringstream what;
    what << "differ by " << apart << ' ' << unit << " at (" << p.position.x << ", " << p.position.y
         << ", " << p.position.z << "), patch " << p.patch << ", u " << p.u << ", v " << p.v
         << "; no more than " << bound << " can come of rounding";
    contradict(what.str());
  }
  /// The first one stands for all.
  void contradict(const std::string& how) {
    if (!found_.contradiction) found_.contradiction = how;
  }

  const Cage& cage_;
  const SurfaceUnderTest& surface_;
  int most_levels_ = kMostLevels;
  Agreement found_;
};

}  // namespace

Agreement hold_against(const Cage& cage, const SurfaceUnderTest& surface, int most_levels) {
  const model::Stopwatch watch;
  Agreement found = Comparison(cage, surface, most_levels).result();
  found.seconds = watch.seconds();
  return found;
}

}  // namespace limitgauge::witness
