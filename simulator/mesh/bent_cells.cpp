#include "simulator/mesh/bent_cells.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "model/base/chunks.h"
#include "simulator/mesh/tetrahedra.h"
#include "simulator/process/near_material.h"

namespace limitgauge::simulator {
namespace {

using model::Vec3;

constexpr std::size_t kSample = 4096, kChunk = 64;
// Of the edge: above what curvature makes of a surface whose radius is ten voxels.
constexpr double kBent = 0.0125;
constexpr int kHalvings = 3;

// Scrambles without loss (the finaliser of SplitMix64), so that places next to each other are in
// the sample or not as if by chance.
std::uint64_t key_of(const Index3& at) {
  std::uint64_t h = 0;
  for (const int i : at) h = h << 21 | (static_cast<std::uint64_t>(i) & 0x1fffff);
  h = (h ^ h >> 30) * 0xbf58476d1ce4e5b9U;
  h = (h ^ h >> 27) * 0x94d049bb133111ebU;
  return h ^ h >> 31;
}

Vec3 corner_step(int k) {
  return {k & 4 ? 1.0 : 0.0, k & 2 ? 1.0 : 0.0, k & 1 ? 1.0 : 0.0};
}

// The share of a cube that is inside the exact material.
class ExactShare {
 public:
  ExactShare(const Material& material, const Lattice& lattice)
      : material_(material, lattice), lattice_(lattice) {}

  double of(const Index3& cell) {
    material_.turn_to(cell);
    Corners values;
    for (int k = 0; k < 8; ++k)
      values[k] = value(lattice_.point(cell) + corner_step(k) * lattice_.voxel_mm);
    return share(lattice_.point(cell), lattice_.voxel_mm, values, kHalvings);
  }

 private:
  using Corners = std::array<double, 8>;

  double value(const Vec3& p) { return material_.sample(p, {}).value; }

  double share(const Vec3& low, double edge, const Corners& values, int halvings) {
    const auto inside = std::count_if(values.begin(), values.end(), [](double v) { return v < 0; });
    if (inside == 0 || inside == 8) return inside == 0 ? 0.0 : 1.0;
    if (halvings == 0 || !is_bent(values, edge)) return negative_share(values);
    const auto at = halved(low, edge, values);
    double sum = 0;
    for (int child = 0; child < 8; ++child) {
      Corners part;
      for (int k = 0; k < 8; ++k) part[k] = at[place(child, k)];
      sum += share(low + corner_step(child) * (edge / 2), edge / 2, part, halvings - 1);
    }
    return sum / 8;
  }

  // Of a corner of one of the eight parts among the 27 places.
  static std::size_t place(int child, int k) {
    const auto along = [&](int bit) { return (child >> bit & 1) + (k >> bit & 1); };
    return static_cast<std::size_t>((along(2) * 3 + along(1)) * 3 + along(0));
  }

  std::array<double, 27> halved(const Vec3& low, double edge, const Corners& values) {
    std::array<double, 27> at;
    for (int x = 0, n = 0; x < 3; ++x)
      for (int y = 0; y < 3; ++y)
        for (int z = 0; z < 3; ++z, ++n)
          if (x == 1 || y == 1 || z == 1)
            at[n] = value(low + Vec3{1.0 * x, 1.0 * y, 1.0 * z} * (edge / 2));
    for (int k = 0; k < 8; ++k) at[place(k, k)] = values[k];
    return at;
  }

  NearMaterial material_;
  Lattice lattice_;
};

}  // namespace

void BentCells::add(const Index3& at, double share) {
  some_.push_back({key_of(at), at, share});
  ++count_;
  if (some_.size() >= 2 * kSample) keep_least();
}

BentCells& BentCells::operator+=(const BentCells& b) {
  some_.insert(some_.end(), b.some_.begin(), b.some_.end());
  count_ += b.count_;
  keep_least();
  return *this;
}

void BentCells::keep_least() {
  if (some_.size() <= kSample) return;
  std::nth_element(some_.begin(), some_.begin() + kSample, some_.end());
  some_.resize(kSample);
}

std::vector<BentCell> BentCells::sample() const {
  BentCells all = *this;
  all.keep_least();
  std::sort(all.some_.begin(), all.some_.end());
  return all.some_;
}

double GridVolume::voxels(const Material& material, const Lattice& lattice,
                          const model::RunControl& control) const {
  std::vector<BentCell> sample = bent.sample();
  // Neighbours share what can matter to them, cube by cube as NearMaterial hands it down.
  const auto cubes = [](const BentCell& c) {
    std::array<Index3, 4> in;
    for (std::size_t k = 0; k < in.size(); ++k)
      for (int a = 0; a < 3; ++a) in[k][a] = c.at[a] >> std::array{5, 3, 2, 1}[k];
    return in;
  };
  std::sort(sample.begin(), sample.end(), [&](const BentCell& a, const BentCell& b) {
    const auto in_a = cubes(a), in_b = cubes(b);
    return in_a != in_b ? in_a < in_b : a < b;
  });
  std::vector<double> off(sample.size());
  model::parallel_chunks(sample.size(), kChunk, control, [&](std::size_t begin, std::size_t end) {
    ExactShare exact(material, lattice);
    for (std::size_t i = begin; i < end; ++i) off[i] = exact.of(sample[i].at) - sample[i].share;
  });
  double sum = 0;
  for (const double o : off) sum += o;
  if (!sample.empty()) sum *= static_cast<double>(bent.count()) / static_cast<double>(off.size());
  return linear.voxels() + sum;
}

bool is_bent(const std::array<double, 8>& f, double edge_mm) {
  double mean = 0;
  Vec3 slope;
  for (int k = 0; k < 8; ++k) {
    mean += f[k] / 8;
    slope += (corner_step(k) * 2 - Vec3{1, 1, 1}) * (f[k] / 8);
  }
  double worst = 0;
  for (int k = 0; k < 8; ++k)
    worst = std::max(worst, std::abs(f[k] - mean - dot(slope, corner_step(k) * 2 - Vec3{1, 1, 1})));
  return worst > kBent * edge_mm;
}

}  // namespace limitgauge::simulator
