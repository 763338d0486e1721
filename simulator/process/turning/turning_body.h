#pragma once

#include <array>
#include <functional>
#include <limits>
#include <unordered_map>

#include "model/geometry/pose.h"
#include "simulator/mesh/mesh_solid.h"
#include "simulator/process/tool_bodies.h"
#include "simulator/sweep/depth_bound.h"

namespace limitgauge::simulator {

/// How a tool moves among something else over t in [0, 1].
struct TurningPose {
  /// The tool's frame, tip at its zero and +Z up its axis, in the other's. May be asked from
  /// several threads at once.
  std::function<model::Pose(double t)> at;
  double tip_speed_mm = 0;  ///< the tip never goes faster than this, by t
  double turn_rad = 0;      ///< the tool never turns faster than this, by t
  /// Never does the tip's velocity change faster than this, by t. Infinite where it is not known,
  /// which costs time where the tool comes near something, and nothing else.
  double tip_bend_mm = std::numeric_limits<double>::infinity();
  /// The same of the tool's unit vectors.
  double turn_bend_rad = std::numeric_limits<double>::infinity();

  /// Of axes that all go evenly, rotary ones on each other and linear ones, `turn_rad` being the
  /// sum of what the rotary ones turn: each of them multiplies a velocity by what it turns, at
  /// most, so that unit vectors bend by its square, and the tip by no more than twice the product
  /// of both.
  static TurningPose even(std::function<model::Pose(double t)> at, double tip_speed_mm,
                          double turn_rad);
};

/// Throws std::invalid_argument for bounds that are no numbers from 0 up, and for a pose that, at
/// some dozens of times, breaks them.
void require_bounds(const TurningPose& pose);

/// A body that moves: a convex one of a tool, or a closed mesh that the spindle or a head carries,
/// whose frame then takes the place of the tool's. A view, which keeps nothing alive.
struct MovingShape {
  const ToolBody* tool = nullptr;
  const MeshSolid* mesh = nullptr;

  MovingShape(const ToolBody* body) : tool(body) {}
  MovingShape(const MeshSolid* solid) : mesh(solid) {}
};

/// A block of a search in the other thing's frame, over a stretch of the turn.
struct TurnBlock {
  Block place;
  double t = 0, half_t = 0;
  bool across_time = false;  ///< whether the stretch is what to halve
};

/// The distance to a turning body about the middle of a block.
struct TurnSample {
  SweptSample middle;  ///< there, half-way through the stretch
  /// A plane that nowhere in the block, and at no time of its stretch, is above the distance
  /// (simulator/PROOFS.md, P8).
  SweptSample under;
  double change_mm = 0;  ///< how much higher the plane lies where it need hold at one time alone
};

/// A body during a turn, asked in the frame that its pose leads to. Keeps the poses that
/// it was asked for: one for each search.
class TurningBody {
 public:
  TurningBody(const MovingShape& shape, const TurningPose& pose);

  /// The signed distance to the body as it stands at `t`, exact.
  SweptSample at(double t, const model::Vec3& p) const;
  TurnSample about(const TurnBlock& block) const;
  /// How far the body reaches along `direction` during a stretch: no less than the greatest
  /// direction·x over its places x.
  double extent_mm(double t, double half_t, const model::Vec3& direction) const;
  /// By how much the distance to a place of the block changes within half its stretch, at most.
  double way_mm(const TurnBlock& block) const;
  /// Where a place within `margin_mm` of the body may be during a stretch.
  model::Box3 box(double t, double half_t, double margin_mm) const;

 private:
  const model::Pose& pose(double t) const;
  SweptSample sample(const model::Pose& pose, const model::Vec3& own) const;
  bool bends_known() const;
  double extent_mm(double t, const model::Vec3& direction) const;
  double way_mm(const TurnBlock& block, double from_tip_mm) const;
  double drop_mm(const TurnBlock& block, const model::Vec3& own, const model::Vec3& gradient) const;

  MovingShape shape_;
  const TurningPose& turning_;
  double farthest_mm_;  // of the body's places from the tip, the zero of its frame
  mutable std::unordered_map<double, model::Pose> poses_;
};

/// Upper bounds of the depth over what the body, grown by some length, has of a block
/// (simulator/PROOFS.md, P8).
struct TurnDepth {
  double bound_mm = 0;    ///< during its stretch
  double at_once_mm = 0;  ///< in the middle of it
};
TurnDepth depth_over(const Depth& d, const TurningBody& body, const TurnBlock& block,
                     const TurnSample& distance, double grown_mm);

/// Which way to cut a block whose depth may be more than `enough_mm`: its stretch, where that might
/// do, or where it lets the distance change by more than the block's size does.
bool cut_across_time(const TurnBlock& block, const TurnSample& distance, const TurnDepth& depth,
                     double enough_mm);
/// The block cut in two, in time or across its longest edge.
std::array<TurnBlock, 2> halves(const TurnBlock& block);

}  // namespace limitgauge::simulator
