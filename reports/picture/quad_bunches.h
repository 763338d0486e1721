#pragma once

#include <algorithm>
#include <cstddef>
#include <limits>
#include <span>
#include <vector>

#include "reports/picture/raster.h"
#include "verifier/gate/deviation.h"

namespace limitgauge::reports {

/// A field's quads by the rows of the screen that they reach. Those that follow each other lie near
/// each other: bunch by bunch, most are passed over where only some rows are drawn.
class QuadBunches {
 public:
  /// `points` are the field's samples on the screen.
  QuadBunches(const verifier::DeviationField& field, std::span<const ScreenPoint> points)
      : field_(field) {
    for (std::size_t begin = 0; begin < field.quads.size(); begin += kQuads) {
      Bunch bunch{begin, std::min(begin + kQuads, field.quads.size())};
      for (std::size_t i = begin; i < bunch.end; ++i)
        for (const auto corner : field.quads[i]) {
          bunch.top = std::min(bunch.top, points[corner].y);
          bunch.bottom = std::max(bunch.bottom, points[corner].y);
        }
      bunches_.push_back(bunch);
    }
  }

  /// Calls `visit(quad)` for all that reach the rows of `depth`, and some more, in their order.
  template <typename Visit>
  void each(const DepthBuffer& depth, Visit&& visit) const {
    const double first = depth.first_row(), last = first + depth.height();
    for (const Bunch& bunch : bunches_)
      if (bunch.bottom >= first && bunch.top <= last)
        for (std::size_t i = bunch.begin; i < bunch.end; ++i) visit(field_.quads[i]);
  }

 private:
  static constexpr std::size_t kQuads = 128;
  struct Bunch {
    std::size_t begin = 0, end = 0;
    double top = std::numeric_limits<double>::infinity();
    double bottom = -std::numeric_limits<double>::infinity();
  };

  const verifier::DeviationField& field_;
  std::vector<Bunch> bunches_;
};

}  // namespace limitgauge::reports
