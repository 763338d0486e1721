#include "simulator/instrument/turning_agreement.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <vector>

#include "model/base/chunks.h"
#include "simulator/instrument/dexel_meridian.h"
#include "simulator/stock/material.h"

namespace limitgauge::simulator {
namespace {

using model::Interval;
using model::Vec3;

constexpr std::size_t kTurningLinesAtOnce = 16;
constexpr int kMostTens = 6;
/// Between two poses a depth is off a straight line by no more than this, where it is smooth.
constexpr double kBend_mm = 1e-4;
/// Poses of a move at most: of a quarter of a turn about a place 250 mm away.
constexpr int kMostPoses = 1024;
/// How near to the pose that holds a place deepest is looked for: a hundredth of kAgreement_mm,
/// since a sharp edge that goes past holds what is so little inside for twice that way and no
/// longer, however long the move is.
constexpr double kPose_mm = 1e-8;

/// One move, its axis between its ends by sines (the great circle's own formula).
struct PosedMove {
  Vec3 from, to, axis_from, axis_to;
  double angle = 0, sine = 0;
  PosedMove(const model::Toolpath& path, const model::ToolAxes& axes, std::size_t i)
      : from(move_from(path, i)),
        to(path.moves[i].to),
        axis_from(model::axis_from(axes, i)),
        axis_to(axes.to[i]),
        angle(std::atan2(length(cross(axis_from, axis_to)), dot(axis_from, axis_to))),
        sine(std::sin(angle)) {}
  Vec3 axis(double t) const {
    constexpr double kStraight = 1e-9;
    if (angle < kStraight) return axis_from;
    return (axis_from * std::sin((1 - t) * angle) + axis_to * std::sin(t * angle)) / sine;
  }
};

/// How far within the flutes' two sides, at its radius, a place is: not below 0 where they hold it.
/// Along a move it rises to one greatest value and falls again, but for a bend of second order:
/// beyond their radius the sides go on more steeply than anywhere, which keeps them convex.
double within(const DexelProfile& profile, const PosedMove& m, const Vec3& p, double t) {
  constexpr double kSteep = 1e6;
  const Vec3 axis = m.axis(t), q = p - (m.from * (1 - t) + m.to * t);
  const double height = dot(q, axis), rho = length(q - axis * height);
  const double over = profile.largest_radius() - rho;
  const double at = std::min(rho, profile.largest_radius()), beyond = kSteep * std::max(0.0, -over);
  return std::min({over, height - profile.lower().height(at) - beyond,
                   -profile.minus_upper().height(at) - height - beyond});
}

/// Golden section for a place where `depth` is not below 0, between a and b of a move on which
/// nothing goes further than `way_mm`: to kPose_mm.
template <class DepthAt>
bool section(const DepthAt& depth, double a, double b, double way_mm) {
  constexpr double kGolden = 0.6180339887498949;
  double s = b - kGolden * (b - a), t = a + kGolden * (b - a);
  double at_s = depth(s), at_t = depth(t);
  while ((b - a) * way_mm > kPose_mm && at_s < 0 && at_t < 0) {
    if (at_s > at_t) {
      b = t, t = s, at_t = at_s;
      at_s = depth(s = b - kGolden * (b - a));
    } else {
      a = s, s = t, at_s = at_t;
      at_t = depth(t = a + kGolden * (b - a));
    }
  }
  return at_s >= 0 || at_t >= 0;
}

/// Poses between which no place of the tool leaves the straight line by more than kBend_mm.
int poses_of(double angle_rad, double way_mm, double reach_mm) {
  const double bend_mm = angle_rad * (angle_rad * reach_mm + 2 * way_mm);
  const double poses = std::ceil(std::sqrt(bend_mm / (8 * kBend_mm)));
  return static_cast<int>(std::clamp<double>(poses, kPosesOfMove, kMostPoses));
}

/// What a move's flutes keep within at all times: so far from their axis half-way.
struct PosedReach {
  PosedReach(const PosedMove& m, const DexelProfile& profile)
      : tip((m.from + m.to) * 0.5),
        axis(m.axis(0.5)),
        length_mm(profile.length()),
        about_mm(profile.largest_radius() + distance(m.from, m.to) / 2 + length_mm * m.angle / 2),
        way_mm(distance(m.from, m.to) + m.angle * (profile.largest_radius() + length_mm)),
        poses(poses_of(m.angle, distance(m.from, m.to), profile.largest_radius() + length_mm)) {}
  bool holds(const Vec3& p) const {
    const Vec3 q = p - tip;
    const double up = std::clamp(dot(q, axis), 0.0, length_mm);
    return length_squared(q - axis * up) <= about_mm * about_mm;
  }

