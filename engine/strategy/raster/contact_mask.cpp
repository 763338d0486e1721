#include "engine/strategy/raster/contact_mask.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "model/base/angle.h"

namespace limitgauge::engine::strategy {
namespace {

/// Sine of how far a wall may lean over before it counts as facing down: meshes of upright walls
/// lean a little.
constexpr double kOverhang = 0.02;

class Marker {
 public:
  Marker(const LimitLocations& limit, const StageRequest& request, const Raster& nodes)
      : limit_(limit),
        reach_{CellMask(nodes), CellMask(nodes), std::numeric_limits<double>::infinity()},
        corner_(request.cutter.corner_radius_mm),
        flat_(request.cutter.radius_mm() - corner_),
        steep_(std::cos(model::radians(request.cut.steep_angle_deg))) {}

  void add(const surface::LimitPatch& patch, int depth) {
    const int stride = patch.cells() >> depth;
    for (int v = 0; v < patch.cells(); v += stride)
      for (int u = 0; u < patch.cells(); u += stride)
        add_cell(patch, {patch.index(u, v), patch.index(u + stride, v),
                         patch.index(u + stride, v + stride), patch.index(u, v + stride)});
  }
  ContactReach take() { return std::move(reach_); }

 private:
  void add_cell(const surface::LimitPatch& patch, const std::array<int, 4>& corners) {
    model::Box3 box;
    bool faces_up = false, steep = false;
    for (const int i : corners) {
      box.add(tip(patch.points[i], patch.normals[i]));
      faces_up = faces_up || patch.normals[i].z >= -kOverhang;
      steep = steep || patch.normals[i].z <= steep_;
    }
    if (!faces_up) return;
    reach_.lowest_mm = std::min(reach_.lowest_mm, box.low.z);
    mark(box, reach_.cells);
    if (steep) mark(box, reach_.steep);
  }

  Vec3 tip(const Vec3& p, const Vec3& normal) const {
    const double level = std::hypot(normal.x, normal.y);
    const Vec3 out = level > 0 ? Vec3{normal.x / level, normal.y / level, 0} : Vec3{};
    // What faces down a little is touched as if it were upright.
    const Vec3 facing = normal.z >= 0 ? normal : out;
    return p + facing * (corner_ + limit_.kept_mm) + out * flat_ - Vec3{0, 0, corner_};
  }

  static void mark(const model::Box3& box, CellMask& mask) {
    const auto cell = [&](double at, double low, int count) {
      return static_cast<int>(
          std::clamp(std::floor((at - low) / mask.nodes.pixel_mm), 0.0, count - 1.0));
    };
    const int i0 = cell(box.low.x, mask.nodes.x0, mask.columns());
    const int i1 = cell(box.high.x, mask.nodes.x0, mask.columns());
    const int j0 = cell(box.low.y, mask.nodes.y0, mask.rows());
    const int j1 = cell(box.high.y, mask.nodes.y0, mask.rows());
    for (int j = j0; j <= j1; ++j)
      for (int i = i0; i <= i1; ++i) mask.set[mask.index(i, j)] = 1;
  }

  const LimitLocations& limit_;
  ContactReach reach_;
  double corner_, flat_;
  double steep_;  ///< height of a unit normal there
};

}  // namespace

ContactReach contact_reach(const surface::PatchModel& model, const LimitLocations& limit,
                           const StageRequest& request, const Raster& nodes) {
  Marker marker(limit, request, nodes);
  const auto& patches = model.patches();
  for (std::size_t p = 0; p < patches.size(); ++p)
    marker.add(patches[p].limit, limit.sampler.depths()[p]);
  return marker.take();
}

}  // namespace limitgauge::engine::strategy
