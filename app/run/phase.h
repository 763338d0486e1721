#pragma once

#include <cstddef>
#include <string>

namespace limitgauge::app {

/// A step of a run, for those who watch it.
struct Phase {
  std::string what;        ///< "finish: cutting"
  std::size_t stage = 0;   ///< counted from 1; 0 for what belongs to no stage
  std::size_t stages = 0;  ///< of the whole job
};

}  // namespace limitgauge::app
