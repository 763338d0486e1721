#include "verifier/cells/parameter_index.h"

#include <algorithm>

namespace limitgauge::verifier {
namespace {

double middle_of(double low, double high) {
  return low + (high - low) / 2;
}

bool is_point(const SurfaceCell& cell) {
  return length_squared(cell.vertex_normal) > 0 ||
         control_radius(cell.shape, cell.shape.control(0)) <= 0;
}

std::vector<IndexedCell> all_indexed(std::span<const SurfaceCell> cells) {
  std::vector<IndexedCell> out;
  out.reserve(cells.size());
  for (const SurfaceCell& cell : cells) out.push_back(indexed(cell));
  return out;
}

bool splits_cleanly(std::span<const IndexedCell> cells, const std::vector<std::uint32_t>& list,
                    bool in_u, double at) {
  return std::all_of(list.begin(), list.end(), [&](std::uint32_t k) {
    const ParameterRect& r = cells[k].rect;
    return in_u ? r.u1 <= at || r.u0 >= at : r.v1 <= at || r.v0 >= at;
  });
}

}  // namespace

IndexedCell indexed(const SurfaceCell& cell) {
  return {cell.patch, is_point(cell), rect_of(cell)};
}

ParameterRect ParameterIndex::half(const ParameterRect& r, bool in_u, bool high) {
  ParameterRect out = r;
  const double u = middle_of(r.u0, r.u1), v = middle_of(r.v0, r.v1);
  if (in_u)
    (high ? out.u0 : out.u1) = u;
  else
    (high ? out.v0 : out.v1) = v;
  return out;
}

ParameterIndex::ParameterIndex(std::span<const SurfaceCell> cells)
    : ParameterIndex(std::span<const IndexedCell>(all_indexed(cells))) {}

ParameterIndex::ParameterIndex(std::span<const IndexedCell> cells) {
  int patches = 0;
  for (const IndexedCell& cell : cells) patches = std::max(patches, cell.patch + 1);
  std::vector<std::vector<std::uint32_t>> lists(patches);
  for (std::uint32_t k = 0; k < cells.size(); ++k)
    if (!cells[k].is_point) lists[cells[k].patch].push_back(k);
  for (auto& list : lists)
    roots_.push_back(list.empty() ? -1 : build(cells, std::move(list), {0, 1, 0, 1}));
}

std::int32_t ParameterIndex::build(std::span<const IndexedCell> cells,
                                   std::vector<std::uint32_t> list, const ParameterRect& region) {
  const auto here = static_cast<std::int32_t>(nodes_.size());
  nodes_.emplace_back();
  const double u = middle_of(region.u0, region.u1), v = middle_of(region.v0, region.v1);
  // A cell alone may have a point beside it, which is no part of it.
  const bool is_whole = list.size() == 1 && cells[list.front()].rect.holds(region);
  const bool in_u = splits_cleanly(cells, list, true, u);
  if (is_whole || (!in_u && !splits_cleanly(cells, list, false, v))) {
    nodes_[here].first = static_cast<std::uint32_t>(order_.size());
    nodes_[here].count = static_cast<std::uint32_t>(list.size());
    order_.insert(order_.end(), list.begin(), list.end());
    return here;
  }
  nodes_[here].in_u = in_u;
  const auto upper = std::stable_partition(list.begin(), list.end(), [&](std::uint32_t k) {
    return in_u ? cells[k].rect.u1 <= u : cells[k].rect.v1 <= v;
  });
  std::vector<std::uint32_t> high(upper, list.end());
  list.erase(upper, list.end());
  if (!list.empty()) {
    const std::int32_t child = build(cells, std::move(list), half(region, in_u, false));
    nodes_[here].low = child;
  }
  if (!high.empty()) {
    const std::int32_t child = build(cells, std::move(high), half(region, in_u, true));
    nodes_[here].high = child;
  }
  return here;
}

std::optional<std::uint32_t> ParameterIndex::find(int patch, double u, double v) const {
  if (patch < 0 || patch >= patch_count() || roots_[patch] < 0) return std::nullopt;
  std::int32_t at = roots_[patch];
  ParameterRect region;
  while (at >= 0 && nodes_[at].count == 0) {
    const Node& node = nodes_[at];
    const bool high =
        node.in_u ? u > middle_of(region.u0, region.u1) : v > middle_of(region.v0, region.v1);
    // On the middle line both halves hold the place; one of them may be missing.
    const bool on_line =
        node.in_u ? u == middle_of(region.u0, region.u1) : v == middle_of(region.v0, region.v1);
    const bool go_high = high || (on_line && node.low < 0);
    at = go_high ? node.high : node.low;
    region = half(region, node.in_u, go_high);
  }
  if (at < 0) return std::nullopt;
  return order_[nodes_[at].first];
}

}  // namespace limitgauge::verifier
