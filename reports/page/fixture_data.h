#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "model/geometry/pose.h"
#include "model/part/fixture.h"
#include "reports/page/blocks.h"

namespace limitgauge::reports::page {

/// A fixture has about so many triangles on a page at most.
inline constexpr std::size_t kMostFixtureTriangles = 20'000;

/// The fixtures of the page, each once for every place that it has about the part.
class Fixtures {
 public:
  /// Index of `fixture`, whose frame lies in the part's as `to_part` says.
  std::size_t add(const model::Fixture& fixture, const model::Pose& to_part, Blob& blob);
  const Json& json() const { return json_; }

 private:
  struct Known {
    std::string name;
    std::vector<std::int32_t> position, corners;
    friend bool operator==(const Known&, const Known&) = default;
  };
  std::vector<Known> known_;
  Json json_ = Json::array();
};

}  // namespace limitgauge::reports::page
