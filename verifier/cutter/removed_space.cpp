#include "verifier/cutter/removed_space.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <utility>

#include "model/geometry/box_tree.h"
#include "verifier/tolerance.h"

namespace limitgauge::verifier {

using model::Box3;
using model::Vec3;

RemovedSpace::RemovedSpace(const model::Stock& stock, std::span<const Pass> passes)
    : faces_(StockFaces::of(stock)) {
  if (const auto* mesh = std::get_if<model::MeshStock>(&stock)) {
    if (!mesh->mesh) throw std::invalid_argument("a mesh stock without a mesh");
    mesh_ = std::make_shared<const MeshOutside>(*mesh->mesh);
    stock_blunt_mm_ = mesh->blunt_mm;
  }
  stock_box_ = model::bounding_box(stock);
  for (const Pass& pass : passes)
    add_sweep({CutterProfile(pass.cutter), 0, pass.path, pass.pose, pass.axes});
}

RemovedSpace::RemovedSpace(const model::Cutter& cutter, std::vector<SweptBody> positions) {
  passes_.push_back({std::make_shared<const PassBodies>(CutterProfile(cutter), positions)});
}

RemovedSpace::RemovedSpace(std::span<const Sweep> sweeps) {
  for (const Sweep& sweep : sweeps) add_sweep(sweep);
}

RemovedSpace RemovedSpace::with(std::span<const Sweep> more) const {
  RemovedSpace all = *this;
  for (const Sweep& sweep : more) all.add_sweep(sweep);
  return all;
}

RemovedSpace RemovedSpace::shifted(const Vec3& by) const {
  RemovedSpace out = *this;
  out.shift_ += by;
  return out;
}

RemovedSpace RemovedSpace::with_stock_grown() const {
  RemovedSpace out = *this;
  if (!mesh_ || stock_blunt_mm_ == 0) return out;
  out.mesh_ = std::make_shared<const MeshOutside>(mesh_->beyond(stock_blunt_mm_));
  out.stock_box_ = stock_box_->grown(stock_blunt_mm_);
  return out;
}

RemovedSpace RemovedSpace::swaying(const Vec3& half_mm, double error_mm) const {
  if (half_mm.z != 0) throw std::invalid_argument("a sway lies in plan");
  for (const PlacedPass& pass : passes_)
    if (pass->turn()) throw std::invalid_argument("a pass that turns its tool does not sway");
  RemovedSpace out = *this;
  out.sway_ += half_mm, out.chord_error_mm_ += error_mm;
  return out;
}

BodyDistance RemovedSpace::PlacedPass::back(BodyDistance own) const {
  if (turned) own.gradient = to_own.direction_back(own.gradient);
  return own;
}

namespace {

std::shared_ptr<const PassBodies> bodies_of(const Sweep& sweep, const ChordPieces& pieces) {
  const model::Toolpath& path = *sweep.path;
  if (sweep.axes) {
    model::require_axes(path, *sweep.axes);
    std::vector<TurningBody> bodies;
    bodies.reserve(path.moves.size());
    for (std::size_t i = 0; i < path.moves.size(); ++i)
      bodies.emplace_back(sweep.profile, model::move_from(path, i), path.moves[i].to,
                          model::axis_from(*sweep.axes, i), sweep.axes->to[i], sweep.lift_mm);
    return std::make_shared<const PassBodies>(sweep.profile, bodies);
  }
  return std::make_shared<const PassBodies>(sweep.profile, pieces.bodies(path, sweep.lift_mm));
}

}  // namespace

void RemovedSpace::add_sweep(const Sweep& sweep) {
  auto pieces = std::make_shared<const ChordPieces>(*sweep.path);
  chord_error_mm_ = std::max(chord_error_mm_, pieces->error_mm());
  from_moves_mm_ = std::max(from_moves_mm_, pieces->from_moves_mm());
  PlacedPass placed{bodies_of(sweep, *pieces), std::move(pieces)};
  placed.turned = sweep.pose != model::Pose{};
  if (placed.turned) placed.to_own = sweep.pose.inverse();
  turns_ = turns_ || placed->turn();
  passes_.push_back(std::move(placed));
}

/// Bodies at the same distance but for rounding are all looked at: which of them is named must not
/// depend on where the search began.
void RemovedSpace::nearest_in(std::uint32_t pass, const Vec3& at, Nearest& best,
                              FarPasses* far) const {
  const Vec3 p = passes_[pass].place(at - shift_);
  const auto beyond = [&] { return best.distance.value + kSameDistance_mm; };
  if (const auto* ring = near_ring(pass, p, beyond(), far))
    return offer_ring(pass, *ring, p, best, *far);
  nearest_by_tree(pass, p, best, far);
}

/// The same without the leaves that are known to be near.
void RemovedSpace::nearest_by_tree(std::uint32_t pass, const Vec3& p, Nearest& best,
                                   FarPasses* far) const {
  const PassBodies& bodies = *passes_[pass];
  const auto beyond = [&] { return best.distance.value + kSameDistance_mm; };
  model::nearest_first(
      bodies.nodes(), roots_near(pass, p, beyond(), far),
      [&](const model::BoxNode& node) { return bodies.bound(node, p, beyond()); },
      [&](double bound) { return bound > beyond(); },
      [&](const model::BoxNode& leaf) {
        for (std::uint32_t k = leaf.first; k < leaf.first + leaf.count; ++k)
          offer_body(pass, k, p, best);
      });
}

/// What a search for all of a pass within a limit of p, in its own frame, begins with.
std::span<const std::uint32_t> RemovedSpace::roots_near(std::uint32_t pass, const Vec3& p,
                                                        double limit_mm, FarPasses* far) const {
  const PassBodies& bodies = *passes_[pass];
  if (!far || bodies.turn() || !std::isfinite(limit_mm)) return bodies.root();
  return far->near(pass).roots_near(bodies, p, limit_mm);
}

/// What of a pass lies within a limit of p, in its own frame, where that is known.
const NearLeaves::Ring* RemovedSpace::near_ring(std::uint32_t pass, const Vec3& p, double limit_mm,
                                                FarPasses* far) const {
  const PassBodies& bodies = *passes_[pass];
  if (!far || bodies.turn() || !std::isfinite(limit_mm)) return nullptr;
  return far->near(pass).around(bodies, p, limit_mm);
}

/// The same as by the tree. Where the bodies are known, those further from the ring's middle than
/// the way from there are further from p.
void RemovedSpace::offer_ring(std::uint32_t pass, const NearLeaves::Ring& ring, const Vec3& p,
                              Nearest& best, FarPasses& far) const {
  const PassBodies& bodies = *passes_[pass];
  const auto beyond = [&] { return best.distance.value + kSameDistance_mm; };
  const double way = model::distance(p, ring.at) + kDistanceRounding_mm;
  const auto known = far.near(pass).bodies_in(ring, bodies);
  for (const NearLeaves::Body& body : known) {
    if (body.distance_mm - way > beyond()) return;
    offer_body(pass, body.place, p, best);
  }
  if (!known.empty()) return;
  for (const std::uint32_t at : ring.leaves) {
    const model::BoxNode& leaf = bodies.nodes()[at];
    if (bodies.bound(leaf, p, beyond()) > beyond()) continue;
    for (std::uint32_t k = leaf.first; k < leaf.first + leaf.count; ++k)
      offer_body(pass, k, p, best);
  }
}

/// Takes a body where it is nearer; among equals the first move is the one named.
void RemovedSpace::offer_body(std::uint32_t pass, std::uint32_t place, const Vec3& p,
                              Nearest& best) const {
  const PassBodies& bodies = *passes_[pass];
  const BodyRef body{pass, bodies.move_at(place)};
  const double beyond = best.distance.value + kSameDistance_mm;
  const auto offer = [&](const BodyDistance& d) {
    if (d.value < best.distance.value || (d.value == best.distance.value && body < best.body))
      best = {body, d};
  };
  if (!bodies.turn()) {
    offer({bodies.value_at(place, p, beyond), {}, 0});
  } else if (body != best.body) {
    if (const auto d = bodies.distance_up_to(place, p, beyond)) offer(passes_[pass].back(*d));
  }
}

/// The same, and what is seen of the room up to the pass. It is looked for further away than it
/// could be the nearest, so that the next places need not look.
void RemovedSpace::nearest_if_near(std::uint32_t pass, const Vec3& p, Nearest& best,
                                   FarPasses& far) const {
  if (far.bound(pass, p) > best.distance.value + kSameDistance_mm) return;
  if (!std::isfinite(best.distance.value) || best.body.pass == pass || !far.pays(pass, p))
    return nearest_in(pass, p, best, &far);
  Nearest own{{pass + 1, 0}, {best.distance.value + FarPasses::kFurther_mm, {}, 0}};
  nearest_by_tree(pass, passes_[pass].place(p - shift_), own, &far);
  far.learn(pass, p, own.distance.value);
  const bool first = own.distance.value == best.distance.value && own.body < best.body;
  if (own.body.pass == pass && (own.distance.value < best.distance.value || first)) best = own;
}

Nearest RemovedSpace::nearest(const Vec3& p, std::optional<BodyRef> hint, FarPasses* far) const {
  const auto outside = static_cast<std::uint32_t>(passes_.size());
  Nearest best{{outside + 1, 0}, {std::numeric_limits<double>::infinity(), {}, 0}};
  if (!hint && far) hint = far->last;
  if (hint) best = {*hint, distance(*hint, p)};
  if (!mesh_) nearest_of_stock(p, best);
  // The last pass is most often the nearest: begin with it, so that the others are cut off early.
  for (std::uint32_t k = outside; k-- > 0;)
    far ? nearest_if_near(k, p, best, *far) : nearest_in(k, p, best);
  // A mesh comes last: most points lie deeper in it than the nearest move is away.
  if (mesh_ && !is_stock(best.body)) nearest_of_stock(p, best);
  // Of a turning body all of it is known.
  if (!is_stock(best.body) && !turns(best.body)) best.distance = distance(best.body, p);
  if (far) far->last = best.body;
  return best;
}

std::optional<Nearest> RemovedSpace::nearest_swept(const Vec3& p) const {
  Nearest best{{0, 0}, {std::numeric_limits<double>::infinity(), {}, 0}};
  for (auto k = static_cast<std::uint32_t>(passes_.size()); k-- > 0;) nearest_in(k, p, best);
  if (!std::isfinite(best.distance.value)) return std::nullopt;
  if (!turns(best.body)) best.distance = distance(best.body, p);
  return best;
}

Nearest RemovedSpace::nearest_grown(const Vec3& p, std::optional<BodyRef> hint,
                                    FarPasses* far) const {
  const Nearest at = nearest(p, hint, far);
  if (chord_error_mm_ == 0 || !is_stock(at.body)) return at;
  const auto swept = nearest_swept(p);
  return swept && swept->distance.value - chord_error_mm_ < at.distance.value ? *swept : at;
}

Nearest RemovedSpace::nearest_shrunk(const Vec3& p, std::optional<BodyRef> hint,
                                     FarPasses* far) const {
  Nearest at = nearest(p, hint, far);
  if (chord_error_mm_ == 0 || is_stock(at.body)) return at;
  Nearest shrunk = at;
  shrunk.distance.value += chord_error_mm_;
  nearest_of_stock(p, shrunk);
  return is_stock(shrunk.body) ? shrunk : at;
}

double RemovedSpace::stock_distance_mm(const Vec3& p) const {
  Nearest best{{static_cast<std::uint32_t>(passes_.size()) + 1, 0},
               {std::numeric_limits<double>::infinity(), {}, 0}};
  nearest_of_stock(p, best);
  return best.distance.value;
}

void RemovedSpace::nearest_of_stock(const Vec3& p, Nearest& best) const {
  const auto outside = static_cast<std::uint32_t>(passes_.size());
  if (mesh_) {
    const auto d = mesh_->distance_up_to(p, best.distance.value);
    if (d && d->value < best.distance.value) best = {{outside, 0}, *d};
    return;
  }
  for (std::uint32_t face = 0; face < stock_faces(); ++face) {
    const BodyDistance d = faces_->distance(face, p);
    if (d.value < best.distance.value) best = {{outside, face}, d};
    if (d.value == best.distance.value && best.body.pass == outside && face <= best.body.index)
      best = {{outside, face}, d};
  }
}

/// Calls `take(place of the body)` for all bodies of a pass in nodes that are `near`, or in those
/// of the leaves given that are.
template <class Near, class Take>
void RemovedSpace::visit_near(const PassBodies& bodies, const NearLeaves::Ring* ring,
                              std::span<const std::uint32_t> roots, Near&& near,
                              Take&& take) const {
  const auto is_near = [&](std::uint32_t node) { return near(bodies.nodes()[node]); };
  const auto take_all = [&](std::uint32_t node) {
    const model::BoxNode& leaf = bodies.nodes()[node];
    for (std::uint32_t k = leaf.first; k < leaf.first + leaf.count; ++k) take(k);
    return true;
  };
  if (!ring) return bodies.visit_leaves(roots, is_near, take_all);
  for (const std::uint32_t leaf : ring->leaves)
    if (is_near(leaf)) take_all(leaf);
}

/// In the order of the tree, whichever way they are found.
void RemovedSpace::within_pass(std::uint32_t pass, const Vec3& p, double limit_mm,
                               std::vector<BodyRef>& out, FarPasses* far) const {
  const PassBodies& bodies = *passes_[pass];
  const auto take = [&](std::uint32_t k) {
    if (bodies.value_at(k, p, limit_mm) <= limit_mm) out.push_back({pass, bodies.move_at(k)});
  };
  const auto* ring = near_ring(pass, p, limit_mm, far);
  const auto known =
      ring ? far->near(pass).bodies_in(*ring, bodies) : std::span<const NearLeaves::Body>{};
  if (known.empty())
    return visit_near(
        bodies, ring, roots_near(pass, p, limit_mm, ring ? nullptr : far),
        [&](const model::BoxNode& node) { return bodies.bound(node, p, limit_mm) <= limit_mm; },
        take);
  const std::size_t first = out.size();
  const double way = model::distance(p, ring->at) + kDistanceRounding_mm;
  for (const NearLeaves::Body& body : known) {
    if (body.distance_mm - way > limit_mm) break;
    take(body.place);
  }
  std::sort(out.begin() + static_cast<std::ptrdiff_t>(first), out.end(),
            [&](const BodyRef& a, const BodyRef& b) {
              return bodies.place_of(a.index) < bodies.place_of(b.index);
            });
}

void RemovedSpace::within(const Vec3& at, double limit_mm, std::vector<BodyRef>& out,
                          FarPasses* far) const {
  for (std::uint32_t pass = 0; pass < passes_.size(); ++pass)
    if (!far || far->bound(pass, at) <= limit_mm)
      within_pass(pass, passes_[pass].place(at - shift_), limit_mm, out, far);
  stock_within(at, limit_mm, out);
}

void RemovedSpace::within(const Box3& box, double limit_mm, std::vector<BodyRef>& out,
                          FarPasses* far) const {
  const Vec3 at = box.centre(), radii = box.size() / 2;
  const double all_mm = limit_mm + length(radii);
  for (std::uint32_t pass = 0; pass < passes_.size(); ++pass) {
    if (far && far->bound(pass, at) > all_mm) continue;
    const PassBodies& bodies = *passes_[pass];
    const Vec3 centre = passes_[pass].place(at - shift_), half = passes_[pass].half(radii);
    const auto* ring = near_ring(pass, centre, all_mm, far);
    visit_near(
        bodies, ring, roots_near(pass, centre, all_mm, ring ? nullptr : far),
        [&](const model::BoxNode& node) {
          return bodies.bound(node, centre, limit_mm, half) <= limit_mm;
        },
        [&](std::uint32_t k) {
          if (bodies.bound_at(k, centre, limit_mm, half) <= limit_mm)
            out.push_back({pass, bodies.move_at(k)});
        });
  }
  stock_within(at, all_mm, out);
}

void RemovedSpace::stock_within(const Vec3& p, double limit_mm, std::vector<BodyRef>& out) const {
  const auto outside = static_cast<std::uint32_t>(passes_.size());
  for (std::uint32_t face = 0; face < stock_faces(); ++face)
    if (faces_->distance(face, p).value <= limit_mm) out.push_back({outside, face});
  if (mesh_ && mesh_->distance_up_to(p, limit_mm)) out.push_back({outside, 0});
}

BodyDistance RemovedSpace::distance(BodyRef body, const Vec3& p, double precision_mm) const {
  if (is_stock(body)) return mesh_ ? mesh_->distance(p) : faces_->distance(body.index, p);
  const PlacedPass& pass = passes_[body.pass];
  return pass.back(
      pass->distance_at(pass->place_of(body.index), pass.place(p - shift_), precision_mm));
}

double RemovedSpace::lower(BodyRef body, std::span<const Vec3> points, const Vec3& middle,
                           double enough_mm) const {
  const PlacedPass& pass = passes_[body.pass];
  std::vector<Vec3> own(points.begin(), points.end());
  for (Vec3& p : own) p = pass.place(p - shift_);
  return pass->lower_at(pass->place_of(body.index), own, pass.place(middle - shift_), enough_mm);
}

void RemovedSpace::values(BodyRef body, const Bezier& cell, std::array<double, 16>& out) const {
  if (!is_stock(body)) {
    const PlacedPass& pass = passes_[body.pass];
    const std::uint32_t place = pass->place_of(body.index);
    if (pass.turned)
      return pass->values_at(place, verifier::turned(verifier::shifted(cell, -shift_), pass.to_own),
                             out);
    if (shift_ == Vec3{}) return pass->values_at(place, cell, out);
    return pass->values_at(place, verifier::shifted(cell, -shift_), out);
  }
  if (mesh_) return mesh_->values(cell, out);
  for (int k = 0; k < 16; ++k) out[k] = faces_->distance(body.index, cell.control(k)).value;
}

std::uint32_t RemovedSpace::move_of(BodyRef body) const {
  const PlacedPass& pass = passes_[body.pass];
  return pass.pieces ? pass.pieces->move_of(body.index) : body.index;
}

bool RemovedSpace::is_concave(BodyRef body) const {
  return is_stock(body) && faces_ && faces_->is_concave(body.index);
}

std::uint32_t RemovedSpace::stock_faces() const {
  return faces_ ? faces_->count() : 0;
}

}  // namespace limitgauge::verifier
