#pragma once

#include <string>
#include <vector>

#include "model/part/fixture.h"
#include "simulator/instrument/stock_check.h"
#include "simulator/mesh/fixture_solid.h"
#include "simulator/process/finding.h"
#include "simulator/process/tool_bodies.h"

namespace limitgauge::simulator {

/// Checks the moves of one pass against fixtures. The rules are those of process_check.h. May be
/// asked from several threads at once.
class FixtureCheck {
 public:
  /// Throws std::invalid_argument for a fixture whose mesh is no closed solid.
  FixtureCheck(const std::vector<model::Fixture>& fixtures, const Pass& pass,
               const ToolBodies& bodies, const StockLimits& limits);

  /// Appends what is wrong with a move, in no order.
  void look_at(std::size_t move, std::vector<Finding>& findings) const;

 private:
  struct Obstacle {
    std::string name;
    FixtureSolid solid;
    model::Box3 tips;  // where a tip may be when some body is near
  };
  void look_at(const Obstacle& obstacle, const ToolBody& body, std::size_t i, const SweptMove& tip,
               std::vector<Finding>& findings) const;
  /// Adds the deepest place of the fixture in parts that are deeper together than each alone.
  void look_at_joined(const Obstacle& obstacle, std::size_t i, const SweptMove& tip,
                      std::vector<Finding>& findings) const;
  /// The part that is at `p` where the tip is when `body` is deepest there.
  const char* part_there(const ToolBody& body, const SweptMove& tip, const model::Vec3& p) const;

  const model::Toolpath& path_;
  const ToolBodies& assembly_;
  std::vector<ToolBody> bodies_;  // its parts
  StockLimits limits_;
  std::vector<Obstacle> obstacles_;  // those that the path comes near
};

}  // namespace limitgauge::simulator
