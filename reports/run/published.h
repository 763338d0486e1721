#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace limitgauge::reports {

/// Figures of a publication about the same part, shown beside the run's own.
struct PublishedFigures {
  std::string source;  ///< where they were published
  std::optional<int> patches;
  std::optional<std::pair<int, int>> depth, sampling_interval;  ///< least and largest
  std::optional<double> seconds, memory_mb;                     ///< to build the model
  struct Stage {
    std::string name;
    std::optional<int> planes;
    std::optional<double> seconds, memory_mb;  ///< to plan the path
  };
  std::vector<Stage> stages;
};

}  // namespace limitgauge::reports
