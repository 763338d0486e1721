#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "model/geometry/vec3.h"
#include "verifier/cutter/body_ref.h"
#include "verifier/cutter/near_leaves.h"

namespace limitgauge::verifier {

/// What searches close to each other need not ask again: passes that are not near, since from a
/// place that was `clear_mm` away from all of a pass, no place is nearer to it than that less the
/// way between; and the body that was nearest last, with which the next search begins. Whoever
/// searches keeps it, for one space and one thread; it changes no answer.
class FarPasses {
 public:
  /// How much further than asked a pass is looked for: the cells that searches begin with are as
  /// wide.
  static constexpr double kFurther_mm = 0.3;

  /// A lower bound of d over all of the pass; below all distances where nothing is known.
  double bound(std::uint32_t pass, const model::Vec3& p) const;
  void learn(std::uint32_t pass, const model::Vec3& p, double clear_mm);
  /// Whether it pays to look further than asked: not beside a pass that was found to be near.
  bool pays(std::uint32_t pass, const model::Vec3& p) const;
  /// What is known of a pass that is near, in its own frame.
  NearLeaves& near(std::uint32_t pass);

  std::optional<BodyRef> last;  ///< the body that was nearest last

 private:
  struct Room {
    model::Vec3 at;
    double clear_mm = 0;
    bool known = false;
  };
  std::vector<Room> rooms_;
  std::vector<NearLeaves> near_;
};

}  // namespace limitgauge::verifier
