#include "verifier/cells/box_tree.h"

#include <algorithm>
#include <numeric>

namespace limitgauge::verifier {
namespace {

using model::Box3;
using model::Vec3;

std::uint32_t build(BoxTree& tree, const std::vector<Box3>& boxes, std::uint32_t leaf_size,
                    std::uint32_t first, std::uint32_t count) {
  const auto here = static_cast<std::uint32_t>(tree.nodes.size());
  tree.nodes.emplace_back();
  const auto elements = std::span(tree.order).subspan(first, count);
  Box3 box;
  for (const std::uint32_t k : elements) box.add(boxes[k]);
  tree.nodes[here].box = box;
  if (count <= leaf_size) {
    tree.nodes[here].first = first, tree.nodes[here].count = count;
    return here;
  }
  halve_by_centres(elements, boxes);
  const std::uint32_t half = count / 2;
  build(tree, boxes, leaf_size, first, half);
  const std::uint32_t right = build(tree, boxes, leaf_size, first + half, count - half);
  tree.nodes[here].right = right;
  return here;
}

}  // namespace

BoxTree box_tree(const std::vector<Box3>& boxes, std::uint32_t leaf_size) {
  BoxTree tree;
  if (boxes.empty()) return tree;
  const auto count = static_cast<std::uint32_t>(boxes.size());
  tree.order.resize(count);
  std::iota(tree.order.begin(), tree.order.end(), 0U);
  build(tree, boxes, leaf_size, 0, count);
  return tree;
}

void halve_by_centres(std::span<std::uint32_t> order, const std::vector<Box3>& boxes) {
  Box3 centres;
  for (const std::uint32_t k : order) centres.add(boxes[k].centre());
  const Vec3 size = centres.size();
  const int axis = size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
  const auto half = static_cast<std::ptrdiff_t>(order.size() / 2);
  std::nth_element(order.begin(), order.begin() + half, order.end(),
                   [&](std::uint32_t a, std::uint32_t b) {
                     const double ca = boxes[a].centre()[axis], cb = boxes[b].centre()[axis];
                     return ca != cb ? ca < cb : a < b;
                   });
}

}  // namespace limitgauge::verifier
