#include "tests/defects/orientations/turned_oracle.h"

#include <algorithm>
#include <optional>

namespace limitgauge::tests::defects {
namespace {

using model::Pose;
using model::Vec3;

constexpr double kTurnedSpacing_mm = 0.12;  // as bench.cpp has it

/// Whether a tool stands upright in the part: what this leaves of 10 mm is under a tenth of a
/// nanometre.
bool stands_upright(const Pose& lying) {
  const Vec3 axis = lying.direction_back({0, 0, 1});
  return axis.z > 0 && std::hypot(axis.x, axis.y) < 1e-8;
}

simulator::Pass pass_of(const Stretch& stretch, const model::Cutter& cutter, const Pose& view) {
  const Pose from_own = view * stretch.lying.inverse();
  // A turn about the tool's own axis is taken into the path, so that its pass is upright.
  const bool upright = std::abs(from_own.rows[2].z - 1) < 1e-15;
  const Pose first = upright ? from_own : Pose{};
  model::Toolpath path;
  path.start = first.point(stretch.start);
  for (const PostedMove& m : stretch.moves)
    path.moves.emplace_back(first.point(m.to), 1000.0F, static_cast<std::uint32_t>(m.line),
                            m.rapid ? model::MoveKind::rapid : model::MoveKind::feed);
  return {cutter, std::make_shared<const model::Toolpath>(std::move(path)),
          upright ? Pose{} : from_own};
}

std::vector<Pose> views_of(std::span<const Stretch> stretches) {
  std::vector<Pose> out;
  for (const Stretch& s : stretches) {
    const Pose view = stands_upright(s.lying) ? Pose{} : s.lying;
    if (std::find(out.begin(), out.end(), view) == out.end()) out.push_back(view);
  }
  return out;
}

std::vector<simulator::Pass> passes_of(std::span<const Stretch> stretches,
                                       const model::Cutter& cutter, const Pose& view) {
  std::vector<simulator::Pass> out;
  for (const Stretch& s : stretches) out.push_back(pass_of(s, cutter, view));
  return out;
}

}  // namespace

/// The part as one way to stand has it.
struct TurnedOracle::View {
  std::unique_ptr<const Target> own;  ///< where the tool leans
  const Target& target;
  std::vector<simulator::Pass> passes;
  RunOracle oracle;

  View(std::unique_ptr<const Target> turned, const Target& upright, const model::Stock& stock,
       std::vector<simulator::Pass> swept, double allowance_mm)
      : own(std::move(turned)),
        target(own ? *own : upright),
        passes(std::move(swept)),
        oracle(target, stock, passes, allowance_mm) {}
};

TurnedOracle::TurnedOracle(const Target& part, const model::Cage& cage,
                           const model::BoxStock& stock, const model::Cutter& cutter,
                           std::span<const Stretch> truly, double allowance_mm) {
  for (const Pose& view : views_of(truly)) {
    std::unique_ptr<const Target> own;
    if (view.turns())
      own = std::make_unique<const Target>(model::turned(cage, view), kTurnedSpacing_mm);
    const model::Stock raw = view.turns() ? model::turned(model::Stock(stock), view) : stock;
    views_.push_back(std::make_shared<const View>(std::move(own), part, raw,
                                                  passes_of(truly, cutter, view), allowance_mm));
  }
}

double TurnedOracle::surely_gouged_mm(const std::vector<Place>& hints) const {
  return views_.front()->oracle.surely_gouged(hints).depth_mm;
}

// What one way to stand surely reaches is reached, and what any may reach may be.
double TurnedOracle::surely_uncut_mm(const std::vector<Place>& hints) const {
  double most = 0;
  for (const auto& v : views_) most = std::max(most, v->oracle.surely_uncut(hints).depth_mm);
  return most;
}

double TurnedOracle::possibly_gouged_mm(const Place& place) const {
  return views_.front()->oracle.possibly_gouged(place);
}

double TurnedOracle::possibly_uncut_mm(const Place& place) const {
  double most = 0;
  for (const auto& v : views_) most = std::max(most, v->oracle.possibly_uncut(place));
  return most;
}

double TurnedOracle::standing_mm(const Place& place) const {
  const View& v = *views_.front();
  const verifier::SurfaceSample s = v.target.samples.at(place);
  return v.oracle.uncut(s.position, s.normal).possible_mm;
}

}  // namespace limitgauge::tests::defects
