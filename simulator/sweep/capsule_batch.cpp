#include "simulator/sweep/capsule_batch.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "simulator/sweep/vector_loops.h"
#include "simulator/tolerance.h"

namespace limitgauge::simulator {
namespace {

using model::Vec3;

constexpr double kNever = std::numeric_limits<double>::infinity();
// All counts of moves below are multiples of this: batches are padded.
constexpr std::size_t kLanes = MoveBatch::kPad;
// Below this, holding moves against the corners takes more time than the moves themselves.
constexpr std::size_t kManyKept = 16;

LIMITGAUGE_WIDE
void find_feet(const BallColumns& c, std::size_t n, double px, double py, double pz, double h,
               double* squared, double* out_x, double* out_y, double* out_z, double* slide) {
  const double on_the_way = -kFootStaysOnWay * h, most = 3 * h * h;
  n = n / kLanes * kLanes;
  LIMITGAUGE_EACH
  for (std::size_t i = 0; i < n; ++i) {
    const BallFoot q = ball_foot(c, i, px, py, pz);
    squared[i] = q.squared();
    out_x[i] = q.along * c.along_x[i] - q.across * c.along_y[i];
    out_y[i] = q.along * c.along_y[i] + q.across * c.along_x[i];
    out_z[i] = q.up;
    const double over = std::abs(q.along * c.run[i] + q.up * c.rise[i]) * c.inverse_length[i];
    double free = h * c.norm1[i] - over;
    free = free > 0 ? free : 0.0;
    slide[i] = q.up <= on_the_way ? free * free : most;
  }
}

// Raises each margin to the one by which the move loses against the rival.
LIMITGAUGE_WIDE
void raise_margins(const FeetColumns& f, std::size_t n, double h, double squared, double x,
                   double y, double z, double turn, double* margin) {
  const double h2 = 2 * h;
  n = n / kLanes * kLanes;
  LIMITGAUGE_EACH
  for (std::size_t i = 0; i < n; ++i) {
    const double both = f.turn[i] + turn;
    const double slid = f.slide[i] < both ? f.slide[i] : both;
    const double apart = std::abs(f.x[i] - x) + std::abs(f.y[i] - y) + std::abs(f.z[i] - z);
    const double lost = f.squared[i] - squared - h2 * apart - slid;
    margin[i] = lost > margin[i] ? lost : margin[i];
  }
}

// By how much (u_i·δ)² and (u·δ)² may differ, u the direction of the rival, and the margin by which
// each move loses against it.
LIMITGAUGE_WIDE
void first_margins(const BallColumns& c, const FeetColumns& f, std::size_t n, double h,
                   const Vec3& u, const Vec3& q, double squared, double rival_turn,
                   double* __restrict turn, double* __restrict margin) {
  const double ux = u.x, uy = u.y, uz = u.z, on_the_way = -kFootStaysOnWay * h, hh = h * h,
               h2 = 2 * h;
  const double rx = q.x, ry = q.y, rz = q.z;
  n = n / kLanes * kLanes;
  LIMITGAUGE_EACH
  for (std::size_t i = 0; i < n; ++i) {
    const double level = c.run[i] * c.inverse_length[i];
    const double x = c.along_x[i] * level, y = c.along_y[i] * level;
    const double rise = c.rise[i] * c.inverse_length[i];
    const double less = std::abs(x - ux) + std::abs(y - uy) + std::abs(rise - uz);
    const double more = std::abs(x + ux) + std::abs(y + uy) + std::abs(rise + uz);
    const double t = hh * (less * more);
    const double turned = f.z[i] <= on_the_way ? t : kNever;
    turn[i] = turned;
    const double both = turned + rival_turn;
    const double slid = f.slide[i] < both ? f.slide[i] : both;
    const double apart = std::abs(f.x[i] - rx) + std::abs(f.y[i] - ry) + std::abs(f.z[i] - rz);
    margin[i] = f.squared[i] - squared - h2 * apart - slid;
  }
}

LIMITGAUGE_WIDE
double least_of(const double* values, std::size_t n) {
  double least[kLanes];
  for (double& l : least) l = kNever;
  for (std::size_t i = 0; i < n; i += kLanes)
    for (std::size_t k = 0; k < kLanes; ++k)
      least[k] = values[i + k] < least[k] ? values[i + k] : least[k];
  return *std::min_element(least, least + kLanes);
}

std::size_t place_of(double value, const double* values, std::size_t n) {
  return static_cast<std::size_t>(std::find(values, values + n, value) - values);
}

// D² + 2 q·s: the squared distance at `s` from the middle but for what all have in common.
LIMITGAUGE_WIDE
void tangents_at(const FeetColumns& f, std::size_t n, const Vec3& s, double* value) {
  const double x = 2 * s.x, y = 2 * s.y, z = 2 * s.z;
  n = n / kLanes * kLanes;
  LIMITGAUGE_EACH
  for (std::size_t i = 0; i < n; ++i)
    value[i] = f.squared[i] + (f.x[i] * x + f.y[i] * y + f.z[i] * z);
}

Vec3 direction(const MoveBatch& b, std::uint32_t i) {
  return Vec3{b.along_x[i] * b.run[i], b.along_y[i] * b.run[i], b.rise[i]} * b.inverse_length[i];
}

// Can the foot slide by the cube's reach along the move both ways?
bool slides_both_ways(const MoveBatch& b, std::uint32_t i, const Vec3& foot, double h) {
  if (b.run[i] == 0) return false;
  const double t =
      ((foot.x - b.x[i]) * b.along_x[i] + (foot.y - b.y[i]) * b.along_y[i]) * b.inverse_run[i];
  const double reach = (h * b.norm1[i] + kDistanceRounding_mm) * b.inverse_length[i];
  return t >= reach && 1 - t >= reach;
}

// Those places of `kept` whose margin is no loss.
void drop_losers(const std::vector<double>& margin, double slack,
                 std::vector<std::uint32_t>& kept) {
  std::size_t n = 0;
  for (std::size_t i = 0; i < kept.size(); ++i) {
    kept[n] = kept[i];
    n += margin[i] <= slack;
  }
  kept.resize(n);
}

// The places of all margins that are no loss.
void keep_winners(const std::vector<double>& margin, std::size_t count, double slack,
                  std::vector<std::uint32_t>& kept) {
  kept.resize(count);
  std::size_t n = 0;
  for (std::size_t i = 0; i < count; ++i) {
    kept[n] = static_cast<std::uint32_t>(i);
    n += margin[i] <= slack;
  }
  kept.resize(n);
}

}  // namespace

void CapsuleNarrowing::Feet::resize(std::size_t n) {
  for (auto* column : {&squared, &x, &y, &z, &slide, &turn})
    if (column->size() < n) column->resize(n);
}

FeetColumns CapsuleNarrowing::Feet::columns() const {
  return {squared.data(), x.data(), y.data(), z.data(), slide.data(), turn.data()};
}

double CapsuleNarrowing::nearest(const MoveBatch& batch, const Vec3& p, double half_edge) {
  const std::size_t n = batch.padded_size();
  all_.resize(n);
  p_ = p, half_edge_ = half_edge;
  find_feet(batch.columns(), n, p.x, p.y, p.z, half_edge, all_.squared.data(), all_.x.data(),
            all_.y.data(), all_.z.data(), all_.slide.data());
  least_ = least_of(all_.squared.data(), n);
  return least_;
}

void CapsuleNarrowing::keep(const MoveBatch& batch, std::vector<std::uint32_t>& kept) {
  const std::size_t n = batch.padded_size();
  const auto j = static_cast<std::uint32_t>(place_of(least_, all_.squared.data(), n));
  all_.turn[j] = 0;
  const Rival nearest = rival(batch, j, all_, j);
  if (margin_.size() < n) margin_.resize(n);
  first_margins(batch.columns(), all_.columns(), n, half_edge_, direction(batch, j),
                {nearest.x, nearest.y, nearest.z}, nearest.squared, nearest.turn, all_.turn.data(),
                margin_.data());
  const double slack = kDistanceRounding_mm * (1 + 2 * std::sqrt(least_));
  keep_winners(margin_, batch.size(), slack, kept);
  if (kept.size() < kManyKept) return;
  lose_at_corners(batch, kept);
  drop_losers(margin_, slack, kept);
}

CapsuleNarrowing::Rival CapsuleNarrowing::rival(const MoveBatch& batch, std::uint32_t place,
                                                const Feet& f, std::size_t at) const {
  const Vec3 q{f.x[at], f.y[at], f.z[at]};
  const bool slides = slides_both_ways(batch, place, p_ - q, half_edge_);
  return {f.squared[at], q.x, q.y, q.z, slides ? f.turn[at] : kNever};
}

void CapsuleNarrowing::take_kept(const std::vector<std::uint32_t>& kept) {
  const std::size_t padded = MoveBatch::padded(kept.size());
  some_.resize(padded);
  for (std::size_t n = 0; n < padded; ++n) {
    const std::uint32_t i = kept[std::min(n, kept.size() - 1)];
    some_.squared[n] = all_.squared[i];
    some_.x[n] = all_.x[i], some_.y[n] = all_.y[i], some_.z[n] = all_.z[i];
    some_.slide[n] = all_.slide[i], some_.turn[n] = all_.turn[i];
  }
}

void CapsuleNarrowing::lose_at_corners(const MoveBatch& batch,
                                       const std::vector<std::uint32_t>& kept) {
  take_kept(kept);
  const std::size_t n = MoveBatch::padded(kept.size());
  if (tangent_.size() < n) tangent_.resize(n);
  const FeetColumns f = some_.columns();
  std::fill(margin_.begin(), margin_.begin() + static_cast<std::ptrdiff_t>(n), -kNever);
  std::array<std::size_t, 8> met;
  for (std::size_t k = 0; k < met.size(); ++k) {
    tangents_at(f, n, Vec3{k & 4 ? 1.0 : -1.0, k & 2 ? 1.0 : -1.0, k & 1 ? 1.0 : -1.0} * half_edge_,
                tangent_.data());
    met[k] = place_of(least_of(tangent_.data(), n), tangent_.data(), n);
    if (std::find(met.begin(), met.begin() + k, met[k]) != met.begin() + k) continue;
    const Rival r = rival(batch, kept[met[k]], some_, met[k]);
    raise_margins(f, n, half_edge_, r.squared, r.x, r.y, r.z, r.turn, margin_.data());
  }
}

namespace {

LIMITGAUGE_WIDE
void find_squares(const BallColumns& c, std::size_t n, double px, double py, double pz,
                  double* __restrict squared) {
  n = n / kLanes * kLanes;
  LIMITGAUGE_EACH
  for (std::size_t i = 0; i < n; ++i) {
    squared[i] = ball_foot(c, i, px, py, pz).squared();
  }
}

}  // namespace

BallFound nearest_ball(const MoveBatch& batch, const Vec3& p, std::vector<double>& squares) {
  const std::size_t n = batch.padded_size();
  if (squares.size() < n) squares.resize(n);
  find_squares(batch.columns(), n, p.x, p.y, p.z, squares.data());
  const double least = least_of(squares.data(), n);
  return {place_of(least, squares.data(), n), least};
}

namespace {

constexpr std::size_t kColumns = kCubeEdge * kCubeEdge, kVoxels = kColumns * kCubeEdge;

struct BallMove {
  double x, y, z, along_x, along_y, run, rise, inverse_run, inverse_length2;
};

// The columns of voxels side by side; what does not depend on the height is worked out once.
LIMITGAUGE_WIDE
void lower_squares(const BallMove& m, const double* __restrict px, const double* __restrict py,
                   const double* __restrict pz, double* __restrict least) {
  double along[kColumns], across2[kColumns], t_level[kColumns], level[kColumns], far[kColumns];
  for (std::size_t k = 0; k < kColumns; ++k) {
    const double qx = px[k] - m.x, qy = py[k] - m.y;
    const double across = qy * m.along_x - qx * m.along_y;
    along[k] = qx * m.along_x + qy * m.along_y;
    across2[k] = across * across;
    t_level[k] = unit_clamp(along[k] * m.inverse_run);
    level[k] = m.rise * t_level[k];
    far[k] = along[k] * m.run;
  }
  for (std::size_t z = 0; z < kCubeEdge; ++z) {
    const double qz = pz[z] - m.z, climb = qz * m.rise;
    double* __restrict out = least + z * kColumns;
    for (std::size_t k = 0; k < kColumns; ++k) {
      const double t_line = unit_clamp((far[k] + climb) * m.inverse_length2);
      const bool above = qz >= level[k];
      const double t = above ? t_level[k] : t_line;
      const double ea = along[k] - t * m.run, below = qz - t * m.rise;
      const double ez = above ? 0.0 : below;
      const double r2 = ea * ea + across2[k] + ez * ez;
      out[k] = r2 < out[k] ? r2 : out[k];
    }
  }
}

LIMITGAUGE_WIDE
void distances(double radius, double* values) {
  for (std::size_t k = 0; k < kVoxels; ++k) values[k] = std::sqrt(values[k]) - radius;
}

}  // namespace

CubeDistances least_ball_distances(const MoveBatch& b, std::span<const std::uint32_t> places,
                                   double radius, const CubeAxes& axes) {
  std::array<double, kColumns> x, y;
  std::size_t k = 0;
  for (const double at_x : axes.x)
    for (const double at_y : axes.y) x[k] = at_x, y[k++] = at_y;
  CubeDistances least;
  least.fill(kNever);
  for (const std::uint32_t i : places)
    lower_squares({b.x[i], b.y[i], b.z[i], b.along_x[i], b.along_y[i], b.run[i], b.rise[i],
                   b.inverse_run[i], b.inverse_length2[i]},
                  x.data(), y.data(), axes.z.data(), least.data());
  distances(radius, least.data());
  return least;
}

}  // namespace limitgauge::simulator
