#include "simulator/sweep/capsule_leaf.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "simulator/sweep/capsule_batch.h"
#include "simulator/sweep/vector_loops.h"

namespace limitgauge::simulator {
namespace {

using model::Vec3;

constexpr std::size_t kColumn = LeafVoxels::kEdge;
// Voxels to the radius from which on the bound of P6 holds.
constexpr double kLeastRadius_voxels = 24;

constexpr std::size_t kSlice = kColumn * kColumn;
constexpr std::array<float, kColumn> kPlaces{-3.5F, -2.5F, -1.5F, -0.5F, 0.5F, 1.5F, 2.5F, 3.5F};

// Places along y and z of the voxels of a slice, z fastest.
struct SlicePlaces {
  std::array<float, kSlice> y{}, z{};
  constexpr SlicePlaces() {
    for (std::size_t n = 0; n < kSlice; ++n)
      y[n] = kPlaces[n / kColumn], z[n] = kPlaces[n % kColumn];
  }
};
constexpr SlicePlaces kInSlice;

// Of one move at all voxels: what is beneath those so far becomes the least. |δ|² is left out.
LIMITGAUGE_WIDE
void lower_leaf(const WayFromMiddle& way, float* __restrict least) {
  const float square = way.square, x = way.x, y = way.y, z = way.z;
  const float from_foot = way.along, ux = way.ux, uy = way.uy, uz = way.uz;
  const float back = way.back, ahead = way.ahead;
  float climb[kSlice], rise[kSlice];
  for (std::size_t n = 0; n < kSlice; ++n) {
    climb[n] = y * kInSlice.y[n] + z * kInSlice.z[n];
    rise[n] = uy * kInSlice.y[n] + uz * kInSlice.z[n];
  }
  for (std::size_t i = 0; i < kColumn; ++i) {
    const float foot = square + x * kPlaces[i], along = from_foot + ux * kPlaces[i];
    float* __restrict out = least + i * kSlice;
    for (std::size_t n = 0; n < kSlice; ++n) {
      const float a = along + rise[n];
      float slid = a < ahead ? a : ahead;
      slid = slid > back ? slid : back;
      const float e = foot + climb[n] - slid * (a + (a - slid));
      out[n] = std::min(out[n], e);
    }
  }
}

// Of the squares less r² and |δ|² the distances, (√(r² + e) − r) = e / (√(r² + e) + r).
LIMITGAUGE_WIDE
void roots(float radius, float voxel, float band, float* __restrict values) {
  const float square = radius * radius;
  for (std::size_t i = 0; i < kColumn; ++i) {
    const float x2 = kPlaces[i] * kPlaces[i];
    float* __restrict out = values + i * kSlice;
    for (std::size_t n = 0; n < kSlice; ++n) {
      const float y = kInSlice.y[n], z = kInSlice.z[n];
      const float e = out[n] + (x2 + (y * y + z * z));
      const float under = square + e, root = std::sqrt(under > 0 ? under : 0.0F);
      const float d = voxel * (e / (radius + root));
      out[n] = std::max(std::min(d, band), -band);
    }
  }
}

}  // namespace

bool CapsuleLeaf::fine_enough(const LeafVoxels& leaf, double radius_mm) {
  return radius_mm >= kLeastRadius_voxels * leaf.voxel_mm;
}

bool CapsuleLeaf::take(const MoveBatch& b, std::span<const std::uint32_t> places,
                       const LeafVoxels& leaf, double radius_mm) {
  const double scale = 1 / leaf.voxel_mm, radius = radius_mm * scale;
  const double on_the_way = -kFootStaysOnWay * leaf.half_edge_mm();
  voxel_ = leaf.voxel_mm, radius_ = radius;
  ways_.clear();
  for (const std::uint32_t i : places) {
    const Vec3 q = leaf.middle - Vec3{b.x[i], b.y[i], b.z[i]};
    const Vec3 way{b.along_x[i] * b.run[i], b.along_y[i] * b.run[i], b.rise[i]};
    const double t = unit_clamp(dot(q, way) * b.inverse_length2[i]);
    const Vec3 foot = (q - way * t) * scale, u = way * b.inverse_length[i];
    if (foot.z * leaf.voxel_mm > on_the_way) return false;
    const double length = b.inverse_length[i] > 0 ? scale / b.inverse_length[i] : 0;
    const auto f = [](double v) { return static_cast<float>(v); };
    ways_.push_back({f(dot(foot, foot) - radius * radius), f(2 * foot.x), f(2 * foot.y),
                     f(2 * foot.z), f(u.x), f(u.y), f(u.z), f(dot(foot, u)), f(-t * length),
                     f((1 - t) * length)});
  }
  return true;
}

void CapsuleLeaf::distances(double band_mm, Distances& out) const {
  out.fill(std::numeric_limits<float>::infinity());
  for (const WayFromMiddle& way : ways_) lower_leaf(way, out.data());
  roots(static_cast<float>(radius_), static_cast<float>(voxel_), static_cast<float>(band_mm),
        out.data());
}

}  // namespace limitgauge::simulator
