#include "simulator/process/turn_check.h"

#include <algorithm>
#include <stdexcept>

#include "model/base/chunks.h"

namespace limitgauge::simulator {
namespace {

/// Something that a tool may touch.
struct Obstacle {
  std::string name;
  Material solid;
  const TurningPose* pose;
  bool is_stock = false;
};

std::vector<Obstacle> obstacles_of(const StockModel& stock, const TurningTool& motion,
                                   const ProcessLimits& limits) {
  if (motion.in_fixtures.size() != limits.fixtures.size())
    throw std::invalid_argument("a turn has a pose for each fixture");
  std::vector<Obstacle> obstacles;
  obstacles.push_back({"stock", stock.material(), &motion.in_stock, true});
  for (std::size_t k = 0; k < limits.fixtures.size(); ++k) {
    const model::Stock solid = model::MeshStock{limits.fixtures[k].mesh, "", 0};
    obstacles.push_back(
        {limits.fixtures[k].name, Material(RawStock(solid)), &motion.in_fixtures[k], false});
  }
  return obstacles;
}

std::vector<ToolBody> parts_of(const model::Cutter& cutter) {
  const ToolBodies bodies(cutter, 0);
  std::vector<ToolBody> parts{bodies.flutes};
  parts.insert(parts.end(), bodies.above.begin(), bodies.above.end());
  return parts;
}

FindingKind contact_kind(const Obstacle& obstacle, const ToolBody& body, bool rapid) {
  if (!obstacle.is_stock) return FindingKind::fixture_touched;
  if (body.part == ToolPart::shank) return FindingKind::shank_in_stock;
  if (body.part == ToolPart::holder) return FindingKind::holder_in_stock;
  return rapid ? FindingKind::rapid_through_stock : FindingKind::cut_while_turning;
}

/// What a depth is, or nothing.
std::optional<FindingKind> kind_of(const DeepestTurn& deepest, FindingKind contact,
                                   const ProcessLimits& limits) {
  if (!deepest.proven || deepest.depth_mm > limits.tolerance_mm) return contact;
  if (deepest.depth_mm > limits.tolerance_mm / 10) return FindingKind::slight_contact;
  if (limits.near_miss_mm > 0 && deepest.depth_mm > -limits.near_miss_mm)
    return FindingKind::near_miss;
  return std::nullopt;
}

}  // namespace

std::vector<Finding> check_turn(const StockModel& stock, const model::Cutter& cutter,
                                const TurningTool& motion, const ProcessLimits& limits,
                                const model::RunControl& control) {
  if (!(limits.tolerance_mm > 0))
    throw std::invalid_argument("the tolerance of contacts must be a positive number");
  const std::vector<Obstacle> obstacles = obstacles_of(stock, motion, limits);
  const std::vector<ToolBody> parts = parts_of(cutter);
  const double least_mm = limits.near_miss_mm > 0 ? -limits.near_miss_mm : limits.tolerance_mm / 10;
  std::vector<std::optional<Finding>> found(obstacles.size() * parts.size());
  model::parallel_chunks(found.size(), 1, control, [&](std::size_t i, std::size_t) {
    const Obstacle& obstacle = obstacles[i / parts.size()];
    const ToolBody& body = parts[i % parts.size()];
    const auto deepest =
        deepest_turn(obstacle.solid, body, *obstacle.pose, least_mm, limits.tolerance_mm);
    if (!deepest) return;
    const auto kind = kind_of(*deepest, contact_kind(obstacle, body, motion.rapid), limits);
    if (!kind) return;
    const bool near = *kind == FindingKind::near_miss;
    found[i] = Finding{*kind,
                       0,
                       motion.line,
                       motion.in_stock.at(deepest->t).point(deepest->in_tool),
                       near ? std::min(0.0, deepest->depth_mm) : std::max(0.0, deepest->depth_mm),
                       name(body.part),
                       obstacle.name};
  });
  std::vector<Finding> findings;
  for (std::optional<Finding>& finding : found)
    if (finding) findings.push_back(std::move(*finding));
  return findings;
}

}  // namespace limitgauge::simulator
