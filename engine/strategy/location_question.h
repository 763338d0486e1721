#pragma once

#include "engine/strategy/cutter_contact.h"
#include "engine/strategy/location_tree.h"

namespace limitgauge::engine::strategy {

/// The body of a question, and whether the planes of the tree's nodes were set for it.
struct AskingBody {
  const CutterShape& shape;
  bool has_planes = false;
};

/// Lift of a tip that stands at `tip`.
class PlaceQuestion {
 public:
  PlaceQuestion(const AskingBody& body, const Vec3& tip) : body_(body), tip_(tip) {}

  double bound(const LocationNode& node) const;
  void ask(const Corners& corners, GreatestLift& greatest) const;

 private:
  AskingBody body_;
  Vec3 tip_;
};

/// Greatest lift of a tip on its straight way from `from` to `to`.
class MoveQuestion {
 public:
  MoveQuestion(const AskingBody& body, const Vec3& from, const Vec3& to);

  double bound(const LocationNode& node) const;
  void ask(const Corners& corners, GreatestLift& greatest) const;

 private:
  AskingBody body_;
  Vec3 from_, to_, way_;
  double left_x_ = 0, left_y_ = 0;  ///< unit vector across the way; zero for one without XY
};

}  // namespace limitgauge::engine::strategy
