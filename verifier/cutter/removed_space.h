#pragma once

#include <cmath>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "model/geometry/pose.h"
#include "model/part/stock.h"
#include "verifier/cutter/body_ref.h"
#include "verifier/cutter/chord_pieces.h"
#include "verifier/cutter/far_passes.h"
#include "verifier/cutter/pass_bodies.h"
#include "verifier/gate/verify.h"
#include "verifier/stock/mesh_outside.h"
#include "verifier/stock/stock_faces.h"

namespace limitgauge::verifier {

/// What one profile sweeps along a path: the fluted part of a cutter, or a part of its shank or
/// holder, whose lower end is `lift_mm` above the tip.
struct Sweep {
  CutterProfile profile;
  double lift_mm = 0;
  std::shared_ptr<const model::Toolpath> path;
  model::Pose pose = {};  ///< how the path's frame lies in the frame of the space
  std::shared_ptr<const model::ToolAxes> axes = {};  ///< as those of a pass
};

/// δ at a point: the signed distance to the nearest removed body, and that body.
struct Nearest {
  BodyRef body;
  BodyDistance distance;
};

/// When a ray through material counts as ended by a body: so near to it, or so near with a face of
/// it running along the ray, up to that sine of the angle between.
struct EndRule {
  double skin_mm = 0, beside_mm = 0, along = 0;

  bool is_met(double distance_mm, const model::Vec3& gradient, const model::Vec3& ray) const;
};

/// All that has been cut so far and all that lies outside the raw stock. δ(p) is the least of the
/// bodies' signed distances: exact outside the removed space, with the right sign everywhere;
/// inside, the depth into one body (a union's true depth can be larger).
class RemovedSpace {
 public:
  /// Throws std::invalid_argument for a mesh without triangles or with numbers out of range, and
  /// for axes that do not fit their path (model::require_axes).
  RemovedSpace(const model::Stock& stock, std::span<const Pass> passes);
  /// The union of single positions of one cutter in endless stock.
  RemovedSpace(const model::Cutter& cutter, std::vector<SweptBody> positions);
  /// The union of sweeps in endless stock; BodyRef::pass counts the sweeps.
  explicit RemovedSpace(std::span<const Sweep> sweeps);

  /// This space and further sweeps, of shanks and holders: BodyRef::pass counts them after the
  /// passes. What this one holds is not held twice.
  RemovedSpace with(std::span<const Sweep> more) const;
  /// This space where all that was swept lies `by` further; the raw stock stays. Bodies are not
  /// held twice.
  RemovedSpace shifted(const model::Vec3& by) const;
  /// This space as one of which `sway()` and a part of `error_mm()` of what was swept are not
  /// known: proofs on cells (CellBounder) hold for all of it, distances at places are those of its
  /// middle. Throws std::invalid_argument for a sway out of plan, and where a pass turns its tool
  /// as it goes.
  RemovedSpace swaying(const model::Vec3& half_mm, double error_mm) const;

  /// This space with the raw stock grown by stock_blunt_mm(): what is gone of it is gone whatever
  /// stands out that far.
  RemovedSpace with_stock_grown() const;

  /// The nearest body; among equals the first. A `hint`, any body, saves time where it is near.
  Nearest nearest(const model::Vec3& p, std::optional<BodyRef> hint = {},
                  FarPasses* far = nullptr) const;
  /// The same of what was swept alone; none where nothing was.
  std::optional<Nearest> nearest_swept(const model::Vec3& p) const;
  /// The same where each body is grown, or shrunk, by its `error_mm()`: another one may be nearest
  /// then. The distance is that to the body as it is.
  Nearest nearest_grown(const model::Vec3& p, std::optional<BodyRef> hint = {},
                        FarPasses* far = nullptr) const;
  Nearest nearest_shrunk(const model::Vec3& p, std::optional<BodyRef> hint = {},
                         FarPasses* far = nullptr) const;
  /// All bodies with d(p) ≤ limit_mm, in a fixed order, appended to `out`.
  void within(const model::Vec3& p, double limit_mm, std::vector<BodyRef>& out,
              FarPasses* far = nullptr) const;

