#pragma once

#include <algorithm>
#include <utility>

#include "engine/strategy/stage_path.h"
#include "model/part/toolpath.h"

namespace limitgauge::engine::strategy {

/// Height of rapids: above the stock and above `highest_mm`.
inline double clear_height_mm(const StageRequest& request, double highest_mm) {
  return std::max(model::bounding_box(request.stock).high.z, highest_mm) + request.clearance_mm;
}

/// Writes the moves of a stage: cuts at the feed, plunges and ramps at the plunge feed, links at
/// the link feed (the feed where there is none), rapids only straight up, across at the clear
/// height and down to where the caller says that nothing stands.
class PathBuilder {
 public:
  PathBuilder(const StageRequest& request, double clear_z_mm)
      : feed_(static_cast<float>(request.cut.feed_mm_min)),
        plunge_feed_(static_cast<float>(request.cut.plunge_feed_mm_min)),
        link_feed_(request.cut.link_feed_mm_min > 0
                       ? static_cast<float>(request.cut.link_feed_mm_min)
                       : feed_),
        clear_z_(clear_z_mm) {}

  bool down() const { return down_; }
  const model::Vec3& position() const { return at_; }
  double clear_z() const { return clear_z_; }

  void cut_to(const model::Vec3& p) { add(p, feed_, model::MoveKind::feed); }
  void plunge_to(const model::Vec3& p) { add(p, plunge_feed_, model::MoveKind::feed); }
  void link_to(const model::Vec3& p) { add(p, link_feed_, model::MoveKind::feed); }
  /// Straight up, across at the clear height and straight down to `p`.
  void rapid_over_to(const model::Vec3& p) {
    go_above(p);
    add(p, 0, model::MoveKind::rapid);
    down_ = true;
  }
  /// Retracts, crosses above everything and plunges to `p`.
  void enter_at(const model::Vec3& p) {
    go_above(p);
    add(p, plunge_feed_, model::MoveKind::feed);
    down_ = true;
  }
  void retract() {
    if (!down_) return;
    add({at_.x, at_.y, clear_z_}, 0, model::MoveKind::rapid);
    down_ = false;
  }
  model::Toolpath take() {
    retract();
    return std::move(path_);
  }

 private:
  void go_above(const model::Vec3& p) {
    retract();
    const model::Vec3 above{p.x, p.y, clear_z_};
    if (empty_) {
      path_.start = at_ = above;
      empty_ = false;
    } else {
      add(above, 0, model::MoveKind::rapid);
    }
  }
  void add(const model::Vec3& p, float feed, model::MoveKind kind) {
    if (p == at_) return;
    path_.moves.push_back({p, feed, 0, kind});
    at_ = p;
  }

  model::Toolpath path_;
  model::Vec3 at_;
  float feed_, plunge_feed_, link_feed_;
  double clear_z_;
  bool down_ = false, empty_ = true;
};

}  // namespace limitgauge::engine::strategy
