#pragma once

#include <memory>

#include "model/part/cutter.h"
#include "model/part/toolpath.h"

namespace limitgauge::simulator {

/// One pass of one cutter over the stock.
struct Pass {
  model::Cutter cutter;
  std::shared_ptr<const model::Toolpath> path;
};

}  // namespace limitgauge::simulator
