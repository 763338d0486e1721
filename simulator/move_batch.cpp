#include "simulator/move_batch.h"

#include <algorithm>
#include <cmath>

#include "simulator/wide.h"

namespace limitgauge::simulator {
namespace {

using model::Vec3;

inline double unit_clamp(double t) {
  t = t > 0 ? t : 0.0;
  return t < 1 ? t : 1.0;
}

LIMITGAUGE_WIDE
void ball_samples(const BallColumns& c, std::size_t n, double radius, double px, double py,
                  double pz, double* __restrict distance, double* __restrict gx,
                  double* __restrict gy, double* __restrict gz) {
  for (std::size_t i = 0; i < n; ++i) {
    const double qx = px - c.x[i], qy = py - c.y[i], qz = pz - c.z[i];
    const double along = qx * c.along_x[i] + qy * c.along_y[i];
    const double across = qy * c.along_x[i] - qx * c.along_y[i];
    const double t_level = unit_clamp(along * c.inverse_run[i]);
    const double t_line = unit_clamp((along * c.run[i] + qz * c.rise[i]) * c.inverse_length2[i]);
    const bool above = qz >= c.rise[i] * t_level;
    const double t = above ? t_level : t_line;
    const double ea = along - t * c.run[i];
    const double below = qz - t * c.rise[i];
    const double ez = above ? 0.0 : below;
    const double r = std::sqrt(ea * ea + across * across + ez * ez);
    const double inverse = r > 0 ? 1 / r : 0.0;
    distance[i] = r - radius;
    gx[i] = (ea * c.along_x[i] - across * c.along_y[i]) * inverse;
    gy[i] = (ea * c.along_y[i] + across * c.along_x[i]) * inverse;
    gz[i] = ez * inverse;
  }
}

LIMITGAUGE_WIDE
void least_squares(const BallColumns& c, std::size_t n, const double* __restrict px,
                   const double* __restrict py, const double* __restrict pz,
                   double* __restrict least) {
  for (std::size_t i = 0; i < n; ++i) {
    const double x = c.x[i], y = c.y[i], z = c.z[i], ux = c.along_x[i], uy = c.along_y[i];
    const double run = c.run[i], rise = c.rise[i], ir = c.inverse_run[i], il = c.inverse_length2[i];
    for (int k = 0; k < 8; ++k) {
      const double qx = px[k] - x, qy = py[k] - y, qz = pz[k] - z;
      const double along = qx * ux + qy * uy, across = qy * ux - qx * uy;
      const double t_level = unit_clamp(along * ir);
      const double t_line = unit_clamp((along * run + qz * rise) * il);
      const bool above = qz >= rise * t_level;
      const double t = above ? t_level : t_line;
      const double ea = along - t * run, below = qz - t * rise;
      const double ez = above ? 0.0 : below;
      const double r2 = ea * ea + across * across + ez * ez;
      least[k] = r2 < least[k] ? r2 : least[k];
    }
  }
}

}  // namespace

BallColumns MoveBatch::columns() const {
  return {
      x.data(),    y.data(),    z.data(),           along_x.data(),         along_y.data(),
      run.data(),  rise.data(), inverse_run.data(), inverse_length2.data(), inverse_length.data(),
      norm1.data()};
}

void MoveBatch::clear() {
  slot.clear();
  for (auto* column : {&x, &y, &z, &along_x, &along_y, &run, &rise, &inverse_run, &inverse_length2,
                       &inverse_length, &norm1})
    column->clear();
}

void MoveBatch::push(const SweepIndex& pass, std::uint32_t s) {
  const SweptMove& m = pass.move(s);
  const double low = std::min(m.start.z, m.start.z + m.delta.z);
  lowest_tip = slot.empty() ? low : std::min(lowest_tip, low);
  slot.push_back(s);
  if (!pass.profile().is_ball()) return;
  const double radius = pass.profile().corner_radius();
  x.push_back(m.start.x);
  y.push_back(m.start.y);
  z.push_back((m.vertical() ? low : m.start.z) + radius);
  along_x.push_back(m.along_x);
  along_y.push_back(m.along_y);
  run.push_back(m.run);
  rise.push_back(m.vertical() ? 0.0 : m.delta.z);
  inverse_run.push_back(m.vertical() ? 0.0 : 1 / m.run);
  inverse_length2.push_back(m.vertical() ? 0.0 : m.inverse_length2);
  const double inverse = m.vertical() ? 0.0 : std::sqrt(m.inverse_length2);
  inverse_length.push_back(inverse);
  norm1.push_back(inverse *
                  ((std::abs(m.along_x) + std::abs(m.along_y)) * m.run + std::abs(m.delta.z)));
}

void MoveBatch::take(const MoveBatch& from, const std::vector<std::uint32_t>& places) {
  const std::size_t n = places.size();
  slot.resize(n);
  for (std::size_t i = 0; i < n; ++i) slot[i] = from.slot[places[i]];
  lowest_tip = from.lowest_tip;
  const auto copy = [&](std::vector<double>& to, const std::vector<double>& column) {
    if (column.empty()) return;
    to.resize(n);
    for (std::size_t i = 0; i < n; ++i) to[i] = column[places[i]];
  };
  copy(x, from.x), copy(y, from.y), copy(z, from.z);
  copy(along_x, from.along_x), copy(along_y, from.along_y);
  copy(run, from.run), copy(rise, from.rise);
  copy(inverse_run, from.inverse_run), copy(inverse_length2, from.inverse_length2);
  copy(inverse_length, from.inverse_length), copy(norm1, from.norm1);
}

double MoveBatch::below_tops_mm(const CutterProfile& profile) const {
  return lowest_tip + profile.length() - profile.corner_radius();
}

void BatchSamples::resize(std::size_t n) {
  distance.resize(n), gx.resize(n), gy.resize(n), gz.resize(n);
}

void sample_balls(const MoveBatch& batch, double radius, const Vec3& p, BatchSamples& out) {
  out.resize(batch.size());
  ball_samples(batch.columns(), batch.size(), radius, p.x, p.y, p.z, out.distance.data(),
               out.gx.data(), out.gy.data(), out.gz.data());
}

std::array<double, 8> least_ball_distances(const MoveBatch& batch, double radius,
                                           const std::array<Vec3, 8>& points) {
  std::array<double, 8> px, py, pz, least;
  for (int k = 0; k < 8; ++k) px[k] = points[k].x, py[k] = points[k].y, pz[k] = points[k].z;
  least.fill(std::numeric_limits<double>::infinity());
  least_squares(batch.columns(), batch.size(), px.data(), py.data(), pz.data(), least.data());
  for (double& d : least) d = std::sqrt(d) - radius;
  return least;
}

}  // namespace limitgauge::simulator
