#include "model/geometry/box_tree.h"

#include <numeric>

namespace limitgauge::model {
namespace {

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
  const auto half = static_cast<std::uint32_t>(halve_by_centres(elements, boxes));
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

std::size_t halve_by_centres(std::span<std::uint32_t> part, const std::vector<Box3>& boxes) {
  return halve_by_place(
      part, [&](std::uint32_t k) { return boxes[k].centre(); }, [](std::uint32_t k) { return k; });
}

std::vector<std::pair<std::size_t, std::size_t>> element_ranges(const std::vector<BoxNode>& nodes) {
  std::vector<std::pair<std::size_t, std::size_t>> ranges(nodes.size());
  for (std::size_t at = nodes.size(); at-- > 0;) {
    const BoxNode& node = nodes[at];
    ranges[at] = node.count > 0
                     ? std::pair<std::size_t, std::size_t>{node.first, node.first + node.count}
                     : std::pair{ranges[at + 1].first, ranges[node.right].second};
  }
  return ranges;
}

}  // namespace limitgauge::model
