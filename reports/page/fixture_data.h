#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
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
  struct Placed {
    std::shared_ptr<const model::TriangleMesh> mesh;
    model::Pose to_part;
    std::size_t index;
  };
  std::size_t add_shown(const std::string& name, const model::TriangleMesh& shown,
                        std::size_t file_triangles, Blob& blob);

  struct Known {
    std::string name;
    std::vector<std::int32_t> position, corners;
    friend bool operator==(const Known&, const Known&) = default;
  };
  std::vector<Placed> placed_;  ///< stages of one setup share a mesh, which is made fewer once
  std::vector<Known> known_;    ///< setups have one each, which may stand at the same place
  Json json_ = Json::array();
};

}  // namespace limitgauge::reports::page
