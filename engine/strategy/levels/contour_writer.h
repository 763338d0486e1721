#pragma once

#include "engine/strategy/levels/level_passes.h"
#include "engine/strategy/linking/path_builder.h"
#include "engine/strategy/stage_path.h"

namespace limitgauge::engine::strategy {

/// Writes the passes of contour levels as moves. Rapids run at the clear height, straight up, and
/// straight down to a clearance above what has been cut; the way down from there is at the plunge
/// feed, or along a ramp or helix at the feed where material stands.
class ContourWriter {
 public:
  ContourWriter(const StageRequest& request, double clear_z_mm);

  /// The level at `z_mm`; nothing stands above `stands_to_mm` where its passes run.
  void begin_level(double z_mm, double stands_to_mm);
  void write(const LevelPass& pass);
  void end_level() { path_.retract(); }
  model::Toolpath take() { return path_.take(); }

 private:
  using Way = std::vector<model::Vec3>;

  void enter(const LevelPass& pass);
  /// Ways down from where material may stand, ending where the pass begins; none without room.
  Way ramp(const LevelPass& pass) const;
  Way helix(const LevelPass& pass) const;
  /// From above everything down to `p`, at the plunge feed below `rapid_to_z`.
  void come_down(const model::Vec3& p, double rapid_to_z_mm);
  model::Vec3 at_level(const FlatPoint& p) const { return {p.x, p.y, z_}; }

  const CutOptions& cut_;
  double clearance_, slope_;
  double z_ = 0, stands_to_ = 0;
  PathBuilder path_;
};

}  // namespace limitgauge::engine::strategy
