#include "simulator/sweep/move_batch.h"

#include <algorithm>
#include <cmath>

#include "simulator/sweep/vector_loops.h"

namespace limitgauge::simulator {
namespace {

using model::Vec3;

LIMITGAUGE_WIDE
void ball_samples(const BallColumns& c, std::size_t n, double radius, double px, double py,
                  double pz, double* __restrict distance, double* __restrict gx,
                  double* __restrict gy, double* __restrict gz) {
  for (std::size_t i = 0; i < n; ++i) {
    const BallFoot q = ball_foot(c, i, px, py, pz);
    const double r = std::sqrt(q.squared());
    const double inverse = r > 0 ? 1 / r : 0.0;
    distance[i] = r - radius;
    gx[i] = (q.along * c.along_x[i] - q.across * c.along_y[i]) * inverse;
    gy[i] = (q.along * c.along_y[i] + q.across * c.along_x[i]) * inverse;
    gz[i] = q.up * inverse;
  }
}

// A vertical move has no run and counts for no length.
LIMITGAUGE_WIDE
void find_inverses(std::size_t n, const double* __restrict along_x,
                   const double* __restrict along_y, const double* __restrict run,
                   const double* __restrict rise, const double* __restrict inverse_length2,
                   double* __restrict inverse_run, double* __restrict inverse_length,
                   double* __restrict norm1) {
  for (std::size_t i = 0; i < n; ++i) {
    const bool upright = run[i] == 0;
    inverse_run[i] = upright ? 0.0 : 1 / (upright ? 1.0 : run[i]);
    inverse_length[i] = std::sqrt(inverse_length2[i]);
    norm1[i] = inverse_length[i] *
               ((std::abs(along_x[i]) + std::abs(along_y[i])) * run[i] + std::abs(rise[i]));
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

void MoveBatch::assign(const SweepTree& pass, const std::vector<std::uint32_t>& slots) {
  slot = slots;
  lowest_tip = std::numeric_limits<double>::infinity();
  for (const std::uint32_t s : slot) {
    const SweptMove& m = pass.move(s);
    lowest_tip = std::min({lowest_tip, m.start.z, m.start.z + m.delta.z});
  }
  // Nothing that goes by upright balls holds then.
  if (pass.turns()) lowest_tip = -std::numeric_limits<double>::infinity();
  if (pass.profile().is_ball() && !pass.turns()) assign_balls(pass);
}

void MoveBatch::assign_balls(const SweepTree& pass) {
  const std::size_t n = padded_size();
  const double radius = pass.profile().corner_radius();
  for (auto* column : {&x, &y, &z, &along_x, &along_y, &run, &rise, &inverse_run, &inverse_length2,
                       &inverse_length, &norm1})
    if (column->size() < n) column->resize(n);
  for (std::size_t i = 0; i < n; ++i) {
    const SweptMove& m = pass.move(slot[std::min(i, slot.size() - 1)]);
    x[i] = m.start.x, y[i] = m.start.y;
    z[i] = (m.vertical() ? std::min(m.start.z, m.start.z + m.delta.z) : m.start.z) + radius;
    along_x[i] = m.along_x, along_y[i] = m.along_y;
    run[i] = m.run, rise[i] = m.vertical() ? 0.0 : m.delta.z;
    inverse_length2[i] = m.vertical() ? 0.0 : m.inverse_length2;
  }
  find_inverses(n, along_x.data(), along_y.data(), run.data(), rise.data(), inverse_length2.data(),
                inverse_run.data(), inverse_length.data(), norm1.data());
}

void MoveBatch::take(const MoveBatch& from, const std::vector<std::uint32_t>& places) {
  slot.resize(places.size());
  for (std::size_t i = 0; i < places.size(); ++i) slot[i] = from.slot[places[i]];
  lowest_tip = from.lowest_tip;
  if (from.x.empty() || places.empty()) return;
  const std::size_t n = padded_size();
  const auto copy = [&](std::vector<double>& to, const std::vector<double>& column) {
    if (to.size() < n) to.resize(n);
    for (std::size_t i = 0; i < places.size(); ++i) to[i] = column[places[i]];
    for (std::size_t i = places.size(); i < n; ++i) to[i] = to[places.size() - 1];
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

void BatchSamples::set(std::size_t i, const SweptSample& s, const SweepTree& pass,
                       std::uint32_t slot, const Vec3& p, double reach) {
  distance[i] = s.distance;
  gx[i] = s.gradient.x, gy[i] = s.gradient.y, gz[i] = s.gradient.z;
  if (!pass.turns()) return;
  if (sag.size() < distance.size()) sag.resize(distance.size()), t.resize(distance.size());
  sag[i] = std::isfinite(s.distance) ? pass.sag(slot, p, s, reach) : 0;
  t[i] = s.t;
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
