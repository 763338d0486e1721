#include "simulator/instrument/dexel_stock.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

#include "simulator/instrument/dexel_cut.h"
#include "simulator/sweep/sweep_tree.h"

namespace limitgauge::simulator {
namespace {

constexpr int kEdge = DexelTile::kEdge;

DexelLattice lattice_of(const model::Box3& box, double spacing_mm) {
  if (!(spacing_mm > 0) || !std::isfinite(spacing_mm))
    throw std::invalid_argument("the spacing of lines must be a positive number");
  return {box, spacing_mm};
}

}  // namespace

struct DexelStock::State {
  DexelLattice lattice;
  DexelTiles tiles;

  const DexelTile& tile(int i, int j) const { return *tiles[lattice.tile(i / kEdge, j / kEdge)]; }
};

DexelStock::DexelStock(const model::Stock& stock, double spacing_mm) {
  const RawStock raw(stock);
  const DexelLattice lattice = lattice_of(raw.box(), spacing_mm);
  state_ = std::make_shared<const State>(State{lattice, raw_tiles(raw, lattice)});
}

DexelStock::DexelStock(
    const model::Box3& box, double spacing_mm,
    const std::function<std::vector<model::Interval>(double x, double y)>& standing,
    const model::RunControl& control) {
  const DexelLattice lattice = lattice_of(box, spacing_mm);
  state_ = std::make_shared<const State>(State{lattice, tiles_of(standing, lattice, control)});
}

DexelStock::DexelStock(std::shared_ptr<const State> state) : state_(std::move(state)) {}

DexelStock::Cut DexelStock::cut(const Pass& pass, const model::RunControl& control) const {
  if (pass.pose != model::Pose{})
    throw std::invalid_argument("a pass of another setup is to be cut in that setup's lines");
  if (pass.axes)
    throw std::invalid_argument("lines are not cut by a pass that turns its tool as it goes");
  require_path(pass);
  DexelTiles tiles = state_->tiles;
  std::vector<MoveRemoval> moves = cut_tiles(state_->lattice, tiles, pass, control);
  const RemovalTotals totals = removal_totals(*pass.path, moves, spacing_mm());
  return {DexelStock(std::make_shared<const State>(State{state_->lattice, std::move(tiles)})),
          {std::move(moves), totals}};
}

double DexelStock::spacing_mm() const {
  return std::max(state_->lattice.dx, state_->lattice.dy);
}
int DexelStock::nx() const {
  return state_->lattice.nx;
}
int DexelStock::ny() const {
  return state_->lattice.ny;
}
model::Vec3 DexelStock::line_at(int i, int j) const {
  return state_->lattice.line_at(i, j);
}

double DexelStock::length(int i, int j) const {
  return state_->tile(i, j).length(DexelTile::line(i % kEdge, j % kEdge));
}

double DexelStock::volume_mm3() const {
  double sum = 0;
  for (int j = 0; j < ny(); ++j)
    for (int i = 0; i < nx(); ++i) sum += length(i, j);
  return sum * state_->lattice.cell_mm2();
}

double DexelStock::volume_error_mm3() const {
  // A step of height H gives two second differences of H: a quarter of each is the half that it
  // may count too much or too little. Beyond the box the length goes on as it is.
  double sum = 0;
  for (int j = 0; j < ny(); ++j)
    for (int i = 0; i < nx(); ++i) {
      const double twice = 2 * length(i, j);
      const double west = length(std::max(i - 1, 0), j),
                   east = length(std::min(i + 1, nx() - 1), j);
      const double south = length(i, std::max(j - 1, 0));
      const double north = length(i, std::min(j + 1, ny() - 1));
      sum += std::abs(west + east - twice) + std::abs(south + north - twice);
    }
  return sum / 4 * state_->lattice.cell_mm2();
}

double DexelStock::surface_area_mm2() const {
  // Shadows: two ends an interval along z, and every change of the length along x and y.
  const DexelLattice& lattice = state_->lattice;
  double level = 0, along_x = 0, along_y = 0;
  for (int j = 0; j < ny(); ++j)
    for (int i = 0; i < nx(); ++i) {
      const double own = length(i, j);
      level += 2 * static_cast<double>(material(i, j).size());
      along_x += std::abs(own - (i > 0 ? length(i - 1, j) : 0)) + (i + 1 < nx() ? 0 : own);
      along_y += std::abs(own - (j > 0 ? length(i, j - 1) : 0)) + (j + 1 < ny() ? 0 : own);
    }
  return level * lattice.cell_mm2() + along_x * lattice.dy + along_y * lattice.dx;
}

std::size_t DexelStock::memory_bytes() const {
  std::size_t bytes = 0;
  for (const auto& tile : state_->tiles) bytes += tile->memory_bytes();
  return bytes;
}

std::vector<model::Interval> DexelStock::material(int i, int j) const {
  return state_->tile(i, j).material(DexelTile::line(i % kEdge, j % kEdge));
}

}  // namespace limitgauge::simulator
