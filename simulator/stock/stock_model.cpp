#include "simulator/stock/stock_model.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <limits>
#include <optional>
#include <stdexcept>
#include <utility>

#include "model/base/chunks.h"
#include "simulator/grid/stock_grid.h"
#include "simulator/mesh/mesh_placer.h"
#include "simulator/mesh/surface_points.h"
#include "simulator/stock/material.h"
#include "simulator/stock/raw_stock.h"
#include "simulator/stock/stock_layout.h"
#include "simulator/stock/tiled_stock.h"
#include "simulator/tolerance.h"

namespace limitgauge::simulator {
namespace {

using model::RunControl;

constexpr double kEverywhere = std::numeric_limits<double>::infinity();
// Leaves of a block that the surface fills with its band, all of them new.
constexpr double kMostBlockBytes = 64 * 2300;

constexpr int kCoarsestMesh = 16;

Lattice lattice_of(const RawStock& raw, double voxel_mm) {
  if (!(voxel_mm > 0) || !std::isfinite(voxel_mm))
    throw std::invalid_argument("the voxel must be a positive number");
  // Voxel centres on the lower faces: a block whose size is a multiple of the voxel has its exact
  // volume.
  return {raw.box().low, voxel_mm};
}

Lattice coarser(const Lattice& lattice, int times) {
  return {lattice.origin_mm, times * lattice.voxel_mm};
}

StockGrid whole_grid(const Material& material, const Lattice& lattice, const RunControl& control) {
  return build_grid(material, lattice, stock_extent(material.raw(), lattice), control);
}

}  // namespace

struct StockModel::State {
  Material material;
  Lattice lattice;
  StockGrid grid;
  std::size_t memory_limit_bytes = 0;
  int coarsening = 1;
  std::optional<TiledStock> tiled;

  static std::shared_ptr<State> built(const Material& material, const Lattice& lattice,
                                      std::size_t limit, const StockLayout& layout,
                                      const RunControl& control) {
    if (layout.whole)
      return std::make_shared<State>(
          State{material, lattice, whole_grid(material, lattice, control), limit, 1, {}});
    const Lattice coarse = coarser(lattice, layout.coarsening);
    State state{material, lattice,           whole_grid(material, coarse, part_of(control, 0, 0.1)),
                limit,    layout.coarsening, {}};
    state.tiled.emplace(material, lattice, layout.tiles, part_of(control, 0.1, 1));
    return std::make_shared<State>(std::move(state));
  }

