#include "simulator/stock/local_material.h"

#include <algorithm>
#include <cmath>

#include "simulator/sweep/vector_loops.h"
#include "simulator/tolerance.h"

namespace limitgauge::simulator {
namespace {

using model::Vec3;

LIMITGAUGE_WIDE
void find_planes(const double* __restrict d, const double* __restrict gx,
                 const double* __restrict gy, const double* __restrict gz, std::size_t n,
                 const Vec3& to, double* __restrict plane) {
  const double x = to.x, y = to.y, z = to.z;
  for (std::size_t i = 0; i < n; ++i) plane[i] = d[i] + (gx[i] * x + gy[i] * y + gz[i] * z);
}

// By how much the depth at the middle may rise above its tangent within `reach`.
double bend_of(const Material& material, const MaterialSample& s, const Vec3& p, double reach) {
  if (s.maker.pass == 0) return 2 * reach;
  const SweepIndex& pass = *material.passes()[s.maker.pass - 1];
  const SweptSample at = pass.distance(s.maker.slot, p);
  return curvature_bound(pass.profile(), pass.move(s.maker.slot), p, at, reach);
}

}  // namespace

LocalMaterial::LocalMaterial(const Material& material, const Vec3& middle, double half_edge_mm)
    : material_(material),
      middle_(middle),
      half_edge_(half_edge_mm),
      half_diagonal_(std::sqrt(3.0) * half_edge_mm) {
  const MaterialSample at_middle = material.sample(middle);
  const double bend = bend_of(material, at_middle, middle, half_diagonal_);
  for (std::uint32_t pass = 0; pass < material.passes().size(); ++pass)
    take_pass(pass, at_middle, bend);
  plane_.resize(moves_.size());
}

void LocalMaterial::take_pass(std::uint32_t pass, const MaterialSample& at_middle, double bend) {
  const SweepIndex& index = *material_.passes()[pass];
  const double depth = -at_middle.value, far = 2 * half_diagonal_ + kDistanceRounding_mm;
  slots_.clear();
  index.gather(middle_, depth + far, slots_);
  for (const std::uint32_t slot : slots_) {
    if (cannot_be_below(index.profile(), index.move(slot), middle_, depth + far)) continue;
    const SweptSample s = index.distance(slot, middle_);
    const double turn = norm1(s.gradient + at_middle.gradient);
    if (s.distance - depth > std::min(far, half_edge_ * turn + bend + kDistanceRounding_mm))
      continue;
    moves_.push_back({pass + 1, slot});
    distance_.push_back(s.distance);
    gx_.push_back(s.gradient.x), gy_.push_back(s.gradient.y), gz_.push_back(s.gradient.z);
  }
}

bool LocalMaterial::contains(const Vec3& p) const {
  const Vec3 q = p - middle_;
  return std::abs(q.x) <= half_edge_ && std::abs(q.y) <= half_edge_ && std::abs(q.z) <= half_edge_;
}

MaterialSample LocalMaterial::sample(const Vec3& p, SurfaceMaker guess) {
  if (!contains(p)) return material_.sample(p, guess);
  MaterialSample best = material_.sample_of({}, p);
  if (guess.pass > 0) {
    const MaterialSample guessed = material_.sample_of(guess, p);
    if (guessed.value > best.value) best = guessed;
  }
  find_planes(distance_.data(), gx_.data(), gy_.data(), gz_.data(), moves_.size(), p - middle_,
              plane_.data());
  for (std::size_t i = 0; i < moves_.size(); ++i) {
    if (plane_[i] >= -best.value + kSameDistance_mm) continue;
    const MaterialSample s = material_.sample_of(moves_[i], p);
    if (s.value > best.value) best = s;
  }
  return best;
}

}  // namespace limitgauge::simulator