  Vec3 tip, axis;
  double length_mm, about_mm;
  double way_mm;  ///< of any place of it at most
  int poses;      ///< that the move is looked at in
};

class PosedCutter {
 public:
  explicit PosedCutter(const Pass& pass) : profile_(pass.cutter), pose_(pass.pose) {
    for (std::size_t i = 0; i < pass.path->moves.size(); ++i)
      moves_.emplace_back(*pass.path, *pass.axes, i),
          reaches_.emplace_back(moves_.back(), profile_);
  }
  /// Does the cutter come to the place?
  bool comes_to(const Vec3& place) const {
    const Vec3 p = pose_.point_back(place);
    for (std::size_t i = 0; i < moves_.size(); ++i)
      if (reaches_[i].holds(p) && holds(moves_[i], reaches_[i], p)) return true;
    return false;
  }

 private:
  bool holds(const PosedMove& m, const PosedReach& reach, const Vec3& p) const;

  DexelProfile profile_;
  model::Pose pose_;
  std::vector<PosedMove> moves_;
  std::vector<PosedReach> reaches_;  // of each
};

bool PosedCutter::holds(const PosedMove& m, const PosedReach& reach, const Vec3& p) const {
  const int last = reach.poses;
  const auto at = [&](double t) { return within(profile_, m, p, t); };
  std::array<double, kMostPoses + 1> depth;
  for (int k = 0; k <= last; ++k)
    if ((depth[k] = at(static_cast<double>(k) / last)) >= 0) return true;
  for (int k = 0; k <= last; ++k) {
    const auto fall = [&](int from, int to) {
      return from >= 0 && from <= last && to >= 0 && to <= last ? depth[from] - depth[to] : 0.0;
    };
    if (fall(k, k - 1) < 0 || fall(k, k + 1) < 0) continue;
    // All but concave: between two poses it gains no more than it falls by over the step before or
    // behind them, with room for a bend.
    const double steepest =
        std::max({fall(k, k - 1), fall(k, k + 1), fall(k - 1, k - 2), fall(k + 1, k + 2)});
    if (depth[k] + 2 * steepest + kBend_mm < 0) continue;
    if (section(at, std::max(0.0, k - 1.0) / last, std::min(1.0 * last, k + 1.0) / last,
                reach.way_mm))
      return true;
  }
  return false;
}

struct TurningFigures {
  std::size_t ends = 0;
  double worst_end = 0, worst_side = 0, worst = 0;
  Vec3 at;

  void note(double& figure, double value, const Vec3& p) {
    figure = std::max(figure, value);
    if (value > worst) worst = value, at = p;
  }
  void merge(const TurningFigures& other) {
    ends += other.ends;
    worst_end = std::max(worst_end, other.worst_end);
    worst_side = std::max(worst_side, other.worst_side);
    if (other.worst > worst) worst = other.worst, at = other.at;
  }
};

/// One line of both stocks.
class TurningLine {
 public:
  TurningLine(const StockModel& after, const PosedCutter& cutter, const Vec3& foot,
              std::vector<Interval> before)
      : material_(after.material()), cutter_(cutter), foot_(foot), before_(std::move(before)) {}

  TurningFigures look_at(const std::vector<Interval>& after, double low, double high) {
    double below = low;
    for (const Interval& m : after) {
      middle(below, m.low, false);
      end(m.low, {0, 0, -1}), end(m.high, {0, 0, 1});
      middle(m.low, m.high, true);
      below = m.high;
    }
    middle(below, high, false);
    return figures_;
  }

