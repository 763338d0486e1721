#pragma once

#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "model/part/stock.h"
#include "simulator/stock/material.h"
#include "tests/defects/crossings.h"
#include "tests/defects/reach_oracle.h"
#include "tests/defects/surfaces/sharp_places.h"

namespace limitgauge::tests::defects {

/// S with all that asks about it: built once for many programs.
struct Target {
  verifier::ReferenceSurface surface;
  SampledSurface samples;
  SharpPlaces sharp;
  Crossings crossings;

  Target(const model::Cage& cage, double spacing_mm)
      : surface(cage), samples(surface, spacing_mm), sharp(cage, samples), crossings(samples) {}
  Target(const Target&) = delete;
};

/// A figure found by looking everywhere, and where.
struct Extreme {
  double depth_mm = 0;
  Place place;
};

/// A run along a normal: what it has for certain and what it may have, apart by films under 10 nm
/// and where it grazes S.
struct Bracket {
  double sure_mm = 0, possible_mm = 0;
};

/// Definition 2 by looking everywhere: runs along the normals of dense samples of S, marched
/// through the exact material by the simulator's distances, over all of N(s) at sharp edges. It
/// shares nothing with the verifier but the exact limit surface, which is held against OpenSubdiv
/// elsewhere.
class RunOracle {
 public:
  /// `passes` are all so far; the cutters' shanks and holders sweep for gouges only.
  RunOracle(const Target& target, const model::Stock& stock,
            std::span<const simulator::Pass> passes, double allowance_mm)
      : RunOracle(target, stock, passes, passes, allowance_mm) {}
  /// What counts as in reach is what the cutters of `stated` can touch.
  RunOracle(const Target& target, const model::Stock& stock,
            std::span<const simulator::Pass> passes, std::span<const simulator::Pass> stated,
            double allowance_mm);

  /// Material from s + a·n outwards, as far as the next crossing of S.
  Bracket uncut(const model::Vec3& point, const model::Vec3& normal) const {
    return {sure_uncut(point, normal), possible_uncut(point, normal)};
  }
  /// What is no longer material from s + a·n inwards, as far as something was swept.
  Bracket gouge(const model::Vec3& point, const model::Vec3& normal) const {
    return {gouge_run(point, normal, true), gouge_run(point, normal, false)};
  }
  /// From s inwards outside the raw stock.
  Bracket missing(const model::Vec3& point, const model::Vec3& normal) const {
    return {missing_run(point, normal, true), missing_run(point, normal, false)};
  }

  /// What some place in reach surely has; `hints` are further places to begin from.
  Extreme surely_uncut(const std::vector<Place>& hints) const;
  Extreme surely_gouged(const std::vector<Place>& hints) const;
  Extreme surely_missing() const;

  /// The most that may be said of a place: over all of N(s) that may be reached; for a gouge what
  /// places beside it come to on any of the faces, since on the edge itself the least counts.
  double possibly_uncut(const Place& place) const;
  double possibly_gouged(const Place& place) const;
  double possibly_missing(const Place& place) const;

  Reach reach(const model::Vec3& point, const model::Vec3& normal) const {
    return reach_.at(point, normal);
  }
  double allowance_mm() const { return allowance_; }
  /// min over all passes' flutes of the swept distance.
  double swept_distance_mm(const model::Vec3& p) const;

 private:
  using Bodies = std::vector<std::shared_ptr<const simulator::SweepIndex>>;
  static double least(const Bodies& bodies, const model::Vec3& p);
  /// Depth in the raw stock and distance from what was swept, the lesser: positive in material.
  double inside_material(const Bodies& swept, const model::Vec3& p) const;
  static Place off_vertex(Place place);
  template <class Run>
  Extreme highest(const std::vector<Place>& hints, bool sharp, Run&& run) const;
  /// `most_steps` bound the march: what is certain becomes less by them.
  double sure_uncut(const model::Vec3& point, const model::Vec3& normal,
                    int most_steps = 30'000) const;
  double possible_uncut(const model::Vec3& point, const model::Vec3& normal) const;
  double gouge_run(const model::Vec3& point, const model::Vec3& normal, bool sure,
                   int most_steps = 30'000) const;
  double missing_run(const model::Vec3& point, const model::Vec3& normal, bool sure) const;
  /// The longest that `run(point, normal)` comes to on the faces at a place, and beside it.
  template <class Run>
  double possible_of_faces(const Place& place, Run&& run) const;
  double ended_by_surface(const model::Vec3& point, const model::Vec3& along,
                          const model::Vec3& normal, double from_mm, double run_mm,
                          bool sure) const;

  const Target& target_;
  simulator::RawStock raw_;
  double allowance_ = 0, longest_ = 0;
  Bodies flutes_, everything_;
  ReachOracle reach_;
};

}  // namespace limitgauge::tests::defects
