#include "simulator/mesh/mesh_solid.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

#include "model/mesh/mesh_defect.h"
#include "simulator/mesh/mesh_tree.h"
#include "simulator/tolerance.h"

namespace limitgauge::simulator {
namespace {

using model::Vec3;
using Triangle = MeshTree::Triangle;

double turn_in_plan(const Vec3& a, const Vec3& b) {
  return a.x * b.y - a.y * b.x;
}

/// Where a vertical that passes through the triangle meets it: the height of its longest side in
/// plan there, and the share of what the third corner lies beside that. So of a sliver, whose plane
/// rounding may turn anyhow, it is no further off than the sliver is wide; of one that is all but
/// vertical it is a height that the triangle has there.
double height_at(const Triangle& t, double x, double y) {
  const auto in_plan = [&](int k) { return level_distance(t[k], t[(k + 1) % 3]); };
  int longest = 0;
  for (int k = 1; k < 3; ++k)
    if (in_plan(k) > in_plan(longest)) longest = k;
  const Vec3 &a = t[longest], &b = t[(longest + 1) % 3], &c = t[(longest + 2) % 3];
  const auto [low, high] = std::minmax({a.z, b.z, c.z});
  const Vec3 side = b - a, to{x - a.x, y - a.y, 0}, third = c - a;
  const double squared = side.x * side.x + side.y * side.y;
  if (squared == 0) return low;
  const auto on_side = [&](const Vec3& v) {
    return a.z + (v.x * side.x + v.y * side.y) / squared * side.z;
  };
  const double wide = turn_in_plan(side, third);
  const double share = wide == 0 ? 0 : std::clamp(turn_in_plan(side, to) / wide, 0.0, 1.0);
  return std::clamp(on_side(to) + share * (c.z - on_side(third)), low, high);
}

struct Crossing {
  double z = 0;
  int turns = 0;
};

Vec3 facing(const Triangle& t) {
  const Vec3 n = cross(t[1] - t[0], t[2] - t[0]);
  const double l = length(n);
  return l > 0 ? n / l : Vec3{0, 0, 1};
}

}  // namespace

struct MeshSolid::State {
  std::shared_ptr<const model::TriangleMesh> mesh;
  MeshTree tree;
  model::Box3 box;
  double area_mm2, volume_mm3;

  explicit State(std::shared_ptr<const model::TriangleMesh> m)
      : mesh(std::move(m)),
        tree(*mesh),
        box(bounding_box(*mesh)),
        area_mm2(model::area_mm2(*mesh)),
        volume_mm3(model::volume_mm3(*mesh)) {}

  bool contains(const Vec3& p) const { return box.contains(p) && tree.winding(p) > 0; }
};

MeshSolid::MeshSolid(std::shared_ptr<const model::TriangleMesh> mesh) {
  if (mesh == nullptr) throw std::invalid_argument("a solid without its mesh");
  if (const auto defect = find_defect(*mesh))
    throw std::invalid_argument("the mesh bounds no solid: " + defect->wrong);
  state_ = std::make_shared<const State>(std::move(mesh));
}

SolidSample MeshSolid::sample(const Vec3& p) const {
  const MeshTree::Nearest near = state_->tree.nearest(p);
  const double d = std::sqrt(near.distance_squared), sign = state_->contains(p) ? -1 : 1;
  if (d <= kOnSurface_mm) return {sign * d, facing(state_->tree.triangle(near.triangle))};
  return {sign * d, (p - near.point) * (sign / d)};
}

std::optional<SolidCap> MeshSolid::cap(const Vec3& p, double reach_mm) const {
  const MeshTree& tree = state_->tree;
  const MeshTree::Nearest near = tree.nearest(p);
  if (near.distance_squared > reach_mm * reach_mm) return std::nullopt;
  const Triangle t = tree.triangle(near.triangle);
  const Vec3 normal = facing(t);
  const double ball = 3 * reach_mm;
  const bool under = tree.each_about(p, ball, [&](std::uint32_t number) {
    const Triangle other = tree.triangle(number);
    const bool rises = std::ranges::any_of(
        other, [&](const Vec3& v) { return dot(v - t[0], normal) > kCoplanar_mm; });
    return !rises || tree.distance_to(number, p) > ball;
  });
  if (!under || contains(near.point + normal * (reach_mm / 2))) return std::nullopt;
  return SolidCap{dot(t[0] - p, normal) + kCoplanar_mm, normal};
}

bool MeshSolid::contains(const Vec3& p) const {
  return state_->contains(p);
}

void MeshSolid::distances_up(const Vec3& p, double step_mm, std::span<double> out) const {
  const MeshTree& tree = state_->tree;
  std::vector<MeshTree::Passage> above = tree.passages_above(p);
  std::optional<std::uint32_t> last;
  for (std::size_t n = 0; n < out.size(); ++n) {
    const Vec3 q{p.x, p.y, p.z + static_cast<double>(n) * step_mm};
    std::erase_if(above, [&](const MeshTree::Passage& c) { return !tree.is_above(c, q); });
    int winding = 0;
    for (const MeshTree::Passage& c : above) winding += c.turns;
    const MeshTree::Nearest near = tree.nearest(q, last);
    last = near.triangle;
    out[n] = std::copysign(std::sqrt(near.distance_squared), winding > 0 ? -1.0 : 1.0);
  }
}

std::vector<double> MeshSolid::crossings(double x_mm, double y_mm) const {
  std::vector<Crossing> all;
  for (const MeshTree::Passage& c : state_->tree.passages(x_mm, y_mm))
    all.push_back({height_at(state_->tree.triangle(c.triangle), x_mm, y_mm), c.turns});
  std::ranges::sort(all, {}, &Crossing::z);
  std::vector<double> heights;
  int winding = 0;
  for (std::size_t n = 0; n < all.size();) {
    const double z = all[n].z;
    const bool inside = winding > 0;
    for (; n < all.size() && all[n].z == z; ++n) winding -= all[n].turns;
    if ((winding > 0) != inside) heights.push_back(z);
  }
  return heights;
}

const model::TriangleMesh& MeshSolid::mesh() const {
  return *state_->mesh;
}
const model::Box3& MeshSolid::box() const {
  return state_->box;
}
double MeshSolid::area_mm2() const {
  return state_->area_mm2;
}
double MeshSolid::volume_mm3() const {
  return state_->volume_mm3;
}
std::size_t MeshSolid::memory_bytes() const {
  const model::TriangleMesh& m = *state_->mesh;
  return state_->tree.memory_bytes() + m.vertices.capacity() * sizeof(m.vertices[0]) +
         m.triangles.capacity() * sizeof(m.triangles[0]);
}

}  // namespace limitgauge::simulator
