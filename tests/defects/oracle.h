#pragma once

#include <optional>
#include <vector>

#include "engine/model/stock.h"
#include "engine/model/toolpath.h"
#include "simulator/sweep_index.h"
#include "tests/defects/sampled_surface.h"

namespace limitgauge::tests::defects {

/// A figure found by looking everywhere, and where.
struct Extreme {
  double depth_mm = 0;
  Place place;
};

/// Whether a cutter can touch a place without gouging: by dropping it there. Between the two sure
/// answers lies the tolerance of contact that the verifier states.
enum class Reach { no, maybe, sure };

/// Reachability of the samples of one surface by one cutter, worked out where it is asked for.
class ReachOracle {
 public:
  ReachOracle(const SampledSurface& surface, const model::Cutter& cutter, double allowance_mm);
  Reach at(const model::Vec3& point, const model::Vec3& normal) const;
  Reach of_node(std::size_t node);

 private:
  Reach with_tip(const model::Vec3& tip) const;

  const SampledSurface& surface_;
  double allowance_ = 0, flat_ = 0, rounding_ = 0, wall_sine_ = 0;
  Nose surely_, maybe_;
  std::vector<std::optional<Reach>> nodes_;
};

/// δ over S by the simulator's distances: independent of the verifier's.
class DeviationOracle {
 public:
  DeviationOracle(const SampledSurface& surface, const model::BoxStock& stock,
                  const model::Cutter& cutter, const model::Toolpath& path);

  /// min over moves of the swept distance, and over the faces of the block of the depth in it.
  double delta(const model::Vec3& p) const {
    return delta(p, std::numeric_limits<double>::infinity());
  }
  /// The move with the least swept distance at `p` and that distance.
  simulator::SweptSample of_move(std::size_t move, const model::Vec3& p) const;
  /// max of a − δ; `hints` are further places to begin from.
  Extreme deepest(double allowance_mm, const std::vector<Place>& hints) const;
  /// max of δ − a over the places whose reach is `least` or better: surely reached, or reached
  /// within the tolerance of contact, which on a wall takes in a strip below its equator.
  Extreme highest(double allowance_mm, ReachOracle& reach, Reach least,
                  const std::vector<Place>& hints) const;
  /// How high the material stands over the highest place, along its normal: by p⁴/(64·R³) more than
  /// δ between two balls a step p apart.
  double height(double allowance_mm, const Extreme& highest) const;
  /// How deep the union of all moves goes below S: the largest distance, among the deepest places,
  /// to the nearest point that no move has cut, by marching in many directions.
  double deepest_in_union(double allowance_mm, const Extreme& deepest) const;

 private:
  /// δ where it is known to be no more than `at_most`: the search is cut off there.
  double delta(const model::Vec3& p, double at_most) const;
  double depth_in_union(const model::Vec3& p) const;
  double way_out(const model::Vec3& p, const model::Vec3& direction, double shorter_than) const;

  const SampledSurface& surface_;
  model::BoxStock stock_;
  model::Cutter cutter_;
  simulator::SweepIndex index_;
  std::vector<simulator::SweptMove> moves_;
  std::vector<float> at_nodes_;
};

}  // namespace limitgauge::tests::defects
