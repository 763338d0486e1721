#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "model/base/run_control.h"
#include "model/part/toolpath.h"
#include "simulator/stock/stock_model.h"

namespace limitgauge::reports::page {

/// The picture of a stock has about so many triangles on a page at most.
inline constexpr std::size_t kMostStockTriangles = 120'000;

/// The simulated stock as a page shows it.
struct StockView {
  /// What a triangle's middle was made by.
  struct Maker {
    std::uint32_t pass = 0;  ///< 0: the raw stock, k: the k-th pass
    std::uint32_t move = 0;  ///< in the pass's path
    std::uint32_t line = 0;  ///< of its program; 0: of none
  };
  simulator::StockMesh mesh;          ///< its vertices are those of the simulated stock's surface
  std::vector<Maker> makers;          ///< one a triangle
  std::size_t surface_triangles = 0;  ///< of the surface that the picture was made of
  /// None of `checked` places, middles of triangles and of edges, lies further from the simulated
  /// stock, as it is exactly and not by its voxels.
  double within_mm = 0;
  std::size_t checked = 0;
};

/// The picture of `stock`, whose surface is `surface`, after `passes`, all that cut it. The same
/// for any number of threads. Throws Interrupted.
StockView stock_view(const simulator::StockModel& stock, const simulator::StockMesh& surface,
                     std::span<const model::Pass> passes, const model::RunControl& control);

}  // namespace limitgauge::reports::page
