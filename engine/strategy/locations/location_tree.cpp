#include "engine/strategy/locations/location_tree.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numeric>
#include <span>
#include <utility>

#include "engine/tolerance.h"
#include "model/geometry/box_tree.h"

namespace limitgauge::engine::strategy {
namespace {

using surface::Grid;

/// Cells along a side of a leaf: with one, nodes take more memory than points.
constexpr int kLeafSide = 2;
/// Steepest plane that a node is given (tangent): steeper ones bound nothing.
constexpr double kSteepestPlane = 50;

float round_down(double value) {
  const auto f = static_cast<float>(value);
  return f <= value ? f : std::nextafter(f, -std::numeric_limits<float>::infinity());
}
float round_up(double value) {
  return -round_down(-value);
}

/// The normal of a cell, pointing up, as long as its area.
Vec3 upward_normal(const Grid& grid, int u, int v) {
  const Vec3 n =
      cross(grid.at(u + 1, v + 1) - grid.at(u, v), grid.at(u, v + 1) - grid.at(u + 1, v));
  return n.z < 0 ? -n : n;
}

template <class Visit>
void for_points(const Grid& grid, const LocationLeaf& cells, const Visit& visit) {
  for (int v = cells.v; v <= cells.v_end; ++v)
    for (int u = cells.u; u <= cells.u_end; ++u) visit(grid.at(u, v));
}

/// Sets what follows from the lean of the node's plane and its offset.
void lean_on(LocationNode& node, double c, const CutterShape& shape) {
  const double gx = node.gx, gy = node.gy, steepness = std::sqrt(gx * gx + gy * gy);
  node.c = c;
  node.plane_lift = c + shape.support(steepness);
  const double share = steepness > 0 ? shape.contact_distance(steepness) / steepness : 0;
  node.contact_x = static_cast<float>(-gx * share);
  node.contact_y = static_cast<float>(-gy * share);
}

void set_box(LocationNode& node, const Box3& box, const CutterShape& shape) {
  node.low_x = round_down(box.low.x);
  node.low_y = round_down(box.low.y);
  node.high_x = round_up(box.high.x);
  node.high_y = round_up(box.high.y);
  node.high_z = round_up(box.high.z);
  lean_on(node, node.high_z, shape);
}

void set_plane(LocationNode& node, const Grid& grid, const LocationLeaf& cells,
               const CutterShape& shape) {
  Vec3 normal;
  for (int v = cells.v; v < cells.v_end; ++v)
    for (int u = cells.u; u < cells.u_end; ++u) normal += upward_normal(grid, u, v);
  if (!(std::hypot(normal.x, normal.y) < kSteepestPlane * normal.z)) return;
  node.gx = static_cast<float>(normal.x / normal.z);
  node.gy = static_cast<float>(normal.y / normal.z);
  double c = -std::numeric_limits<double>::infinity(), size = 0;
  for_points(grid, cells, [&](const Vec3& p) {
    c = std::max(c, p.z + node.gx * p.x + node.gy * p.y);
    size = std::max(size, std::abs(p.z) + std::abs(node.gx * p.x) + std::abs(node.gy * p.y));
  });
  lean_on(node, c + kUnitRounding * size, shape);
}

}  // namespace

class LocationTreeBuilder {
 public:
  LocationTreeBuilder(LocationTree& tree, const CutterShape& shape) : tree_(tree), shape_(shape) {}

  void build() {
    for (std::size_t g = 0; g < tree_.grids_.size(); ++g) add_root(static_cast<int>(g));
    if (roots_.empty()) return;
    reserve();
    tree_.nodes_.emplace_back();
    std::vector<int> order(roots_.size());
    std::iota(order.begin(), order.end(), 0);
    fill_upper(0, order);
  }

 private:
  struct Root {
    LocationLeaf cells;
    Box3 box;
  };

  void add_root(int g) {
    const Grid& grid = tree_.grids_[g];
    if (grid.columns < 2 || grid.rows < 2) return;
    Root root{{g, 0, 0, grid.columns - 1, grid.rows - 1}, {}};
    for_points(grid, root.cells, [&](const Vec3& p) { root.box.add(p); });
    tree_.box_.add(root.box);
    roots_.push_back(root);
  }

