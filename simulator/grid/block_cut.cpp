#include "simulator/grid/block_cut.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "simulator/tolerance.h"

namespace limitgauge::simulator {
namespace {

using model::Vec3;

constexpr std::size_t kFewMoves = 32, kMovesOfLeaf = 96;

Index3 child_corner(const Index3& corner, int half, int child) {
  return {corner[0] + (child >> 2 & 1) * half, corner[1] + (child >> 1 & 1) * half,
          corner[2] + (child & 1) * half};
}

/// Takes what is worked out over the voxels of a pass's own frame to the level set's.
class RenamedSink : public LeafSink {
 public:
  RenamedSink(const PassLattice& lattice, LeafSink& sink) : lattice_(lattice), sink_(sink) {
    std::size_t n = 0;
    for (int x = 0; x < kLeafEdge; ++x)
      for (int y = 0; y < kLeafEdge; ++y)
        for (int z = 0; z < kLeafEdge; ++z) {
          const Index3 own = lattice.own_in_cube({x, y, z}, kLeafEdge);
          place_[n++] = (own[0] * kLeafEdge + own[1]) * kLeafEdge + own[2];
        }
  }

  bool wanted(const Index3& corner, int edge) const override {
    return sink_.wanted(lattice_.asked_corner(corner, edge), edge);
  }
  void removed(const Index3& corner, int edge) override {
    sink_.removed(lattice_.asked_corner(corner, edge), edge);
  }
  void reached(const Index3& corner, const LeafDistances& distances) override {
    LeafDistances asked;
    for (std::size_t n = 0; n < asked.size(); ++n) asked[n] = distances[place_[n]];
    sink_.reached(lattice_.asked_corner(corner, kLeafEdge), asked);
  }

