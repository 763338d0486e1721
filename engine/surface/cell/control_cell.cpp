#include "engine/surface/cell/control_cell.h"

namespace limitgauge::engine::surface {
namespace {

class Net {
 public:
  explicit Net(const CellPatch& patch) : patch_(patch), m_(patch.cells()) {}

  Vec3 at(int u, int v) const {
    const bool left = u<0, right = u> m_, below = v<0, above = v> m_;
    if (!(left || right) || !(below || above)) return beside(u, v);
    const int corner = below ? (left ? 0 : 1) : (left ? 3 : 2);
    const bool across_u = across(left ? 3 : 1), across_v = across(below ? 0 : 2);
    if (across_u && across_v) return patch_.ring(corner).face_beyond(2);
    const int on_u = left ? 0 : m_, in_u = left ? 1 : m_ - 1;
    const int on_v = below ? 0 : m_, in_v = below ? 1 : m_ - 1;
    if (across_u) return beside(u, on_v) * 2.0 - beside(u, in_v);
    return beside(on_u, v) * 2.0 - beside(in_u, v);
  }

 private:
  bool across(int side) const { return patch_.has_border(side) && !patch_.sharp_side(side); }
  /// Away from the corners beyond both sides.
  Vec3 beside(int u, int v) const {
    const auto p = [this](int i, int j) { return patch_.control(i, j); };
    if (v < 0 && !across(0)) return p(u, 0) * 2.0 - p(u, 1);
    if (v > m_ && !across(2)) return p(u, m_) * 2.0 - p(u, m_ - 1);
    if (u < 0 && !across(3)) return p(0, v) * 2.0 - p(1, v);
    if (u > m_ && !across(1)) return p(m_, v) * 2.0 - p(m_ - 1, v);
    return p(u, v);
  }

  const CellPatch& patch_;
  int m_;
};

/// Bézier points of a uniform cubic segment.
std::array<Vec3, 4> bezier(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) {
  return {(a + b * 4.0 + c) / 6.0, (b * 2.0 + c) / 3.0, (b + c * 2.0) / 3.0,
          (b + c * 4.0 + d) / 6.0};
}

}  // namespace

std::array<Vec3, 16> ControlCell::bezier() const {
  std::array<Vec3, 16> rows, all;
  for (int j = 0; j < 4; ++j) {
    const auto row = surface::bezier(at(0, j), at(1, j), at(2, j), at(3, j));
    for (int i = 0; i < 4; ++i) rows[j * 4 + i] = row[i];
  }
  for (int i = 0; i < 4; ++i) {
    const auto column = surface::bezier(rows[i], rows[4 + i], rows[8 + i], rows[12 + i]);
    for (int j = 0; j < 4; ++j) all[j * 4 + i] = column[j];
  }
  return all;
}

Differences::Differences(const ControlCell& cell, int times_u, int times_v) : value_(cell.points) {
  for (; times_u > 0; --times_u, --columns_)
    for (int j = 0; j < 4; ++j)
      for (int i = 0; i + 1 < columns_; ++i)
        value_[j * 4 + i] = value_[j * 4 + i + 1] - value_[j * 4 + i];
  for (; times_v > 0; --times_v, --rows_)
    for (int j = 0; j + 1 < rows_; ++j)
      for (int i = 0; i < columns_; ++i)
        value_[j * 4 + i] = value_[j * 4 + 4 + i] - value_[j * 4 + i];
}

std::optional<ControlCell> control_cell(const CellPatch& patch, int u, int v) {
  const int last = patch.cells() - 1;
  const bool at_corner = (u == 0 || u == last) && (v == 0 || v == last);
  const int corner = v == 0 ? (u == 0 ? 0 : 1) : (u == 0 ? 3 : 2);
  if (at_corner && !patch.ring(corner).regular()) return std::nullopt;
  const Net net(patch);
  ControlCell cell;
  for (int j = 0; j < 4; ++j)
    for (int i = 0; i < 4; ++i) cell.points[j * 4 + i] = net.at(u - 1 + i, v - 1 + j);
  return cell;
}

}  // namespace limitgauge::engine::surface
