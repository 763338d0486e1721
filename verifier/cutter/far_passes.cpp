#include "verifier/cutter/far_passes.h"

#include <limits>

#include "verifier/tolerance.h"

namespace limitgauge::verifier {

using model::Vec3;

double FarPasses::bound(std::uint32_t pass, const Vec3& p) const {
  if (pass >= rooms_.size() || !rooms_[pass].known) return -std::numeric_limits<double>::infinity();
  const Room& room = rooms_[pass];
  return room.clear_mm - distance(room.at, p) - kDistanceRounding_mm;
}

void FarPasses::learn(std::uint32_t pass, const Vec3& p, double clear_mm) {
  if (pass >= rooms_.size()) rooms_.resize(pass + 1);
  rooms_[pass] = {p, clear_mm, true};
}

NearLeaves& FarPasses::near(std::uint32_t pass) {
  if (pass >= near_.size()) near_.resize(pass + 1);
  return near_[pass];
}

bool FarPasses::pays(std::uint32_t pass, const Vec3& p) const {
  if (pass >= rooms_.size() || !rooms_[pass].known) return true;
  const Room& room = rooms_[pass];
  return room.clear_mm > kFurther_mm / 4 || distance(room.at, p) > kFurther_mm;
}

}  // namespace limitgauge::verifier
