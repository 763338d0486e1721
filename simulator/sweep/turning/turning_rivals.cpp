#include "simulator/sweep/turning/turning_rivals.h"

#include <algorithm>
#include <numeric>

#include "simulator/tolerance.h"

namespace limitgauge::simulator {
namespace {

using model::Vec3;

// Below this, more rivals take more time than the moves that they would set aside.
constexpr std::size_t kFewTurning = 6;

double plane_at(const BatchSamples& s, std::uint32_t i, const Vec3& step) {
  return s.distance[i] - s.sag[i] + s.gx[i] * step.x + s.gy[i] * step.y + s.gz[i] * step.z;
}

}  // namespace

void TurningRivals::keep(const SweepTree& pass, const MoveBatch& moves, const BatchSamples& samples,
                         const Vec3& middle, double half_edge_mm, double half_diagonal_mm,
                         std::vector<std::uint32_t>& kept) {
  middle_ = middle, half_diagonal_ = half_diagonal_mm;
  for (std::size_t k = 0; k < corners_.size(); ++k)
    corners_[k] = Vec3{k & 4 ? 1.0 : -1.0, k & 2 ? 1.0 : -1.0, k & 1 ? 1.0 : -1.0} * half_edge_mm;
  const auto& d = samples.distance;
  kept.resize(d.size());
  std::iota(kept.begin(), kept.end(), 0U);
  const auto nearest = static_cast<std::uint32_t>(std::min_element(d.begin(), d.end()) - d.begin());
  drop(samples, rival(pass, moves, samples, nearest), nearest, kept);
  std::array<std::uint32_t, 9> met{nearest};
  std::size_t count = 1;
  for (std::size_t k = 0; k < corners_.size() && kept.size() > kFewTurning; ++k) {
    const std::uint32_t low = lowest_at(samples, k, kept);
    if (std::find(met.begin(), met.begin() + count, low) != met.begin() + count) continue;
    met[count++] = low;
    drop(samples, rival(pass, moves, samples, low), low, kept);
  }
}

TurningRivals::Corners TurningRivals::rival(const SweepTree& pass, const MoveBatch& moves,
                                            const BatchSamples& samples,
                                            std::uint32_t place) const {
  const SweptSample at{samples.distance[place], {}, samples.t[place]};
  Corners values;
  for (std::size_t k = 0; k < values.size(); ++k)
    values[k] = pass.convex_part(moves.slot[place], at, middle_ + corners_[k]).distance;
  return values;
}

std::uint32_t TurningRivals::lowest_at(const BatchSamples& samples, std::size_t corner,
                                       std::span<const std::uint32_t> kept) const {
  return *std::min_element(kept.begin(), kept.end(), [&](std::uint32_t a, std::uint32_t b) {
    return plane_at(samples, a, corners_[corner]) < plane_at(samples, b, corners_[corner]);
  });
}

void TurningRivals::drop(const BatchSamples& samples, const Corners& rival, std::uint32_t own,
                         std::vector<std::uint32_t>& kept) const {
  const double most = *std::max_element(rival.begin(), rival.end());
  std::erase_if(kept, [&](std::uint32_t i) {
    if (i == own) return false;
    if (samples.distance[i] - half_diagonal_ > most + kDistanceRounding_mm) return true;
    for (std::size_t k = 0; k < corners_.size(); ++k)
      if (plane_at(samples, i, corners_[k]) <= rival[k] + kDistanceRounding_mm) return false;
    return true;
  });
}

}  // namespace limitgauge::simulator