 private:
  const PassLattice& lattice_;
  LeafSink& sink_;
  std::array<int, kLeafEdge * kLeafEdge * kLeafEdge> place_;
};

}  // namespace

BlockCutter::BlockCutter(const SweepIndex& pass, const Lattice& lattice, double band_mm)
    : pass_(pass.own()), lattice_(lattice, pass), band_(band_mm) {
  std::size_t halvings = 1;
  for (int edge = kBlockEdge; edge >= 2; edge /= 2) ++halvings;
  levels_.resize(halvings);
}

BlockCutter::Reach BlockCutter::reach_of(double least, double reach) {
  if (least > reach) return Reach::none;
  return least < -reach ? Reach::wholly : Reach::partly;
}

std::optional<NearestMove> BlockCutter::nearest(const Index3& corner, int edge) const {
  return pass_.nearest(lattice_.middle(corner, edge), lattice_.half_diagonal(edge) + band_);
}

void BlockCutter::cut(const Index3& corner, LeafSink& sink,
                      const std::optional<NearestMove>& known) {
  if (!lattice_.renamed()) {
    const auto found = known ? known : nearest(corner, kBlockEdge);
    if (found) cut_cube(0, corner, kBlockEdge, *found, sink);
    return;
  }
  RenamedSink renamed(lattice_, sink);
  const Index3 own = lattice_.own_corner(corner, kBlockEdge);
  if (const auto found = nearest(own, kBlockEdge)) cut_cube(0, own, kBlockEdge, *found, renamed);
}

void BlockCutter::cut_cube(int depth, const Index3& corner, int edge, const NearestMove& found,
                           LeafSink& sink) {
  gather(found, corner, edge);
  if (slots_.size() > kMostHandedDown && edge > kLeafEdge) {
    const double reach = lattice_.half_diagonal(edge) + band_;
    if (reach_of(found.at.distance, reach) == Reach::wholly) return sink.removed(corner, edge);
    for (int child = 0; child < 8; ++child) {
      const Index3 part = child_corner(corner, edge / 2, child);
      if (const auto in_part = nearest(part, edge / 2))
        cut_cube(depth + 1, part, edge / 2, *in_part, sink);
    }
    return;
  }
  levels_[depth].moves.assign(pass_, slots_);
  descend(depth, corner, edge, sink);
}

// Into slots_: all moves that may be nearest somewhere in the cube.
void BlockCutter::gather(const NearestMove& nearest, const Index3& corner, int edge) {
  const Vec3 middle = lattice_.middle(corner, edge);
  slots_.clear();
  if (pass_.profile().is_ball() && lattice_.top_mm(corner, edge) <= pass_.below_tops_mm()) {
    const double to_foot = nearest.at.distance + pass_.profile().corner_radius();
    pass_.gather_rivals({middle, lattice_.half_edge(edge), nearest.at.gradient * to_foot}, slots_);
  } else {
    const double diagonal = 2 * lattice_.half_diagonal(edge);
    pass_.gather(middle, nearest.at.distance + diagonal + kDistanceRounding_mm, slots_);
  }
}

bool BlockCutter::balls_below_tops(const MoveBatch& moves, double highest) const {
  return pass_.profile().is_ball() && highest <= moves.below_tops_mm(pass_.profile());
}

// A move that is farther than the nearest one by a diagonal cannot matter and is not worked out;
// one that swallows the whole block ends the search.
void BlockCutter::sample(Level& level, const Vec3& p, double half_diagonal) const {
  if (balls_below_tops(level.moves, p.z))
    return sample_balls(level.moves, pass_.profile().corner_radius(), p, level.samples);
  constexpr double kFar = std::numeric_limits<double>::infinity();
  const std::size_t n = level.moves.size();
  level.samples.resize(n);
  double least = kFar;
  for (std::size_t i = 0; i < n && least >= -(half_diagonal + band_); ++i) {
    const std::uint32_t slot = level.moves.slot[i];
    const double most = least + 2 * half_diagonal + 2 * kDistanceRounding_mm;
    const bool far = pass_.cannot_be_below(slot, p, most);
    const SweptSample s = far ? SweptSample{kFar, {}, 0} : pass_.distance_below(slot, p, most);
    least = std::min(least, s.distance);
    level.samples.set(i, s, pass_, slot, p, half_diagonal);
    if (least < -(half_diagonal + band_)) level.samples.resize(i + 1);
  }
}

// Of the nearest moves, often several on a flat floor, the one whose distance bends least.
std::size_t BlockCutter::reference_move(const Level& level, const Vec3& middle, double reach,
                                        double& bound) const {
  const auto& d = level.samples.distance;
  const auto least = std::min_element(d.begin(), d.end());
  std::size_t best = least - d.begin();
  bound = 2 * reach;
  for (std::size_t i = best; i < d.size() && bound > 0; ++i) {
    if (d[i] > *least) continue;
    const std::uint32_t slot = level.moves.slot[i];
    const SweptSample at = pass_.distance(slot, middle);
    const double e = pass_.curvature_bound(slot, middle, at, reach) +
                     reach * distance(at.gradient, level.samples.gradient(i));
    if (e < bound) bound = e, best = i;
  }
  return best;
}

void BlockCutter::keep_that_matter(Level& level, const Vec3& middle, int edge) {
  const double h = lattice_.half_edge(edge), r = lattice_.half_diagonal(edge);
  const BatchSamples& s = level.samples;
  if (pass_.turns()) return rivals_.keep(pass_, level.moves, s, middle, h, r, level.kept);
  double bend = 0;
  const std::size_t j = reference_move(level, middle, r, bend);
  const Vec3 g = s.gradient(j);
  level.kept.clear();
  for (std::size_t i = 0; i < s.distance.size(); ++i) {
    const double behind = s.distance[i] - s.distance[j];
    const double turn = norm1(s.gradient(i) - g);
    const bool twin = behind == 0 && turn == 0 && bend == 0;
    if (i == j || (!twin && behind <= std::min(2 * r, h * turn + bend) + kDistanceRounding_mm))
      level.kept.push_back(static_cast<std::uint32_t>(i));
  }
}

BlockCutter::Reach BlockCutter::narrow(Level& level, const Index3& corner, int edge) {
  if (level.moves.size() == 0) return Reach::none;
  if (balls_below_tops(level.moves, lattice_.top_mm(corner, edge)))
    return narrow_balls(level, corner, edge);
  const Vec3 middle = lattice_.middle(corner, edge);
  sample(level, middle, lattice_.half_diagonal(edge));
  const double least =
      *std::min_element(level.samples.distance.begin(), level.samples.distance.end());
  const Reach reach = reach_of(least, lattice_.half_diagonal(edge) + band_);
  if (reach == Reach::partly) keep_that_matter(level, middle, edge);
  return reach;
}

BlockCutter::Reach BlockCutter::narrow_balls(Level& level, const Index3& corner, int edge) {
  const double least =
      capsules_.nearest(level.moves, lattice_.middle(corner, edge), lattice_.half_edge(edge));
  const Reach reach = reach_of(std::sqrt(least) - pass_.profile().corner_radius(),
                               lattice_.half_diagonal(edge) + band_);
  if (reach == Reach::partly) capsules_.keep(level.moves, level.kept);
  return reach;
}

void BlockCutter::descend(int depth, const Index3& corner, int edge, LeafSink& sink) {
  if (!sink.wanted(corner, edge)) return;
  Level& level = levels_[depth];
  const Reach reach = narrow(level, corner, edge);
  if (reach == Reach::none) return;
  if (reach == Reach::wholly) return sink.removed(corner, edge);
  if (edge == kLeafEdge) {
    fill_leaf(depth, corner);
    return sink.reached(corner, leaf_);
  }
  levels_[depth + 1].moves.take(level.moves, level.kept);
  for (int child = 0; child < 8; ++child)
    descend(depth + 1, child_corner(corner, edge / 2, child), edge / 2, sink);
}

// All voxels against all moves, in single precision: with few moves left that takes less time than
// telling parts of the leaf apart.
bool BlockCutter::fill_leaf_at_once(const Level& level, const Index3& corner) {
  const LeafVoxels leaf{lattice_.middle(corner, kLeafEdge), lattice_.voxel_mm()};
  const double radius = pass_.profile().corner_radius();
  if (!lattice_.straight() || level.kept.size() > kMovesOfLeaf ||
      !CapsuleLeaf::fine_enough(leaf, radius) ||
      !balls_below_tops(level.moves, lattice_.top_mm(corner, kLeafEdge)) ||
      !capsule_leaf_.take(level.moves, level.kept, leaf, radius))
    return false;
  capsule_leaf_.distances(band_, leaf_);
  return true;
}

void BlockCutter::fill_leaf(int depth, const Index3& corner) {
  if (fill_leaf_at_once(levels_[depth], corner)) return;
  levels_[depth + 1].moves.take(levels_[depth].moves, levels_[depth].kept);
  for (int child = 0; child < 8; ++child)
    fill(depth + 1, child_corner(corner, kLeafEdge / 2, child), kLeafEdge / 2);
}

void BlockCutter::fill(int depth, const Index3& corner, int edge) {
  Level& level = levels_[depth];
  const Reach reach = narrow(level, corner, edge);
  const auto band = static_cast<float>(band_);
  if (reach == Reach::none) return set_cube(corner, edge, band);
  if (reach == Reach::wholly) return set_cube(corner, edge, -band);
  if (worth_no_split(level, corner, edge)) return fill_with_balls(level, corner);
  if (edge == 2 && pass_.turns()) return fill_turning_voxels(level, corner);
  levels_[depth + 1].moves.take(level.moves, level.kept);
  if (edge == 2) return fill_voxels(depth + 1, corner);
  for (int child = 0; child < 8; ++child)
    fill(depth + 1, child_corner(corner, edge / 2, child), edge / 2);
}

// With few moves left, all voxels against all moves take less time than telling cubes apart.
bool BlockCutter::worth_no_split(const Level& level, const Index3& corner, int edge) const {
  return lattice_.straight() && edge == kCubeEdge && level.kept.size() <= kFewMoves &&
         balls_below_tops(level.moves, lattice_.top_mm(corner, edge));
}

void BlockCutter::fill_with_balls(const Level& level, const Index3& corner) {
  CubeAxes axes;
  for (int k = 0; k < kCubeEdge; ++k) {
    const Vec3 p = lattice_.point({corner[0] + k, corner[1] + k, corner[2] + k});
    axes.x[k] = p.x, axes.y[k] = p.y, axes.z[k] = p.z;
  }
  const CubeDistances d =
      least_ball_distances(level.moves, level.kept, pass_.profile().corner_radius(), axes);
  const double* from = d.data();
  float* to = &leaf_at(corner);
  for (int z = 0; z < kCubeEdge; ++z)
    for (int x = 0; x < kCubeEdge; ++x)
      for (int y = 0; y < kCubeEdge; ++y)
        to[(x * kLeafEdge + y) * kLeafEdge + z] =
            static_cast<float>(std::clamp(*from++, -band_, band_));
}

void BlockCutter::fill_voxels(int depth, const Index3& corner) {
  const MoveBatch& moves = levels_[depth].moves;
  std::array<Vec3, 8> points;
  for (int k = 0; k < 8; ++k) points[k] = lattice_.point(child_corner(corner, 1, k));
  std::array<double, 8> least;
  if (balls_below_tops(moves, lattice_.top_mm(corner, 2))) {
    least = least_ball_distances(moves, pass_.profile().corner_radius(), points);
  } else {
    least.fill(std::numeric_limits<double>::infinity());
    for (const std::uint32_t slot : moves.slot)
      for (int k = 0; k < 8; ++k)
        least[k] = std::min(least[k], pass_.distance(slot, points[k]).distance);
  }
  for (int k = 0; k < 8; ++k)
    leaf_at(child_corner(corner, 1, k)) = static_cast<float>(std::clamp(least[k], -band_, band_));
}

// A move is worked out at a voxel only where its plane from the cube's middle is not above what was
// found; the lowest plane first.
void BlockCutter::fill_turning_voxels(const Level& level, const Index3& corner) {
  const BatchSamples& s = level.samples;
  const Vec3 middle = lattice_.middle(corner, 2);
  const double within = kTurnInVoxels * lattice_.voxel_mm();
  for (int k = 0; k < 8; ++k) {
    const Index3 voxel = child_corner(corner, 1, k);
    const Vec3 p = lattice_.point(voxel), step = p - middle;
    planes_.clear();
    for (const std::uint32_t i : level.kept)
      planes_.push_back({s.distance[i] - s.sag[i] + dot(s.gradient(i), step), level.moves.slot[i]});
    std::sort(planes_.begin(), planes_.end());
    double least = std::numeric_limits<double>::infinity();
    for (const auto& [plane, slot] : planes_) {
      if (plane - kDistanceRounding_mm > least) break;
      least = std::min(least, pass_.distance_below(slot, p, least, within).distance);
    }
    leaf_at(voxel) = static_cast<float>(std::clamp(least, -band_, band_));
  }
}

float& BlockCutter::leaf_at(const Index3& i) {
  const auto in_leaf = [](int v) { return v & (kLeafEdge - 1); };
  return leaf_[(in_leaf(i[0]) * kLeafEdge + in_leaf(i[1])) * kLeafEdge + in_leaf(i[2])];
}

void BlockCutter::set_cube(const Index3& corner, int edge, float value) {
  for (int x = 0; x < edge; ++x)
    for (int y = 0; y < edge; ++y)
      for (int z = 0; z < edge; ++z) leaf_at({corner[0] + x, corner[1] + y, corner[2] + z}) = value;
}

}  // namespace limitgauge::simulator
