#include "simulator/process/clearance_map.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace limitgauge::simulator {
namespace {

double level_distance(const SweptMove& m, double x, double y) {
  const double qx = x - m.start.x, qy = y - m.start.y;
  const double t = std::clamp((qx * m.delta.x + qy * m.delta.y) * m.inverse_run2, 0.0, 1.0);
  const double ex = qx - t * m.delta.x, ey = qy - t * m.delta.y;
  return std::sqrt(ex * ex + ey * ey);
}

}  // namespace

ClearanceMap::ClearanceMap(const ColumnTops& tops) : corner_(tops.corner_mm) {
  levels_.push_back({tops.nx, tops.ny, tops.edge_mm, tops.top_mm});
  while (levels_.back().nx > 1 || levels_.back().ny > 1) {
    const Level& fine = levels_.back();
    Level coarse{(fine.nx + 1) / 2, (fine.ny + 1) / 2, fine.edge * 2, {}};
    coarse.top.assign(static_cast<std::size_t>(coarse.nx) * coarse.ny,
                      -std::numeric_limits<double>::infinity());
    for (int j = 0; j < fine.ny; ++j)
      for (int i = 0; i < fine.nx; ++i) {
        double& top = coarse.top[(j / 2) * coarse.nx + i / 2];
        top = std::max(top, fine.top[j * fine.nx + i]);
      }
    levels_.push_back(std::move(coarse));
  }
}

bool ClearanceMap::clears(const CutterProfile& body, const SweptMove& move,
                          double margin_mm) const {
  return clears(levels_.size() - 1, 0, 0, body, move, margin_mm);
}

bool ClearanceMap::clears(std::size_t at, int i, int j, const CutterProfile& body,
                          const SweptMove& move, double margin_mm) const {
  const Level& level = levels_[at];
  const double x = corner_.x + (i + 0.5) * level.edge, y = corner_.y + (j + 0.5) * level.edge;
  const double nearest =
      std::max(0.0, level_distance(move, x, y) - std::sqrt(0.5) * level.edge - margin_mm);
  const double lowest = std::min(move.start.z, move.start.z + move.delta.z);
  if (level.top[j * level.nx + i] <= lowest + body.nose_height(nearest) - margin_mm) return true;
  if (at == 0) return false;
  const Level& fine = levels_[at - 1];
  for (int v = 2 * j; v < std::min(2 * j + 2, fine.ny); ++v)
    for (int u = 2 * i; u < std::min(2 * i + 2, fine.nx); ++u)
      if (!clears(at - 1, u, v, body, move, margin_mm)) return false;
  return true;
}

}  // namespace limitgauge::simulator
