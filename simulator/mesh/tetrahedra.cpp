#include "simulator/mesh/tetrahedra.h"

#include <algorithm>
#include <utility>

namespace limitgauge::simulator {
namespace {

using model::Vec3;

// A tetrahedron of a cell: from corner 0 along three axes, one after the other, to corner 7.
struct Tetra {
  std::array<int, 4> corner;
  bool positive;  // right-handed
};
constexpr std::array<Tetra, 6> kTetras = {{{{0, 1, 3, 7}, false},
                                           {{0, 1, 5, 7}, true},
                                           {{0, 2, 3, 7}, true},
                                           {{0, 2, 6, 7}, false},
                                           {{0, 4, 5, 7}, false},
                                           {{0, 4, 6, 7}, true}}};

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

bool even(const std::array<int, 4>& order) {
  int inversions = 0;
  for (int i = 0; i < 4; ++i)
    for (int j = i + 1; j < 4; ++j) inversions += order[i] > order[j];
  return inversions % 2 == 0;
}

class Cell {
 public:
  Cell(const std::array<double, 8>& f, const Index3& low, const Lattice& lattice,
       model::TriangleSoup& soup)
      : f_(f), low_(low), lattice_(lattice), soup_(soup) {}

  void cut(const Tetra& t) {
    std::array<int, 4> order{};  // those inside first
    int inside = 0, outside = 4;
    for (int k = 3; k >= 0; --k)
      if (!(f_[t.corner[k]] <= 0)) order[--outside] = k;
    for (int k = 0; k < 4; ++k)
      if (f_[t.corner[k]] <= 0) order[inside++] = k;
    if (inside == 0 || inside == 4) return;
    const bool forwards = even(order) == t.positive;
    const auto point = [&](int i, int j) {
      return crossing(t.corner[order[i]], t.corner[order[j]]);
    };
    if (inside == 1) return add(forwards, {point(0, 1), point(0, 2), point(0, 3)});
    if (inside == 3) return add(forwards, {point(0, 3), point(1, 3), point(2, 3)});
    const Vec3 a = point(0, 2), b = point(0, 3), c = point(1, 3), d = point(1, 2);
    add(forwards, {a, b, c});
    add(forwards, {a, c, d});
  }

 private:
  Vec3 place(int corner) const {
    return lattice_.point(
        {low_[0] + (corner >> 2 & 1), low_[1] + (corner >> 1 & 1), low_[2] + (corner & 1)});
  }
  // The lower corner first, so that every tetrahedron at the edge finds the same bits.
  Vec3 crossing(int a, int b) const {
    if (a > b) std::swap(a, b);
    return lerp(place(a), place(b), f_[a] / (f_[a] - f_[b]));
  }
  void add(bool forwards, const std::array<Vec3, 3>& t) {
    const auto first = static_cast<std::uint32_t>(soup_.vertices.size());
    soup_.vertices.insert(soup_.vertices.end(), t.begin(), t.end());
    if (forwards)
      soup_.triangles.push_back({first, first + 1, first + 2});
    else
      soup_.triangles.push_back({first, first + 2, first + 1});
  }

  const std::array<double, 8>& f_;
  const Index3& low_;
  const Lattice& lattice_;
  model::TriangleSoup& soup_;
};

}  // namespace

double negative_share(const std::array<double, 8>& f) {
  double share = 0;
  for (const Tetra& t : kTetras) {
    std::array<double, 4> v{f[t.corner[0]], f[t.corner[1]], f[t.corner[2]], f[t.corner[3]]};
    std::sort(v.begin(), v.end());
    share += sorted_share(v);
  }
  return share / 6;
}

void add_zero_surface(const std::array<double, 8>& corner_values, const Index3& low,
                      const Lattice& lattice, model::TriangleSoup& soup) {
  Cell cell(corner_values, low, lattice, soup);
  // The order of triangles, last to first, is part of the mesh.
  for (auto t = kTetras.rbegin(); t != kTetras.rend(); ++t) cell.cut(*t);
}

}  // namespace limitgauge::simulator
