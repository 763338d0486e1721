#include "verifier/probe/zero_shift.h"

#include <Eigen/QR>
#include <Eigen/SVD>
#include <algorithm>
#include <cmath>
#include <vector>

#include "model/base/chunks.h"

namespace limitgauge::verifier {

using model::Vec3;

namespace {

/// A shift by a millimetre along a direction of less leverage moves no distance by more than a
/// micrometre, as a root mean square: the points say nothing of it.
constexpr double kLeastLeverage = 1e-3;
/// An axis with a larger share of undetermined directions, squared, is undetermined.
constexpr double kLeastUndetermined = 1e-6;
constexpr int kMostFitSteps = 60, kMostHalvings = 40;
constexpr std::size_t kFitChunk = 256;

/// All points' distances at one shift.
struct FitState {
  Vec3 shift;
  std::vector<FitGap> gaps;
  double chi2 = 0;
};

/// The rows √w·(n, r) after a QR decomposition: three rows say all of a million.
struct ReducedRows {
  Eigen::Matrix3d r = Eigen::Matrix3d::Zero();
  Eigen::Vector3d right = Eigen::Vector3d::Zero();
};

struct FitStep {
  Eigen::Matrix3d axes;     ///< columns: directions, the best determined first
  Eigen::Vector3d stretch;  ///< singular values
  Eigen::Vector3d along;    ///< step along each; 0 where it is undetermined
  std::array<bool, 3> determined{};
};

Vec3 vec3(const Eigen::Vector3d& v) {
  return {v[0], v[1], v[2]};
}

/// A direction and its opposite are one: of the two the one that goes up its largest axis.
Vec3 with_sign(const Vec3& v) {
  const Vec3 size{std::abs(v.x), std::abs(v.y), std::abs(v.z)};
  const int axis = size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
  return v[axis] < 0 ? Vec3{} - v : v;
}

class ShiftFit {
 public:
  ShiftFit(const FitProblem& problem, const model::RunControl& control)
      : problem_(problem), control_(control) {
    for (std::size_t i = 0; i < problem.points; ++i) weights_ += square(root_weight(i));
  }

  ZeroShift run() {
    FitState now = at({});
    ZeroShift out;
    out.points = problem_.points;
    out.chi2_before = now.chi2;
    out.rms_before_mm = rms(now);
    while (!out.settled && out.steps < kMostFitSteps) {
      const FitStep step = step_of(now);
      out.last_step_mm = take(step, now);
      out.settled = out.last_step_mm < kSettledStep_mm;
      ++out.steps;
    }
    out.shift_mm = now.shift;
    out.chi2_after = now.chi2;
    out.rms_after_mm = rms(now);
    say_directions(step_of(now), out);
    return out;
  }

 private:
  static double square(double x) { return x * x; }
  double root_weight(std::size_t i) const {
    return problem_.u_mm.empty() ? 1 : 1 / problem_.u_mm[i];
  }

  FitState at(const Vec3& shift) const {
    FitState state{shift, std::vector<FitGap>(problem_.points), 0};
    parallel_chunks(problem_.points, kFitChunk, control_, [&](std::size_t begin, std::size_t end) {
      for (std::size_t i = begin; i < end; ++i) state.gaps[i] = problem_.gap(i, shift);
    });
    // In the order of the points, for the same sum whatever the threads.
    for (std::size_t i = 0; i < problem_.points; ++i)
      state.chi2 += square(root_weight(i) * state.gaps[i].value_mm);
    return state;
  }

  double rms(const FitState& state) const {
    double sum = 0;
    for (const FitGap& gap : state.gaps) sum += square(gap.value_mm);
    return std::sqrt(sum / static_cast<double>(problem_.points));
  }

  ReducedRows reduced(const FitState& state) const {
    const auto n = static_cast<Eigen::Index>(std::max<std::size_t>(problem_.points, 4));
    Eigen::MatrixX4d rows = Eigen::MatrixX4d::Zero(n, 4);
    for (std::size_t i = 0; i < problem_.points; ++i) {
      const FitGap& gap = state.gaps[i];
      const double w = root_weight(i);
      rows.row(static_cast<Eigen::Index>(i)) << w * gap.normal.x, w * gap.normal.y,
          w * gap.normal.z, w * gap.value_mm;
    }
    // In place: of a million points there is one matrix.
    const Eigen::HouseholderQR<Eigen::Ref<Eigen::MatrixX4d>> qr(rows);
    const Eigen::Matrix4d upper = qr.matrixQR().topRows<4>().triangularView<Eigen::Upper>();
    return {upper.topLeftCorner<3, 3>(), upper.topRightCorner<3, 1>()};
  }

