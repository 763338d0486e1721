#pragma once

#include <optional>

#include "verifier/cutter/swept_body.h"
#include "verifier/reach/reachability.h"

namespace limitgauge::verifier {

/// How near a cutter that does not gouge can come to one point s of S: searches for tip positions T
/// with the least d(s − T), and proves that there are none with less. d is the distance to the
/// fluted part; whether T is free of gouges is judged, as in `Reachability`, by the cutter whose
/// wall goes up without end (CERTIFICATE.md, section 4).
class LowestTip {
 public:
  LowestTip(const SurfaceCells& cells, const Reachability& reachability)
      : cells_(cells),
        reachability_(reachability),
        profile_(reachability.profile()),
        limit_(reachability.allowance_mm() - reachability.contact_mm()) {}

  /// Distance from `s` to the fluted part standing at `tip`.
  double distance(const model::Vec3& tip, const model::Vec3& s) const {
    return body_value(profile_, {tip, tip}, s);
  }
  /// A free position near the free position `tip`, no further from s: lowered, and moved in plan by
  /// steps that end at `settle_mm`. A local search: there may be better ones elsewhere.
  model::Vec3 improved(const model::Vec3& tip, const model::Vec3& s, double settle_mm) const;

  /// Every free T has d(s − T) ≥ low_mm; `better` is a free position nearer than the goal.
  struct Proof {
    double low_mm = 0;
    std::optional<model::Vec3> better;
    std::size_t squares = 0;
  };
  /// Divides the plane of (x, y) until low_mm is the goal, a better position turns up or so many
  /// squares were looked at. For a cutter that undercuts low_mm is no more than any position has.
  Proof prove(const model::Vec3& s, double goal_mm, std::size_t largest_square_count) const;

 private:
  struct Square;

  struct Query;
  void descend(const Bezier& cell, Query& query) const;
  void look(Query& query) const;
  bool is_free(const model::Vec3& tip, double margin_mm) const;
  std::optional<double> highest_z(const model::Vec3& s, double rho_mm, double within_mm) const;
  std::optional<model::Vec3> lowered(model::Vec3 tip, double by_mm, double margin_mm) const;
  bool excludes(const Square& square, const model::Vec3& s, double within_mm,
                const model::Vec3& q) const;
  double raise_low(const Square& square, const model::Vec3& s, double goal_mm,
                   const model::Vec3& q) const;

  const SurfaceCells& cells_;
  const Reachability& reachability_;
  CutterProfile profile_;
  double limit_;
};

}  // namespace limitgauge::verifier
