#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "engine/strategy/stage_path.h"
#include "model/part/toolpath.h"

namespace limitgauge::engine::strategy {

/// Share of a stage's tolerance by which the centre of a ball may leave its straight way while the
/// axis turns and the tip goes straight; as much again is left to what a control makes of it.
inline constexpr double kBowShare = 0.05;

/// What a path of an upright ball is leant by.
struct LeanRule {
  ToolLean lean;
  model::Vec3 along;  ///< the rows' direction, a level unit vector
  /// Normal of the surface that the ball's centre goes on, of length 1 and upwards, over a place;
  /// empty: +Z everywhere.
  std::function<model::Vec3(double x, double y)> normal = {};
  double spacing_mm = 0;  ///< of places at which the normal is asked for; without one of no matter
  double bow_mm = 0;      ///< kBowShare of the tolerance; greater than 0
};

/// A path, and how the tool stands along it.
struct LeaningPath {
  model::Toolpath path;
  model::ToolAxes axes;
};

/// `upright`, the path of a zigzag's ball along +Z, with the axis leant. The centre of the ball
/// goes where it went; the tip is its radius from there against the axis. Moves of rows, parallel
/// to `along`, have the axis that leaning_axis() says; between two of them the heading goes over
/// from one to the other by the length of the way, before the first and behind the last it stays.
///
/// While the axis turns by w and the tip goes straight, the centre is off its way by no more than
/// r·w²/8: moves are cut into as many as keep that within rule.bow_mm and w within 5 degrees.
///
/// The tool is upright at both ends. It turns where rapids pass at the height that the path begins
/// at, by rapids about the ball's centre; that height is raised by what a leaning shank or holder
/// hangs below the ball. From there it goes down, and comes up, straight along +Z as it stands:
/// what clears all that is a height field over XY at the lower end of such a move clears it all the
/// way.
LeaningPath lean_path(const model::Toolpath& upright, const model::Cutter& cutter,
                      const LeanRule& rule);

/// How far the lowest place of shank or holder is below the ball's lowest, mm, where the axis is
/// `axis`; 0 where it is not.
double hang_mm(const model::Cutter& cutter, const model::Vec3& axis);

}  // namespace limitgauge::engine::strategy
