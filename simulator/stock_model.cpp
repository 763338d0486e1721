#include "simulator/stock_model.h"

#include <cmath>
#include <limits>
#include <stdexcept>
#include <utility>

#include "simulator/material.h"
#include "simulator/stock_grid.h"
#include "simulator/surface_points.h"

namespace limitgauge::simulator {
namespace {

Lattice lattice_of(const model::Stock& raw, double voxel_mm) {
  if (!(voxel_mm > 0) || !std::isfinite(voxel_mm))
    throw std::invalid_argument("the voxel must be a positive number");
  require_valid(raw);
  // Voxel centres on the lower faces: a block whose size is a multiple of the voxel has its exact
  // volume.
  return {bounding_box(raw).low, voxel_mm};
}

}  // namespace

struct StockModel::State {
  Material material;
  StockGrid grid;
  std::size_t memory_limit_bytes = 0;
};

StockModel::StockModel(const model::Stock& raw, double voxel_mm, std::size_t memory_limit_bytes)
    : state_(std::make_shared<const State>(
          State{Material(raw), StockGrid(raw, lattice_of(raw, voxel_mm), memory_limit_bytes),
                memory_limit_bytes})) {}

StockModel::StockModel(std::shared_ptr<const State> state) : state_(std::move(state)) {}
StockModel::~StockModel() = default;
StockModel::StockModel(const StockModel&) = default;
StockModel& StockModel::operator=(const StockModel&) = default;
StockModel::StockModel(StockModel&&) noexcept = default;
StockModel& StockModel::operator=(StockModel&&) noexcept = default;

StockModel StockModel::cut(const Pass& pass, const model::RunControl& control) const {
  auto sweep = std::make_shared<const SweepIndex>(pass, control);
  StockGrid grid =
      state_->grid.cut(state_->material.raw(), *sweep, state_->memory_limit_bytes, control);
  return StockModel(std::make_shared<const State>(
      State{state_->material.after(sweep), std::move(grid), state_->memory_limit_bytes}));
}

double StockModel::voxel_mm() const {
  return state_->grid.lattice().voxel_mm;
}
double StockModel::band_mm() const {
  return state_->grid.band_mm();
}
double StockModel::volume_mm3() const {
  return state_->grid.volume_mm3();
}
double StockModel::value(const model::Vec3& p_mm) const {
  return state_->grid.value(p_mm);
}
double StockModel::exact_value(const model::Vec3& p_mm) const {
  return state_->material.sample(p_mm).value;
}
const Material& StockModel::material() const {
  return state_->material;
}

const StockGrid& StockModel::grid() const {
  return state_->grid;
}

std::size_t StockModel::memory_bytes() const {
  std::size_t bytes = state_->grid.memory_bytes();
  for (const auto& pass : state_->material.passes()) bytes += pass->memory_bytes();
  return bytes;
}

std::vector<StockPoint> StockModel::surface_points(const model::RunControl& control) const {
  constexpr double kEverywhere = std::numeric_limits<double>::infinity();
  const model::Vec3 corner{kEverywhere, kEverywhere, kEverywhere};
  return surface_points({-corner, corner}, control);
}
std::vector<StockPoint> StockModel::surface_points(const model::Box3& region,
                                                   const model::RunControl& control) const {
  return project_surface(state_->material, state_->grid, region, control);
}
StockMesh StockModel::surface_mesh() const {
  return state_->grid.mesh();
}
void StockModel::write_vdb(const std::filesystem::path& file) const {
  state_->grid.write(file);
}

}  // namespace limitgauge::simulator
