#pragma once

#include <optional>
#include <span>
#include <vector>

#include "simulator/sweep/cutter_profile.h"
#include "tests/defects/surfaces/sampled_surface.h"

namespace limitgauge::tests::defects {

/// Whether a cutter can touch a place without gouging: by setting it there and looking for a place
/// of S that is too near. Between the two sure answers lies the tolerance of contact that the
/// verifier states, and what its definition leaves open (how the tool goes on above the flutes).
enum class Reach { no, maybe, sure };

/// Reach of S by any of several cutters at a distance: the cutter stands where its contact has the
/// given normal, and the whole tool keeps the distance from all of S.
class ReachOracle {
 public:
  ReachOracle(const SampledSurface& surface, std::span<const model::Cutter> cutters,
              double allowance_mm);
  /// Where only a sure answer is of use, the search for a possible one is left out.
  Reach at(const model::Vec3& point, const model::Vec3& normal, Reach least = Reach::maybe) const;

 private:
  struct Body {
    simulator::CutterProfile profile;
    double lift_mm = 0;
    double radius_mm = 0, top_mm = 0;  ///< over the tip
  };
  struct Tool {
    std::vector<Body> bodies;  ///< the flutes first; the last one goes up endlessly
    double flat_mm = 0, rounding_mm = 0, wall_sine = 0;
    bool neck = false;
  };
  static Tool tool_of(const model::Cutter& cutter, double above_mm);
  Reach with(const Tool& tool, const model::Vec3& point, const model::Vec3& normal,
             Reach least) const;
  Reach widest(const Tool& tool, const model::Vec3& core) const;
  Reach standing(const Tool& tool, const model::Vec3& tip, Reach least) const;
  /// The least distance of S from some of the bodies, as far as it is less than `enough`.
  double clearance(std::span<const Body> bodies, const model::Vec3& tip, double enough) const;

  const SampledSurface& surface_;
  double allowance_ = 0;
  std::vector<Tool> tools_;
};

}  // namespace limitgauge::tests::defects