  /// All bodies that may come within `limit_mm` of a point of `box`, in a fixed order, appended to
  /// `out`.
  void within(const model::Box3& box, double limit_mm, std::vector<BodyRef>& out,
              FarPasses* far = nullptr) const;

  /// The first t in [0, limit_mm] at which p + t·ray, a unit vector, meets a body by the rule, and
  /// the body; the limit where none does. All before it is material.
  struct Meeting {
    double t_mm = 0;
    std::optional<BodyRef> body;
  };
  Meeting first_met(const model::Vec3& p, const model::Vec3& ray, double limit_mm,
                    const EndRule& rule, FarPasses* far = nullptr) const;
  /// The same of what was swept alone, met where its distance is no more than error_mm().
  Meeting first_met_swept(const model::Vec3& p, const model::Vec3& ray, double limit_mm,
                          FarPasses* far = nullptr) const;

  /// Of a move that turns its tool, no further above d than `precision_mm`, as its slack says.
  BodyDistance distance(BodyRef body, const model::Vec3& p,
                        double precision_mm = kAlongTurn_mm) const;
  /// d at the sixteen control points of `cell` (for a mesh, see mesh_of).
  void values(BodyRef body, const Bezier& cell, std::array<double, 16>& out) const;
  /// The side of a round bar: its distance is concave, not convex.
  bool is_concave(BodyRef body) const;
  /// What a move sweeps that turns its tool as it goes: d is not convex, its plane at a place none
  /// under it, and `values` are those of a convex function nowhere below it.
  bool turns(BodyRef body) const { return !is_stock(body) && passes_[body.pass]->turn(); }
  /// A lower bound of d of such a body over the hull of `points`, by planes at `middle`; not
  /// improved where it is `enough_mm`, or cannot be.
  double lower(BodyRef body, std::span<const model::Vec3> points, const model::Vec3& middle,
               double enough_mm) const;
  /// The outside of a mesh, whose distance is neither: it has bounds of its own, and `values` are
  /// those of a convex function nowhere below it. None for any other body.
  const MeshOutside* mesh_of(BodyRef body) const { return is_stock(body) ? mesh_.get() : nullptr; }
  /// Radius of the smallest rounding of a body's edges, in mm; none of a face of the stock.
  double rounding_mm(BodyRef body) const {
    if (is_stock(body) || passes_[body.pass]->profile().is_pointed()) return 0;
    return passes_[body.pass]->profile().rounding_mm;
  }
  bool is_stock(BodyRef body) const { return body.pass == passes_.size(); }
  /// Of the raw stock; none where it is endless.
  const std::optional<model::Box3>& stock_box() const { return stock_box_; }
  /// Least distance to what lies outside the raw stock, its sign as that of δ; infinite where the
  /// stock is endless.
  double stock_distance_mm(const model::Vec3& p) const;
  /// How far edges of the raw stock may stand out beyond what it is said to be (model::blunt_mm).
  double stock_blunt_mm() const { return stock_blunt_mm_; }
  /// Largest distance between a programmed arc and the pieces that stand for it, over all passes;
  /// and what else tips may be off by, each move for itself.
  double chord_error_mm() const { return chord_error_mm_; }
  /// By how much a body as it is may lie within or beyond that of its distance: chord_error_mm() of
  /// what was swept. The raw stock lies where it is said to.
  double error_mm(BodyRef body) const { return is_stock(body) ? 0 : chord_error_mm_; }
  /// How far what was swept may lie from what the paths' own moves sweep, whose chords stand wider
  /// of their arcs: a stock that was cut by those is as much off.
  double from_moves_mm() const { return from_moves_mm_; }
  /// Of a body that is no stock: the move of its path.
  std::uint32_t move_of(BodyRef body) const;
  /// Half widths, in plan, of the rectangle that all that was swept may be shifted in, as one.
  const model::Vec3& sway() const { return sway_; }
  /// By how much a shift may change a body's distance at a place, along the body's plane there.
  double swayed_by_mm(const Nearest& at) const {
    return is_stock(at.body) ? 0 : swayed_by_mm(at.distance.gradient);
  }
  double swayed_by_mm(const model::Vec3& gradient) const {
    return std::abs(gradient.x) * sway_.x + std::abs(gradient.y) * sway_.y;
  }

