#include "simulator/stock/material.h"

#include <utility>

namespace limitgauge::simulator {
namespace {

MaterialSample from_pass(std::uint32_t pass, const NearestMove& n) {
  return {-n.at.distance, -n.at.gradient, {pass, n.slot}};
}

}  // namespace

Material Material::after(std::shared_ptr<const SweepIndex> pass) const {
  Material next = *this;
  next.passes_.push_back(std::move(pass));
  return next;
}

MaterialSample Material::sample_of(SurfaceMaker maker, const model::Vec3& p) const {
  if (maker.pass == 0) {
    const RawSample raw = raw_distance(raw_, p);
    return {raw.distance, raw.gradient, {}};
  }
  const SweepIndex& pass = *passes_[maker.pass - 1];
  return from_pass(maker.pass, {maker.slot, pass.distance(maker.slot, p)});
}

MaterialSample Material::sample(const model::Vec3& p, SurfaceMaker guess) const {
  MaterialSample best = sample_of({}, p);
  if (guess.pass > 0) {
    const MaterialSample guessed = sample_of(guess, p);
    if (guessed.value > best.value) best = guessed;
  }
  for (std::uint32_t pass = 1; pass <= passes_.size(); ++pass)
    if (const auto found = passes_[pass - 1]->nearest(p, -best.value))
      best = from_pass(pass, *found);
  return best;
}

}  // namespace limitgauge::simulator
