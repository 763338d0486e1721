#include "app/job.h"

namespace limitgauge::app {

const char* strategy_name(engine::strategy::Strategy strategy) {
  return strategy == engine::strategy::Strategy::contour ? "contour" : "zigzag";
}

}  // namespace limitgauge::app
