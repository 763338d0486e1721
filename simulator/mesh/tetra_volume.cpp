#include "simulator/mesh/tetra_volume.h"

#include <algorithm>

namespace limitgauge::simulator {
namespace {

// Share of a tetrahedron where a linear field with these ascending corner values is negative.
double sorted_share(const std::array<double, 4>& v) {
  if (v[3] <= 0) return 1;
  if (v[0] >= 0) return 0;
  if (v[1] >= 0) {
    const double a = -v[0];
    return a * a * a / ((v[1] - v[0]) * (v[2] - v[0]) * (v[3] - v[0]));
  }
  if (v[2] <= 0) {
    const double b = v[3];
    return 1 - b * b * b / ((v[3] - v[0]) * (v[3] - v[1]) * (v[3] - v[2]));
  }
  // Two below, two above: the wedge is cut into three tetrahedra.
  const double s02 = v[0] / (v[0] - v[2]), s03 = v[0] / (v[0] - v[3]);
  const double s12 = v[1] / (v[1] - v[2]), s13 = v[1] / (v[1] - v[3]);
  return s02 * s03 * (1 - s13) + s02 * s13 * (1 - s12) + s12 * s13;
}

}  // namespace

double negative_share(const std::array<double, 8>& f) {
  constexpr int kPaths[6][2] = {{1, 3}, {1, 5}, {2, 3}, {2, 6}, {4, 5}, {4, 6}};
  double share = 0;
  for (const auto& path : kPaths) {
    std::array<double, 4> v{f[0], f[path[0]], f[path[1]], f[7]};
    std::sort(v.begin(), v.end());
    share += sorted_share(v);
  }
  return share / 6;
}

}  // namespace limitgauge::simulator