  /// Does the whole grid fit after a pass that reaches so far? `copies` of this one stand beside.
  bool fits(const Material& after, const PassReach& reach, int copies,
            const RunControl& control) const {
    const auto limit = static_cast<double>(memory_limit_bytes);
    const auto bytes = static_cast<double>(grid.memory_bytes());
    const double before = copies * bytes;
    const double most = before + pass_bytes(after) + bytes +
                        static_cast<double>(reach.partly.size()) * kMostBlockBytes;
    if (most <= limit) return true;
    return before + pass_bytes(after) + forecast_grid(after, lattice, control).bytes <= limit;
  }
};

StockModel::StockModel(const model::Stock& stock, double voxel_mm, std::size_t memory_limit_bytes,
                       const RunControl& control) {
  const RawStock raw(stock);
  const Material material(raw);
  const Lattice lattice = lattice_of(raw, voxel_mm);
  const StockLayout layout = choose_layout(material, lattice, memory_limit_bytes, control);
  state_ = State::built(material, lattice, memory_limit_bytes, layout, control);
}

StockModel::StockModel(std::shared_ptr<State> state) : state_(std::move(state)) {}
StockModel::~StockModel() = default;
StockModel::StockModel(const StockModel&) = default;
StockModel& StockModel::operator=(const StockModel&) = default;
StockModel::StockModel(StockModel&&) noexcept = default;
StockModel& StockModel::operator=(StockModel&&) noexcept = default;

StockModel StockModel::cut(const Pass& pass, const RunControl& control) const& {
  return StockModel(*this).cut(pass, control);
}

StockModel StockModel::cut(const Pass& pass, const RunControl& control) && {
  const auto sweep = std::make_shared<const SweepIndex>(pass, control);
  const Material after = state_->material.after(sweep);
  const std::size_t limit = state_->memory_limit_bytes;
  const Lattice lattice = state_->lattice;
  if (!state_->tiled) {
    const bool shared = state_.use_count() > 1 || state_->grid.shared();
    const PassReach reach = state_->grid.reach(*sweep, control);
    if (state_->fits(after, reach, shared ? 1 : 0, control)) {
      StockGrid grid = shared ? state_->grid : std::move(state_->grid);
      state_.reset();
      return StockModel(std::make_shared<State>(
          State{after, lattice, std::move(grid).cut(*sweep, reach, control), limit, 1, {}}));
    }
  }
  state_.reset();
  StockLayout layout = choose_layout(after, lattice, limit, control);
  return StockModel(State::built(after, lattice, limit, layout, control));
}

CutForecast StockModel::forecast(const Pass& pass, const RunControl& control) const {
  const Material after = state_->material.after(std::make_shared<const SweepIndex>(pass, control));
  const StockLayout layout =
      choose_layout(after, state_->lattice, state_->memory_limit_bytes, control);
  const double seconds = layout.whole ? layout.forecast.cut_seconds : layout.forecast.all_seconds;
  return {layout.bytes, seconds, layout.forecast.blocks.size(), !layout.whole};
}

double StockModel::voxel_mm() const {
  return state_->lattice.voxel_mm;
}
double StockModel::band_mm() const {
  return kBandVoxels * state_->lattice.voxel_mm;
}
double StockModel::volume_mm3(const RunControl& control) const {
  const double v = voxel_mm();
  const GridVolume volume = state_->tiled ? state_->tiled->volume() : state_->grid.volume(control);
  return volume.voxels(state_->material, state_->lattice, control) * v * v * v;
}
double StockModel::value(const model::Vec3& p_mm) const {
  if (state_->tiled) return interpolated_value(state_->material, state_->lattice, p_mm);
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
int StockModel::coarsening() const {
  return state_->coarsening;
}
std::size_t StockModel::tiles() const {
  return state_->tiled ? state_->tiled->size() : 0;
}
ColumnTops StockModel::column_tops(const RunControl& control) const {
  return state_->tiled ? state_->tiled->column_tops() : state_->grid.column_tops(control);
}

std::size_t StockModel::memory_bytes() const {
  return state_->grid.memory_bytes() + state_->material.raw().memory_bytes() +
         static_cast<std::size_t>(pass_bytes(state_->material));
}

std::vector<StockPoint> StockModel::surface_points(const RunControl& control) const {
  const model::Vec3 corner{kEverywhere, kEverywhere, kEverywhere};
  return surface_points({-corner, corner}, control);
}

std::vector<StockPoint> StockModel::surface_points(const model::Box3& region,
                                                   const RunControl& control) const {
  std::vector<StockPoint> all;
  visit_surface_points(
      region,
      [&](std::span<const StockPoint> some) { all.insert(all.end(), some.begin(), some.end()); },
      control);
  return all;
}

void StockModel::visit_surface_points(const model::Box3& region,
                                      const std::function<void(std::span<const StockPoint>)>& visit,
                                      const RunControl& control) const {
  const Material& material = state_->material;
  if (!state_->tiled) return visit_points(material, state_->grid, region, visit, control);
  state_->tiled->each_tile(material, region, control,
                           [&](const StockGrid& tile, const RunControl& part) {
                             visit_points(material, tile, region, visit, part);
                           });
}

StockSurface StockModel::surface(const RunControl& control) const {
  const StockGrid& grid = state_->grid;
  const Material& material = state_->material;
  const double left =
      static_cast<double>(state_->memory_limit_bytes) - static_cast<double>(memory_bytes());
  std::atomic<std::size_t> unmoved = 0;
  auto net = grid.mesh_within(left, exact_placers(material, grid.lattice(), unmoved), control);
  if (auto* mesh = std::get_if<model::TriangleMesh>(&net))
    return {std::move(*mesh), grid.lattice().voxel_mm, unmoved};
  // Both the mesh and its grid go with the inverse square of the voxel.
  const double both = std::get<NetSize>(net).bytes() + static_cast<double>(grid.memory_bytes());
  const int times = std::clamp(static_cast<int>(std::ceil(std::sqrt(both / std::max(left, 1.0)))),
                               2, kCoarsestMesh);
  const Lattice wider = coarser(grid.lattice(), times);
  const StockGrid coarse = whole_grid(material, wider, control);
  StockMesh mesh = coarse.mesh(exact_placers(material, wider, unmoved), control);
  return {std::move(mesh), wider.voxel_mm, unmoved};
}

StockMesh StockModel::cut_part_of(const StockMesh& mesh, const RunControl& control) const {
  constexpr std::size_t kChunk = 4096;
  constexpr std::uint32_t kLeftOut = 0xffffffff;
  const RawStock& raw = state_->material.raw();
  const auto is_raw = [&](const Vec3& p) {
    return std::abs(raw.distance(p).distance) <= kOnSurface_mm;
  };
  std::vector<char> on_raw(mesh.vertices.size());
  model::parallel_chunks(on_raw.size(), kChunk, control, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) on_raw[i] = is_raw(mesh.vertices[i]);
  });
  std::vector<char> kept(mesh.triangles.size());
  model::parallel_chunks(kept.size(), kChunk, control, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      const auto& t = mesh.triangles[i];
      kept[i] = !on_raw[t[0]] || !on_raw[t[1]] || !on_raw[t[2]] ||
                !is_raw((mesh.vertices[t[0]] + mesh.vertices[t[1]] + mesh.vertices[t[2]]) / 3);
    }
  });
  StockMesh cut;
  model::reserve_large(cut.triangles,
                       static_cast<std::size_t>(std::count(kept.begin(), kept.end(), 1)));
  // More than are taken, of which the rest is never touched: growing would hold them twice.
  model::reserve_large(cut.vertices, mesh.vertices.size());
  std::vector<std::uint32_t> place(mesh.vertices.size(), kLeftOut);
  for (std::size_t i = 0; i < kept.size(); ++i) {
    if (!kept[i]) continue;
    std::array<std::uint32_t, 3> t = mesh.triangles[i];
    for (std::uint32_t& v : t) {
      if (place[v] == kLeftOut) {
        place[v] = static_cast<std::uint32_t>(cut.vertices.size());
        cut.vertices.push_back(mesh.vertices[v]);
      }
      v = place[v];
    }
    cut.triangles.push_back(t);
  }
  return cut;
}

StockMesh StockModel::surface_mesh(const RunControl& control) const {
  return state_->grid.mesh(middle_placers(), control);
}

void StockModel::write_vdb(const std::filesystem::path& file, const model::Pose& pose) const {
  const double own_mm = model::kBluntVoxels * state_->coarsening * state_->lattice.voxel_mm;
  state_->grid.write(file, pose, own_mm + model::blunt_mm(state_->material.raw().stock()));
}

}  // namespace limitgauge::simulator
