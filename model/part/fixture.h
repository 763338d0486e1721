#pragma once

#include <memory>
#include <string>

#include "model/mesh/triangle_mesh.h"

namespace limitgauge::model {

/// A clamp, vice or table: a closed solid that nothing of the tool may touch.
struct Fixture {
  std::string name;
  std::string file;  ///< as the job states it
  std::shared_ptr<const TriangleMesh> mesh;
};

}  // namespace limitgauge::model