 private:
  Vec3 place(double z) const { return {foot_.x, foot_.y, z}; }
  bool stood(double z) const {
    return std::any_of(before_.begin(), before_.end(),
                       [&](const Interval& m) { return m.low <= z && z <= m.high; });
  }
  void middle(double low, double high, bool material) {
    if (high - low < kThin_mm) return;
    const double z = (low + high) / 2;
    const Vec3 p = place(z);
    if ((stood(z) && !cutter_.comes_to(p)) == material) return;
    figures_.note(figures_.worst_side, std::abs(material_.sample(p).value), p);
  }
  /// Where an edge of the cutter has left the surface the gradient may be that of a face along it:
  /// any place no farther away shows which side is near, and on the line one is.
  void end(double z, const Vec3& leaves) {
    const Vec3 p = place(z);
    const MaterialSample s = material_.sample(p);
    const bool of_pass = s.maker.pass == material_.passes().size();
    const Vec3 out = model::normalized(s.gradient);
    ++figures_.ends;
    double away = kAgreement_mm;
    for (int k = 0; k < kMostTens; ++k, away *= 10) {
      const bool inner = !cutter_.comes_to(p - out * away) || !cutter_.comes_to(p - leaves * away);
      const bool outer =
          !of_pass || cutter_.comes_to(p + out * away) || cutter_.comes_to(p + leaves * away);
      if (inner && outer) break;
      figures_.note(figures_.worst_end, 2 * away, p);
    }
    figures_.note(figures_.worst_end, std::abs(s.value) > kTakenOver_mm ? std::abs(s.value) : 0, p);
  }

  const Material& material_;
  const PosedCutter& cutter_;
  Vec3 foot_;
  std::vector<Interval> before_;
  TurningFigures figures_;
};

void require_same_lines(const DexelStock& before, const DexelStock& after) {
  if (before.nx() != after.nx() || before.ny() != after.ny() ||
      before.line_at(0, 0) != after.line_at(0, 0))
    throw std::invalid_argument("lines before and after a pass that are not the same");
}

}  // namespace

StockAgreement compare_turning(const DexelStock& before, const DexelStock& after,
                               const StockModel& level_set, const Pass& pass, std::size_t lines,
                               const model::RunControl& control,
                               std::optional<double> level_set_volume_mm3) {
  if (!pass.axes) throw std::invalid_argument("a pass without axes is cut by lines");
  require_path(pass);
  require_same_lines(before, after);
  const PosedCutter cutter(pass);
  const model::Box3 box = level_set.material().raw().box();
  const auto columns = static_cast<std::size_t>(after.nx());
  const std::size_t all = columns * static_cast<std::size_t>(after.ny());
  const std::size_t count = std::min(lines, all);
  std::vector<TurningFigures> parts(model::chunk_count(count, kTurningLinesAtOnce));
  model::parallel_chunks(
      count, kTurningLinesAtOnce, control, [&](std::size_t begin, std::size_t end) {
        for (std::size_t k = begin; k < end; ++k) {
          const std::size_t line = k * all / count;
          const int i = static_cast<int>(line % columns), j = static_cast<int>(line / columns);
          TurningLine one(level_set, cutter, after.line_at(i, j), before.material(i, j));
          parts[begin / kTurningLinesAtOnce].merge(
              one.look_at(after.material(i, j), box.low.z, box.high.z));
        }
      });
  TurningFigures sum;
  for (const TurningFigures& part : parts) sum.merge(part);
  // Volumes as they are compared elsewhere.
  StockAgreement found = compare_stocks(after, level_set, 0, control, level_set_volume_mm3);
  found.lines = count, found.ends = sum.ends;
  found.worst_end_mm = sum.worst_end, found.worst_side_mm = sum.worst_side;
  found.worst_at = sum.at;
  return found;
}

}  // namespace limitgauge::simulator
