#include "reports/page/surface_data.h"

#include <algorithm>
#include <cmath>

namespace limitgauge::reports::page {
namespace {

using verifier::DeviationField;

/// Lines that are left of `count` where every `stride`-th is kept, both ends included.
std::uint32_t left_of(std::uint32_t count, std::uint32_t stride) {
  return (count - 1 + stride - 1) / stride + 1;
}

PageGrid thinned(const DeviationField& field, std::uint32_t stride) {
  PageGrid grid;
  grid.stride = stride;
  for (const DeviationField::Grid& g : field.grids)
    grid.patches.push_back({g, left_of(g.columns, stride), left_of(g.rows, stride)});
  return grid;
}

std::size_t cells(const PageGrid& grid) {
  std::size_t count = 0;
  for (const PageGrid::Patch& p : grid.patches) count += std::size_t(p.columns - 1) * (p.rows - 1);
  return count;
}

bool one_cell_each(const PageGrid& grid) {
  return std::all_of(grid.patches.begin(), grid.patches.end(),
                     [](const auto& p) { return p.columns == 2 && p.rows == 2; });
}

Json patch_json(const PageGrid::Patch& p) {
  Json out = {{"patch", p.measured.patch}, {"columns", p.columns}, {"rows", p.rows}};
  if (p.columns != p.measured.columns || p.rows != p.measured.rows)
    out["measured"] = {p.measured.columns, p.measured.rows};
  return out;
}

}  // namespace

PageGrid page_grid(const DeviationField& field, std::size_t most_cells) {
  PageGrid grid = thinned(field, 1);
  while (cells(grid) > most_cells && !one_cell_each(grid)) grid = thinned(field, grid.stride + 1);
  return grid;
}

std::uint32_t measured_index(std::uint32_t i, std::uint32_t shown, std::uint32_t measured) {
  const std::uint64_t steps = shown - 1;
  return static_cast<std::uint32_t>((2 * std::uint64_t(i) * (measured - 1) + steps) / (2 * steps));
}

std::uint32_t page_index(std::uint32_t k, std::uint32_t shown, std::uint32_t measured) {
  const std::uint64_t steps = measured - 1;
  return static_cast<std::uint32_t>((2 * std::uint64_t(k) * (shown - 1) + steps) / (2 * steps));
}

void visit_page_samples(const PageGrid& grid, const std::function<void(std::size_t)>& visit) {
  for (const PageGrid::Patch& p : grid.patches)
    for (std::uint32_t j = 0; j < p.rows; ++j)
      for (std::uint32_t i = 0; i < p.columns; ++i)
        visit(p.measured.first +
              std::size_t(measured_index(j, p.rows, p.measured.rows)) * p.measured.columns +
              measured_index(i, p.columns, p.measured.columns));
}

GridPoints on_grid(const std::vector<model::Vec3>& points) {
  model::Box3 box;
  for (const model::Vec3& p : points) box.add(p);
  GridPoints out;
  if (points.empty()) return out;
  double farthest = 0;
  for (int axis = 0; axis < 3; ++axis)
    farthest = std::max({farthest, std::abs(box.low[axis]), std::abs(box.high[axis])});
  out.step_mm = grid_step(length(box.size()), farthest);
  out.multiples.reserve(3 * points.size());
  for (const model::Vec3& p : points)
    for (int axis = 0; axis < 3; ++axis)
      out.multiples.push_back(static_cast<std::int32_t>(std::llround(p[axis] / out.step_mm)));
  return out;
}

Json points_block(const GridPoints& points, Blob& blob) {
  return {{"block", blob.add(points.multiples, 3)}, {"step_mm", points.step_mm}};
}

std::vector<std::int32_t> corners_of(std::span<const std::array<std::uint32_t, 3>> triangles) {
  std::vector<std::int32_t> corners;
  corners.reserve(3 * triangles.size());
  for (const auto& triangle : triangles)
    for (const std::uint32_t v : triangle) corners.push_back(static_cast<std::int32_t>(v));
  return corners;
}

std::size_t Surfaces::add(const DeviationField& field, const PageGrid& grid, Blob& blob) {
  std::vector<model::Vec3> places;
  visit_page_samples(grid, [&](std::size_t k) { places.push_back(field.samples[k].place.point); });
  GridPoints points = on_grid(places);
  Known surface{grid, points.step_mm, points.multiples};
  const auto same = std::find(known_.begin(), known_.end(), surface);
  if (same != known_.end()) return static_cast<std::size_t>(same - known_.begin());
  Json patches = Json::array();
  for (const PageGrid::Patch& p : grid.patches) patches.push_back(patch_json(p));
  json_.push_back({{"patches", std::move(patches)},
                   {"stride", grid.stride},
                   {"measured_samples", field.samples.size()},
                   {"position", points_block(points, blob)}});
  known_.push_back(std::move(surface));
  return known_.size() - 1;
}

}  // namespace limitgauge::reports::page
