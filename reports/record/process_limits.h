#pragma once

#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "model/geometry/vec3.h"

namespace limitgauge::reports::record {

/// A body that nothing of the tool may touch, as the job places it.
struct CheckedFixture {
  std::string name;
  std::string file;  ///< as stated
  model::Vec3 translate_mm;
  std::optional<std::string> setup;  ///< the one it stands in; empty: all
  std::optional<std::string> axis;  ///< what carries it, by the job's word; empty: the part's table

  bool operator==(const CheckedFixture&) const = default;
};

/// A rotary axis of the machine, in the machine's frame.
struct RotaryAxis {
  std::string word;  ///< A, B or C
  bool is_head = false;
  model::Vec3 direction, point_mm;
  double low_deg = -std::numeric_limits<double>::infinity();  ///< infinite: without a limit
  double high_deg = std::numeric_limits<double>::infinity();

  bool lies_as(const RotaryAxis& other) const {
    return is_head == other.is_head && direction == other.direction && point_mm == other.point_mm;
  }
};

/// What a process was checked by, as the job states it or as it is where nothing is stated.
struct ProcessLimits {
  double contact_tolerance_mm = 0;  ///< collisions shallower than this fail nothing
  double near_miss_mm = 0;          ///< what passes within this is a near miss; 0: not looked for
  std::optional<model::Box3> travel_mm;  ///< of the tip; infinite where an axis has no limit
  std::optional<std::vector<CheckedFixture>> fixtures;  ///< where the result says them
  std::optional<std::vector<RotaryAxis>> rotary_axes;   ///< where the result says them
};

}  // namespace limitgauge::reports::record
