#pragma once

#include <array>
#include <cstdint>
#include <limits>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "model/geometry/box_tree.h"
#include "verifier/cutter/axis_cone.h"
#include "verifier/cutter/cutter_profile.h"
#include "verifier/cutter/swept_body.h"
#include "verifier/cutter/tilted_box.h"
#include "verifier/cutter/turning_body.h"

namespace limitgauge::verifier {

/// What one profile sweeps in one pass, in the frame of the pass: a body for each move, upright or
/// turning as it goes, with a tree over them. Bodies are numbered as their moves, and held in the
/// order of the leaves, so that a leaf lies together; "place" is one in that order.
class PassBodies {
 public:
  PassBodies(const CutterProfile& profile, const std::vector<SweptBody>& bodies);
  PassBodies(const CutterProfile& profile, const std::vector<TurningBody>& bodies);

  const CutterProfile& profile() const { return profile_; }
  const std::vector<model::BoxNode>& nodes() const { return nodes_; }
  std::uint32_t move_at(std::uint32_t place) const { return index_[place]; }
  std::uint32_t place_of(std::uint32_t move) const { return place_[move]; }
  /// The distance to a turning one is not convex.
  bool turn() const { return !turning_.empty(); }

  /// A lower bound of d over a node's bodies and all points no further from p along each axis than
  /// `half`: the dearer one where the cheaper is not beyond `limit_mm`. Beyond that it may be any.
  double bound(const model::BoxNode& node, const model::Vec3& p, double limit_mm,
               const model::Vec3& half = {}) const;
  /// The same of the body at a place.
  double bound_at(std::uint32_t place, const model::Vec3& p, double limit_mm,
                  const model::Vec3& half = {}) const;

  /// The whole tree, as what a search begins with.
  std::span<const std::uint32_t> root() const { return std::span(&kRoot, nodes_.empty() ? 0 : 1); }
  /// Calls `take(leaf)` for the leaves beneath `roots` in nodes that are all `near(node)`, in the
  /// order of the tree, until it says false; both by the node's number.
  template <class Near, class Take>
  void visit_leaves(std::span<const std::uint32_t> roots, Near&& near, Take&& take) const {
    visit_nodes(roots, 1, near, take);
  }
  /// The same of the first nodes on the way down with no more than about `most_leaves`.
  template <class Near, class Take>
  void visit_nodes(std::span<const std::uint32_t> roots, std::uint32_t most_leaves, Near&& near,
                   Take&& take) const;

  /// Where d is above `beyond_mm` it may be any value that is so too.
  double value_at(std::uint32_t place, const model::Vec3& p,
                  double beyond_mm = std::numeric_limits<double>::infinity()) const;
  /// Of a turning one: nothing where d is above `beyond_mm`, else distance_at().
  std::optional<BodyDistance> distance_up_to(std::uint32_t place, const model::Vec3& p,
                                             double beyond_mm) const;
  /// Of a turning body the plane is one at the time when it is nearest, to `precision_mm`.
  BodyDistance distance_at(std::uint32_t place, const model::Vec3& p,
                           double precision_mm = kAlongTurn_mm) const;
  /// At the control points a convex function nowhere below d: d itself of an upright one.
  void values_at(std::uint32_t place, const Bezier& cell, std::array<double, 16>& out) const;
  /// Of a turning body, see TurningBody::lower.
  double lower_at(std::uint32_t place, std::span<const model::Vec3> points,
                  const model::Vec3& middle, double enough_mm) const;

 private:
  static constexpr std::uint32_t kRoot = 0;

  void take_order(model::BoxTree tree);
  double ball_bound(std::size_t node, const model::Box3& tips, const model::Vec3& p,
                    double limit_mm, const model::Vec3& half) const;
  bool has_leaves(std::uint32_t node, std::uint32_t most) const {
    // The left half lies between the node and the right one, an inner node for each leaf but one.
    return nodes_[node].count > 0 || nodes_[node].right - node <= most;
  }

  CutterProfile profile_;
  std::vector<SweptBody> upright_;
  std::vector<TurningBody> turning_;
  std::vector<std::uint32_t> index_, place_;
  std::vector<model::BoxNode> nodes_;  ///< over the tips, of turning bodies over the cores
  std::vector<TiltedBox> tilted_;      ///< beside nodes of upright ones, where they serve
  double size_mm_ = 0;                 ///< of a turning profile from its core
  std::vector<AxisCone> cones_;        ///< beside nodes of turning ones
  std::vector<AxisCone> own_cones_;    ///< of each of them, by place
  std::vector<model::Box3> own_cores_;
};

template <class Near, class Take>
void PassBodies::visit_nodes(std::span<const std::uint32_t> roots, std::uint32_t most_leaves,
                             Near&& near, Take&& take) const {
  // On the heap of the thread, kept between queries: a tree over millions of moves is deep.
  thread_local std::vector<std::uint32_t> stack;
  stack.assign(roots.rbegin(), roots.rend());
  while (!stack.empty()) {
    const std::uint32_t at = stack.back();
    stack.pop_back();
    if (!near(at)) continue;
    if (!has_leaves(at, most_leaves)) {
      stack.push_back(nodes_[at].right);
      stack.push_back(at + 1);
    } else if (!take(at)) {
      return;
    }
  }
}

}  // namespace limitgauge::verifier