  struct Size {
    std::size_t nodes = 0, leaves = 0;
  };
  /// Of the tree over the cells of a grid.
  static Size size_of(const LocationLeaf& cells) {
    const std::vector<LocationLeaf> parts = quarters(cells);
    if (parts.size() == 1) return {1, 1};
    Size size{1, 0};
    for (const LocationLeaf& part : parts) {
      const Size of_part = size_of(part);
      size.nodes += of_part.nodes;
      size.leaves += of_part.leaves;
    }
    return size;
  }

  /// Arrays that grow as they are filled would be there twice each time they do.
  void reserve() {
    std::map<std::pair<int, int>, Size> known;
    Size size;
    for (const Root& root : roots_) {
      const auto [at, is_new] = known.try_emplace({root.cells.u_end, root.cells.v_end});
      if (is_new) at->second = size_of(root.cells);
      size.nodes += at->second.nodes;
      size.leaves += at->second.leaves;
    }
    // A node above has two children at least.
    tree_.nodes_.reserve(size.nodes + roots_.size());
    tree_.leaves_.reserve(size.leaves);
  }

  int add_children(int node, int count) {
    const int first = static_cast<int>(tree_.nodes_.size());
    tree_.nodes_[node].first = first;
    tree_.nodes_[node].children = count;
    tree_.nodes_.resize(tree_.nodes_.size() + count);
    return first;
  }

  /// Halves twice, each time across the longer side.
  void fill_upper(int node, std::span<int> order) {
    if (order.size() == 1) return fill_cells(node, roots_[order.front()].cells);
    Box3 box;
    for (const int r : order) box.add(roots_[r].box);
    set_box(tree_.nodes_[node], box, shape_);
    std::vector<std::span<int>> parts;
    for (const std::span<int> half : halves(order))
      for (const std::span<int> quarter : halves(half)) parts.push_back(quarter);
    const int first = add_children(node, static_cast<int>(parts.size()));
    for (std::size_t i = 0; i < parts.size(); ++i)
      fill_upper(first + static_cast<int>(i), parts[i]);
  }

  std::vector<std::span<int>> halves(std::span<int> order) const {
    if (order.size() == 1) return {order};
    const auto seen_from_above = [&](int r) {
      const Vec3 centre = roots_[r].box.centre();
      return Vec3{centre.x, centre.y, 0};
    };
    const std::size_t middle =
        model::halve_by_place(order, seen_from_above, [](int r) { return r; });
    return {order.first(middle), order.subspan(middle)};
  }

  void fill_cells(int node, const LocationLeaf& cells) {
    const Grid& grid = tree_.grids_[cells.grid];
    Box3 box;
    for_points(grid, cells, [&](const Vec3& p) { box.add(p); });
    set_box(tree_.nodes_[node], box, shape_);
    set_plane(tree_.nodes_[node], grid, cells, shape_);
    const std::vector<LocationLeaf> parts = quarters(cells);
    if (parts.size() == 1) {
      tree_.nodes_[node].first = static_cast<int>(tree_.leaves_.size());
      tree_.leaves_.push_back(cells);
      return;
    }
    const int first = add_children(node, static_cast<int>(parts.size()));
    for (std::size_t i = 0; i < parts.size(); ++i)
      fill_cells(first + static_cast<int>(i), parts[i]);
  }

  static std::vector<LocationLeaf> quarters(const LocationLeaf& c) {
    const auto cut = [](int begin, int end) {
      const int middle = end - begin > kLeafSide ? begin + (end - begin + 1) / 2 : end;
      std::vector<std::pair<int, int>> parts = {{begin, middle}};
      if (middle < end) parts.push_back({middle, end});
      return parts;
    };
    std::vector<LocationLeaf> parts;
    for (const auto& [v, v_end] : cut(c.v, c.v_end))
      for (const auto& [u, u_end] : cut(c.u, c.u_end))
        parts.push_back({c.grid, u, v, u_end, v_end});
    return parts;
  }

  LocationTree& tree_;
  const CutterShape& shape_;
  std::vector<Root> roots_;
};

LocationTree::LocationTree(std::vector<surface::Grid> grids, const CutterShape& shape)
    : grids_(std::move(grids)) {
  LocationTreeBuilder(*this, shape).build();
}

}  // namespace limitgauge::engine::strategy
