#include "reports/page/stock_view.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "model/base/chunks.h"
#include "reports/page/mesh_reduction.h"
#include "simulator/instrument/stock_rays.h"
#include "simulator/stock/material.h"

namespace limitgauge::reports::page {
namespace {

using model::Vec3;
using simulator::StockMesh;

constexpr std::size_t kMostChecked = 20'000;
constexpr std::size_t kChunk = 512;
/// Rounding.
constexpr double kOnSurface_mm = 1e-9;
/// Far below what can be seen.
constexpr double kAside_mm = 1e-5;
/// Middle of the triangle and of its three edges.
constexpr std::size_t kPlacesOfTriangle = 4;

struct Corners {
  Vec3 a, b, c;
  Vec3 middle() const { return (a + b + c) / 3; }
  Vec3 place(std::size_t k) const {
    return k == 0 ? middle() : (k == 1 ? a + b : k == 2 ? b + c : c + a) / 2;
  }
  Vec3 across() const { return cross(b - a, c - a); }
};

Corners corners(const StockMesh& mesh, std::size_t triangle) {
  const auto& t = mesh.triangles[triangle];
  return {mesh.vertices[t[0]], mesh.vertices[t[1]], mesh.vertices[t[2]]};
}

StockView::Maker maker_at(const simulator::Material& material, const Vec3& p,
                          std::span<const model::Pass> passes) {
  const simulator::SurfaceMaker found = material.sample(p).maker;
  if (found.pass == 0 || found.pass > passes.size()) return {};
  const std::uint32_t move = material.passes()[found.pass - 1]->own().move(found.slot).index;
  const auto& moves = passes[found.pass - 1].path->moves;
  return {found.pass, move,
          move < moves.size() ? static_cast<std::uint32_t>(moves[move].line) : 0U};
}

/// Where a way through `p` from `reach_mm` before to `reach_mm` behind it meets the surface first,
/// as its distance from `p`. It starts away from `p`: one that lies on the surface is on neither
/// side.
std::optional<double> crossing_mm(const simulator::StockRays& rays, const Vec3& p, const Vec3& way,
                                  double reach_mm) {
  const simulator::StockRays::Run run = rays.run(p - way * reach_mm, way, 2 * reach_mm);
  if (!run.ends) return std::nullopt;
  return std::abs(run.length_mm - reach_mm) + run.error_mm;
}

/// Of the ways through `p` along some directions the nearest crossing, within `reach_mm`.
std::optional<double> crossing_mm(const simulator::StockRays& rays, const Vec3& p,
                                  std::span<const Vec3> ways, double reach_mm) {
  std::optional<double> least_mm;
  for (const Vec3& way : ways) {
    const double size = length(way);
    if (!(size > 0)) continue;
    const std::optional<double> found_mm = crossing_mm(rays, p, way / size, reach_mm);
    if (found_mm && (!least_mm || *found_mm < *least_mm)) least_mm = found_mm;
  }
  return least_mm;
}

/// An upper bound of the way to the surface, along the triangle's normal, the gradient or an axis.
/// Where these glide along a face and meet nothing, from a place within kAside_mm. `most_mm` where
/// none comes to it.
double distance_mm(const simulator::StockModel& stock, const simulator::StockRays& rays,
                   const Vec3& p, const Vec3& across, double most_mm) {
  constexpr double kLeastReach_mm = 1e-3, kWider = 8;
  const simulator::MaterialSample here = stock.material().sample(p);
  if (std::abs(here.value) <= kOnSurface_mm) return kOnSurface_mm;
  const std::array<Vec3, 5> ways = {across, here.gradient, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  for (double reach_mm = 2 * std::abs(here.value) + kLeastReach_mm; reach_mm < most_mm;
       reach_mm *= kWider) {
    if (const auto found_mm = crossing_mm(rays, p, ways, reach_mm)) return *found_mm;
    for (int k = 0; k < 8; ++k) {
      const auto side = [k](int axis) { return (k >> axis) % 2 == 0 ? kAside_mm : -kAside_mm; };
      const Vec3 aside{side(0) / 3, side(1) / 2, side(2) / 2};
      if (const auto found_mm = crossing_mm(rays, p + aside, ways, reach_mm))
        return *found_mm + length(aside);
    }
  }
  return most_mm;
}

void check(const simulator::StockModel& stock, StockView& view, const model::RunControl& control) {
  const std::size_t places = kPlacesOfTriangle * view.mesh.triangles.size();
  view.checked = std::min(places, kMostChecked);
  const simulator::StockRays rays(stock);
  const double most_mm = length(bounding_box(view.mesh).size());
  std::vector<double> found(view.checked);
  model::parallel_chunks(found.size(), kChunk, control, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      const std::size_t place = i * places / found.size();
      const Corners t = corners(view.mesh, place / kPlacesOfTriangle);
      found[i] = distance_mm(stock, rays, t.place(place % kPlacesOfTriangle), t.across(), most_mm);
    }
  });
  for (const double mm : found) view.within_mm = std::max(view.within_mm, mm);
}

}  // namespace

StockView stock_view(const simulator::StockModel& stock, const StockMesh& surface,
                     std::span<const model::Pass> passes, const model::RunControl& control) {
  StockView view;
  view.surface_triangles = surface.triangles.size();
  view.mesh = reduced(surface, kMostStockTriangles, control);
  view.makers.resize(view.mesh.triangles.size());
  model::parallel_chunks(
      view.makers.size(), kChunk, control, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i)
          view.makers[i] = maker_at(stock.material(), corners(view.mesh, i).middle(), passes);
      });
  check(stock, view, control);
  return view;
}

}  // namespace limitgauge::reports::page
