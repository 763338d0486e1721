#include "simulator/process/near_material.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "simulator/tolerance.h"

namespace limitgauge::simulator {
namespace {

using model::Vec3;

constexpr std::array<NearCubes, 4> kAboutCells{{{32, 1.0}, {8, 0.75}, {4, 0.5}, {2, 0.25}}};

MaterialSample of_move(std::size_t pass, const NearestMove& n) {
  return {-n.at.distance, -n.at.gradient, {static_cast<std::uint32_t>(pass + 1), n.slot}};
}

}  // namespace

NearMaterial::NearMaterial(const Material& material, const Lattice& lattice)
    : NearMaterial(material, lattice, kAboutCells) {}

NearMaterial::NearMaterial(const Material& material, const Lattice& lattice,
                           std::span<const NearCubes> cubes)
    : material_(material), lattice_(lattice) {
  for (const NearCubes& c : cubes) {
    levels_.push_back({c});
    levels_.back().moves.resize(material.passes().size());
  }
}

bool NearMaterial::Level::holds(const Index3& cell) const {
  const int within = ~(cubes.edge - 1);
  return ready && corner[0] == (cell[0] & within) && corner[1] == (cell[1] & within) &&
         corner[2] == (cell[2] & within);
}

void NearMaterial::turn_to(const Index3& cell) {
  // The cubes about it hold the cell then too.
  if (levels_[last_].holds(cell)) return;
  const Level* wider = nullptr;
  for (last_ = 0;; ++last_) {
    Level& level = levels_[last_];
    if (!level.holds(cell)) {
      for (int a = 0; a < 3; ++a) level.corner[a] = cell[a] & ~(level.cubes.edge - 1);
      prepare(level, wider);
      // What hangs on this one is of another place.
      for (std::size_t below = last_ + 1; below < levels_.size(); ++below)
        levels_[below].ready = false;
    }
    // Most of a stock's surface is raw: nothing is to be handed down there.
    if (level.only_raw || last_ + 1 == levels_.size()) return;
    wider = &level;
  }
}

// With r the half diagonal, φ is at least φ(middle) − r all over the cube: a pass whose distance at
// the middle is beyond 2r − φ(middle) makes nothing of it there.
void NearMaterial::prepare(Level& level, const Level* wider) {
  const double half = 0.5 * level.cubes.edge;
  level.cube.middle = lattice_.point(level.corner) + Vec3{half, half, half} * lattice_.voxel_mm;
  level.cube.half_edge_mm = (half + level.cubes.margin) * lattice_.voxel_mm;
  level.raw = raw_distance(material_.raw(), level.cube.middle);
  const double reach = 2 * level.cube.half_diagonal() + kDistanceRounding_mm;
  double value = level.raw.distance;
  for (std::size_t k = material_.passes().size(); k-- > 0;) {
    const SweepIndex& pass = *material_.passes()[k];
    NearMoves& moves = level.moves[k];
    const double least = wider ? moves.narrow(pass, wider->moves[k], level.cube, reach - value)
                               : moves.gather(pass, level.cube, reach - value);
    value = std::max(value, -least);
  }
  level.only_raw = std::all_of(level.moves.begin(), level.moves.end(),
                               [](const NearMoves& moves) { return moves.empty(); });
  level.ready = true;
}

MaterialSample NearMaterial::sample(const Vec3& p, SurfaceMaker guess) const {
  for (std::size_t k = last_ + 1; k-- > 0;)
    if (levels_[k].ready && levels_[k].cube.contains(p)) return sample_in(levels_[k], p, guess);
  return material_.sample(p, guess);
}

MaterialSample NearMaterial::sample_in(const Level& level, const Vec3& p,
                                       SurfaceMaker guess) const {
  if (level.only_raw) return material_.sample_of({}, p);
  MaterialSample best;
  best.value = -std::numeric_limits<double>::infinity();
  // The raw stock's distance changes by no more than the way.
  const double raw_most =
      level.raw.distance + distance(p, level.cube.middle) + kDistanceRounding_mm;
  if (guess.pass > 0) best = material_.sample_of(guess, p);
  if (raw_most > best.value) {
    const MaterialSample raw = material_.sample_of({}, p);
    if (raw.value >= best.value) best = raw;
  }
  for (std::size_t k = 0; k < level.moves.size(); ++k)
    if (const auto found = level.moves[k].nearest(*material_.passes()[k], p, -best.value))
      best = of_move(k, *found);
  return best;
}

}  // namespace limitgauge::simulator
