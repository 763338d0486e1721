#pragma once

#include <string>
#include <utility>
#include <vector>

#include "model/geometry/pose.h"

namespace limitgauge::tests::defects {

/// "[1, 0, -0.5]", as a job states them.
std::string toml_numbers(const model::Vec3& v);

/// A [[setup]] as a job states it: half a turn about X or Y, turns in their order, or the matrix
/// that these turns make.
struct StatedSetup {
  enum class Style { flip, turns, matrix } style = Style::turns;
  char flip = 'x';
  std::vector<std::pair<model::Vec3, double>> turns;  ///< axis and degrees
  model::Vec3 origin_mm;

  /// The part's frame to the setup's, worked out here.
  model::Pose pose() const;
  /// The table in the job, its name "vice".
  std::string text() const;
};

}  // namespace limitgauge::tests::defects
