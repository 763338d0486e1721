#include "simulator/stock/memory_forecast.h"

#include <cmath>
#include <set>

#include "model/base/clock.h"
#include "simulator/grid/block_cut.h"
#include "simulator/grid/stock_grid.h"
#include "simulator/stock/raw_stock.h"

namespace limitgauge::simulator {
namespace {

using Reach = BlockCutter::Reach;

// A leaf of 8³ floats, its mask, place and count, and what the allocator adds to the two of them.
constexpr double kLeafBytes = 2224;
// Tables of OpenVDB's inner nodes: 16³ and 32³ children and two masks each.
constexpr double kNodeBytes = 16 * 16 * 16 * (8 + 0.25), kUpperBytes = 32 * 32 * 32 * (8 + 0.25);
constexpr int kUpperEdge = 4096;  // of OpenVDB's upper inner nodes

// The blocks measured: of blocks with 20 leaves give or take 15, the mean is off by 5 % then.
constexpr std::size_t kSample = 200;

Reach cube_reach(const SweepIndex& pass, const Lattice& lattice, double band_mm,
                 const Index3& corner, int edge) {
  const double reach = lattice.half_diagonal(edge) + band_mm;
  const auto found = pass.nearest(lattice.middle(corner, edge), reach);
  if (!found) return Reach::none;
  return found->at.distance < -reach ? Reach::wholly : Reach::partly;
}

// May the surface or its band pass through the cube?
bool may_hold_band(const Material& material, const Lattice& lattice, const Index3& corner,
                   int edge) {
  const double band = kBandVoxels * lattice.voxel_mm;
  const double raw = raw_distance(material.raw(), lattice.middle(corner, edge)).distance;
  const double reach = lattice.half_diagonal(edge) + band;
  if (raw > reach) return false;
  bool any = raw >= -reach;
  for (const auto& pass : material.passes()) {
    const Reach r = cube_reach(*pass, lattice, band, corner, edge);
    if (r == Reach::wholly) return false;
    any = any || r == Reach::partly;
  }
  return any;
}

std::vector<Index3> band_blocks(const Material& material, const Lattice& lattice,
                                const model::RunControl& control) {
  const IndexBox extent = stock_extent(material.raw(), lattice);
  std::vector<Index3> nodes;
  each_cube(extent, kNodeEdge, [&](const Index3& c) { nodes.push_back(c); });
  std::vector<std::vector<Index3>> found(nodes.size());
  model::parallel_for(nodes.size(), control.threads, [&](std::size_t i) {
    control.check();
    if (!may_hold_band(material, lattice, nodes[i], kNodeEdge)) return;
    each_cube(cube_at(nodes[i], kNodeEdge).common(extent), kBlockEdge, [&](const Index3& block) {
      if (may_hold_band(material, lattice, block, kBlockEdge)) found[i].push_back(block);
    });
  });
  std::vector<Index3> blocks;
  for (const auto& part : found) blocks.insert(blocks.end(), part.begin(), part.end());
  return blocks;
}

struct Measured {
  std::size_t leaves = 0;
  double cut_seconds = 0, all_seconds = 0;
};

// One block, without the leaves beside it that a tile has.
Measured measure(const Material& material, const Lattice& lattice, const Index3& block) {
  const model::Stopwatch whole;
  Measured m;
  StockGrid grid(material.raw(), lattice, cube_at(block, kBlockEdge), 0, {});
  for (const auto& pass : material.passes()) {
    const model::Stopwatch watch;
    const PassReach reach = grid.reach(*pass, {});
    grid = std::move(grid).cut(*pass, reach, {});
    m.cut_seconds = watch.seconds();
  }
  m.all_seconds = whole.seconds();
  m.leaves = GridLeaves(grid).size();
  return m;
}

double inner_node_bytes(const std::vector<Index3>& blocks) {
  const auto count = [&](int edge) {
    std::set<Index3> cubes;
    for (const Index3& b : blocks)
      each_cube(cube_at(b, 1), edge, [&](const Index3& c) { cubes.insert(c); });
    return static_cast<double>(cubes.size());
  };
  return count(kNodeEdge) * kNodeBytes + count(kUpperEdge) * kUpperBytes;
}

}  // namespace

GridForecast forecast_grid(const Material& material, const Lattice& lattice,
                           const model::RunControl& control) {
  GridForecast forecast;
  forecast.blocks = band_blocks(material, lattice, control);
  const std::size_t blocks = forecast.blocks.size(), sample = std::min(blocks, kSample);
  std::vector<Measured> measured(sample);
  model::parallel_for(sample, control.threads, [&](std::size_t i) {
    control.check();
    measured[i] = measure(material, lattice, forecast.blocks[i * blocks / sample]);
  });
  double leaves = 0;
  for (const Measured& m : measured) {
    leaves += static_cast<double>(m.leaves);
    forecast.cut_seconds += m.cut_seconds;
    forecast.all_seconds += m.all_seconds;
  }
  if (sample == 0) return forecast;
  const double scale = static_cast<double>(blocks) / static_cast<double>(sample);
  forecast.cut_seconds *= scale / std::max(1U, control.threads);
  forecast.all_seconds *= scale / std::max(1U, control.threads);
  forecast.bytes = leaves * scale * kLeafBytes + inner_node_bytes(forecast.blocks);
  forecast.bytes_a_block = forecast.bytes / static_cast<double>(blocks);
  return forecast;
}

double pass_bytes(const Material& material) {
  double bytes = 0;
  for (const auto& pass : material.passes()) bytes += static_cast<double>(pass->memory_bytes());
  return bytes;
}

double two_digits_up(double x) {
  const double unit = std::pow(10.0, std::floor(std::log10(x)) - 1);
  return std::ceil(x / unit) * unit;
}

}  // namespace limitgauge::simulator