  FitStep step_of(const FitState& state) const {
    const ReducedRows rows = reduced(state);
    const Eigen::JacobiSVD<Eigen::Matrix3d> svd(rows.r, Eigen::ComputeFullU | Eigen::ComputeFullV);
    FitStep step{svd.matrixV(), svd.singularValues(), svd.matrixU().transpose() * rows.right, {}};
    for (int k = 0; k < 3; ++k) {
      step.determined[k] = step.stretch[k] >= kLeastLeverage * std::sqrt(weights_);
      step.along[k] = step.determined[k] ? step.along[k] / step.stretch[k] : 0;
    }
    return step;
  }

  /// The length of the step that was taken: what cannot be gone without loss is none.
  double take(const FitStep& step, FitState& now) const {
    Vec3 by = vec3(step.axes * step.along);
    for (int halving = 0; halving < kMostHalvings; ++halving, by *= 0.5) {
      if (length(by) < kSettledStep_mm && halving > 0) break;
      FitState next = at(now.shift + by);
      if (next.chi2 > now.chi2) {
        // Rounding alone decides over a step this small.
        if (length(by) < kSettledStep_mm) return length(by);
        continue;
      }
      now = std::move(next);
      return length(by);
    }
    return length(by);
  }

  void say_directions(const FitStep& step, ZeroShift& out) const {
    for (int k = 0; k < 3; ++k) {
      FitDirection& d = out.directions[k];
      d.along = with_sign(vec3(step.axes.col(k)));
      d.leverage = step.stretch[k] / std::sqrt(weights_);
      d.determined = step.determined[k];
      d.shift_mm = d.determined ? dot(out.shift_mm, d.along) : 0;
    }
    const std::size_t rank = out.rank();
    out.degrees_of_freedom = problem_.points > rank ? problem_.points - rank : 0;
    if (problem_.u_mm.empty() && out.degrees_of_freedom > 0)
      out.scatter_mm = std::sqrt(out.chi2_after / static_cast<double>(out.degrees_of_freedom));
    say_axes(step, problem_.u_mm.empty() ? out.scatter_mm : 1, out);
  }

  static Eigen::Matrix3d covariance(const FitStep& step) {
    Eigen::Matrix3d sum = Eigen::Matrix3d::Zero();
    for (int k = 0; k < 3; ++k)
      if (step.determined[k])
        sum += step.axes.col(k) * step.axes.col(k).transpose() / square(step.stretch[k]);
    return sum;
  }

  /// `unit` is what the weights take for one.
  static void say_axes(const FitStep& step, std::optional<double> unit, ZeroShift& out) {
    const Eigen::Matrix3d c = covariance(step);
    std::array<bool, 3> known{};
    for (int axis = 0; axis < 3; ++axis) {
      double unknown = 0;
      for (int k = 0; k < 3; ++k)
        if (!step.determined[k]) unknown += square(step.axes(axis, k));
      known[axis] = unknown <= kLeastUndetermined;
      if (!known[axis]) continue;
      out.axes_mm[axis] = out.shift_mm[axis];
      if (unit) out.axes_u_mm[axis] = *unit * std::sqrt(c(axis, axis));
    }
    for (int axis = 0; axis < 3; ++axis) {
      const int one = (axis + 1) % 3, other = (axis + 2) % 3;
      if (known[one] && known[other])
        out.correlation[axis] = c(one, other) / std::sqrt(c(one, one) * c(other, other));
    }
  }

  const FitProblem& problem_;
  const model::RunControl& control_;
  double weights_ = 0;
};

}  // namespace

std::size_t ZeroShift::rank() const {
  return static_cast<std::size_t>(
      std::count_if(directions.begin(), directions.end(),
                    [](const FitDirection& direction) { return direction.determined; }));
}

std::optional<ZeroShift> fit_zero_shift(const FitProblem& problem,
                                        const model::RunControl& control) {
  if (problem.points == 0) return std::nullopt;
  return ShiftFit(problem, control).run();
}

}  // namespace limitgauge::verifier