 private:
  /// A pass and how the frame that is asked in lies in its own: what is asked is turned there and
  /// back, so that proofs are those of upright cutters. Turning
  /// is exact but for rounding, which kDistanceRounding_mm covers.
  struct PlacedPass {
    std::shared_ptr<const PassBodies> bodies;
    std::shared_ptr<const ChordPieces> pieces = {};  ///< null: its bodies are no path's
    model::Pose to_own = {};
    bool turned = false;

    const PassBodies* operator->() const { return bodies.get(); }
    const PassBodies& operator*() const { return *bodies; }
    model::Vec3 place(const model::Vec3& p) const { return turned ? to_own.point(p) : p; }
    model::Vec3 direction(const model::Vec3& v) const { return turned ? to_own.direction(v) : v; }
    model::Vec3 half(const model::Vec3& half) const { return turned ? to_own.half(half) : half; }
    BodyDistance back(BodyDistance own) const;
  };

  void add_sweep(const Sweep& sweep);
  template <class Near, class Take>
  void visit_near(const PassBodies& bodies, const NearLeaves::Ring* ring,
                  std::span<const std::uint32_t> roots, Near&& near, Take&& take) const;
  void stock_within(const model::Vec3& p, double limit_mm, std::vector<BodyRef>& out) const;
  void nearest_in(std::uint32_t pass, const model::Vec3& p, Nearest& best,
                  FarPasses* far = nullptr) const;
  void nearest_by_tree(std::uint32_t pass, const model::Vec3& p, Nearest& best,
                       FarPasses* far) const;
  std::span<const std::uint32_t> roots_near(std::uint32_t pass, const model::Vec3& p,
                                            double limit_mm, FarPasses* far) const;
  const NearLeaves::Ring* near_ring(std::uint32_t pass, const model::Vec3& p, double limit_mm,
                                    FarPasses* far) const;
  void offer_ring(std::uint32_t pass, const NearLeaves::Ring& ring, const model::Vec3& p,
                  Nearest& best, FarPasses& far) const;
  void within_pass(std::uint32_t pass, const model::Vec3& p, double limit_mm,
                   std::vector<BodyRef>& out, FarPasses* far) const;
  void offer_body(std::uint32_t pass, std::uint32_t place, const model::Vec3& p,
                  Nearest& best) const;
  void nearest_if_near(std::uint32_t pass, const model::Vec3& p, Nearest& best,
                       FarPasses& far) const;
  void nearest_of_stock(const model::Vec3& p, Nearest& best) const;
  /// How near a body has to come to a ray to be looked at, errors of its path included.
  double near_mm(const EndRule& rule) const {
    return chord_error_mm_ + std::max(rule.beside_mm, rule.skin_mm);
  }
  double meeting_with(const PassBodies& bodies, std::uint32_t place, const model::Vec3& p,
                      const model::Vec3& ray, double limit_mm, const EndRule& rule) const;
  void first_met_of_nearest(const model::Vec3& p, const model::Vec3& ray, const EndRule& rule,
                            Meeting& first, FarPasses* far) const;
  void first_met_in(std::uint32_t pass, const model::Vec3& from, const model::Vec3& along,
                    const EndRule& rule, Meeting& first, FarPasses* far) const;
  void first_met_of_stock(const model::Vec3& p, const model::Vec3& ray, const EndRule& rule,
                          Meeting& first) const;
  /// Half spaces and the side of a bar; a mesh has none.
  std::uint32_t stock_faces() const;

  std::optional<StockFaces> faces_;  ///< of a block or a bar
  std::optional<model::Box3> stock_box_;
  std::shared_ptr<const MeshOutside> mesh_;
  double stock_blunt_mm_ = 0;
  std::vector<PlacedPass> passes_;  ///< spaces may have their bodies in common
  bool turns_ = false;              ///< one of them, its tool
  double chord_error_mm_ = 0, from_moves_mm_ = 0;
  model::Vec3 shift_, sway_;
};

}  // namespace limitgauge::verifier
