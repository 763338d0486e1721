#pragma once

#include "engine/strategy/locations/cutter_contact.h"
#include "engine/strategy/locations/location_tree.h"

namespace limitgauge::engine::strategy {

/// The body of a question, and whether the planes of the tree's nodes were set for it.
struct AskingBody {
  const CutterShape& shape;
  bool has_planes = false;
};

/// What bounds need of a box around triangles.
struct TopBox {
  double low_x = 0, low_y = 0, high_x = 0, high_y = 0, high_z = 0;
};
inline TopBox top_box(const LocationNode& node) {
  return {node.low_x, node.low_y, node.high_x, node.high_y, node.high_z};
}

/// Lift of a tip that stands at `tip`.
class PlaceQuestion {
 public:
  PlaceQuestion(const AskingBody& body, const Vec3& tip) : body_(body), tip_(tip) {}

  /// No less than the lift over anything in the node, where that exceeds `known`.
  double bound(const LocationNode& node, double known) const;
  /// Whether anything in the box might lift by more than `known`.
  bool concerns(const TopBox& box, double known) const;
  void ask(const Corners& corners, GreatestLift& greatest) const;

 private:
  AskingBody body_;
  Vec3 tip_;
};

/// Greatest lift of a tip on its straight way from `from` to `to`.
class MoveQuestion {
 public:
  MoveQuestion(const AskingBody& body, const Vec3& from, const Vec3& to);

  double bound(const LocationNode& node, double known) const;
  bool concerns(const TopBox& box, double known) const;
  void ask(const Corners& corners, GreatestLift& greatest) const;

 private:
  /// The part of the move from which a box may lift by more than what is known, and how far the
  /// box then is at least.
  struct Part {
    Vec3 from, to;
    double squared_mm2 = 0;
    bool empty = true;
  };
  bool lifts_no_more(const LocationNode& node, const TopBox& box, double known) const;
  Part within(const TopBox& box, double reach) const;
  Part concerned(const TopBox& box, double known) const;
  double plane_bound(const LocationNode& node, const TopBox& box, const Part& part,
                     double known) const;

  AskingBody body_;
  Vec3 from_, to_, way_;
  double left_x_ = 0, left_y_ = 0;  ///< unit vector across the way; zero for one without XY
};

}  // namespace limitgauge::engine::strategy
