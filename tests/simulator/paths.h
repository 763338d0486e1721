#pragma once

#include <memory>
#include <vector>

#include "model/part/cutter.h"
#include "model/part/toolpath.h"
#include "simulator/stock/stock_model.h"

namespace limitgauge::simulator::test {

model::Cutter cutter(model::CutterType type, double diameter, double flutes, double corner = 0,
                     double angle = 0);

/// A path under construction; line numbers count from 1.
class PathBuilder {
 public:
  explicit PathBuilder(const model::Vec3& start) { path_.start = start; }
  PathBuilder& rapid(const model::Vec3& to) { return add(to, model::MoveKind::rapid); }
  PathBuilder& feed(const model::Vec3& to) { return add(to, model::MoveKind::feed); }
  Pass pass(const model::Cutter& c) const {
    return {c, std::make_shared<const model::Toolpath>(path_)};
  }

 private:
  PathBuilder& add(const model::Vec3& to, model::MoveKind kind) {
    path_.moves.push_back({to, 1000, static_cast<std::uint32_t>(path_.moves.size() + 1), kind});
    return *this;
  }
  model::Toolpath path_;
};

/// Rows along x at y from −half to half, `step` apart, on the surface z(x, y) given by `height`.
template <class Height>
Pass raster(const model::Cutter& c, double half, double row, double step, Height height) {
  PathBuilder b({-half, -half, 30});
  for (double y = -half; y <= half + 1e-9; y += row) {
    b.rapid({-half, y, 30});
    for (double x = -half; x <= half + 1e-9; x += step) b.feed({x, y, height(x, y)});
    b.rapid({half, y, 30});
  }
  return b.pass(c);
}

}  // namespace limitgauge::simulator::test
