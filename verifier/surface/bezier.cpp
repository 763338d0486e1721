#include "verifier/surface/bezier.h"

#include "verifier/surface/lanes.h"

namespace limitgauge::verifier {
namespace {

using model::Vec3;
using Line = std::array<double, 4>;

/// B-spline to Bézier coefficients in one variable.
constexpr Line to_bezier(const Line& p) {
  return {(p[0] + 4 * p[1] + p[2]) / 6, (2 * p[1] + p[2]) / 3, (p[1] + 2 * p[2]) / 3,
          (p[1] + 4 * p[2] + p[3]) / 6};
}

/// Applies `line(Line) -> Line` to all rows (stride 1) or columns (stride 4) of a coordinate.
template <int kStride, class F>
void each_line(std::array<double, 16>& c, F&& line) {
  constexpr int kAcross = kStride == 1 ? 4 : 1;
  for (int n = 0; n < 4; ++n) {
    double* at = c.data() + n * kAcross;
    const Line out = line(Line{at[0], at[kStride], at[2 * kStride], at[3 * kStride]});
    for (int k = 0; k < 4; ++k) at[k * kStride] = out[k];
  }
}

constexpr Line lower_part(const Line& p, double t) {
  const double a = p[0] + (p[1] - p[0]) * t, b = p[1] + (p[2] - p[1]) * t,
               c = p[2] + (p[3] - p[2]) * t, d = a + (b - a) * t, e = b + (c - b) * t;
  return {p[0], a, d, d + (e - d) * t};
}
constexpr Line upper_part(const Line& p, double t) {
  const double a = p[0] + (p[1] - p[0]) * t, b = p[1] + (p[2] - p[1]) * t,
               c = p[2] + (p[3] - p[2]) * t, d = a + (b - a) * t, e = b + (c - b) * t;
  return {d + (e - d) * t, e, c, p[3]};
}

template <int kStride>
Bezier between(const Bezier& b, double t0, double t1) {
  Bezier out = b;
  for (auto* c : {&out.x, &out.y, &out.z}) {
    if (t1 < 1) each_line<kStride>(*c, [&](const Line& p) { return lower_part(p, t1); });
    if (t0 > 0) each_line<kStride>(*c, [&](const Line& p) { return upper_part(p, t0 / t1); });
  }
  return out;
}

/// Both halves of four lines at once: the loop over the lines runs in vector registers.
template <int kStride>
void halve(const std::array<double, 16>& c, std::array<double, 16>& low,
           std::array<double, 16>& high) {
  constexpr int kAcross = kStride == 1 ? 4 : 1;
  for (int n = 0; n < 4; ++n) {
    const int at = n * kAcross;
    const double p0 = c[at], p1 = c[at + kStride], p2 = c[at + 2 * kStride],
                 p3 = c[at + 3 * kStride];
    const double a = (p0 + p1) / 2, b = (p1 + p2) / 2, d = (p2 + p3) / 2;
    const double e = (a + b) / 2, f = (b + d) / 2, g = (e + f) / 2;
    low[at] = p0, low[at + kStride] = a, low[at + 2 * kStride] = e, low[at + 3 * kStride] = g;
    high[at] = g, high[at + kStride] = f, high[at + 2 * kStride] = d, high[at + 3 * kStride] = p3;
  }
}

template <int kStride>
std::array<Bezier, 2> halves(const Bezier& b) {
  std::array<Bezier, 2> out;
  halve<kStride>(b.x, out[0].x, out[1].x);
  halve<kStride>(b.y, out[0].y, out[1].y);
  halve<kStride>(b.z, out[0].z, out[1].z);
  return out;
}

double middle_of(const std::array<double, 16>& c) {
  const auto row = [&](int j) { return c[j] + 3 * (c[j + 1] + c[j + 2]) + c[j + 3]; };
  return (row(0) + 3 * (row(4) + row(8)) + row(12)) / 64;
}

struct Basis {
  Line value, first, second;
};
constexpr Basis basis(double t) {
  const double s = 1 - t;
  return {{s * s * s, 3 * s * s * t, 3 * s * t * t, t * t * t},
          {-3 * s * s, 3 * s * (s - 2 * t), 3 * t * (2 * s - t), 3 * t * t},
          {6 * s, 6 * t - 12 * s, 6 * s - 12 * t, 6 * t}};
}

Vec3 combine(const Bezier& b, const Line& in_u, const Line& in_v) {
  Vec3 sum;
  for (int j = 0; j < 4; ++j)
    for (int i = 0; i < 4; ++i) sum += (in_u[i] * in_v[j]) * b.control(4 * j + i);
  return sum;
}

/// The four columns of a coordinate, combined along v: contiguous, so they share a register.
Line columns(const std::array<double, 16>& c, const Line& in_v) {
  Line sum;
  for (int i = 0; i < 4; ++i)
    sum[i] = (in_v[0] * c[i] + in_v[1] * c[4 + i]) + (in_v[2] * c[8 + i] + in_v[3] * c[12 + i]);
  return sum;
}
double along(const Line& a, const Line& b) {
  return (a[0] * b[0] + a[1] * b[1]) + (a[2] * b[2] + a[3] * b[3]);
}

/// First derivatives of a coordinate along one line of constant v.
struct SlopesAcross {
  Line value, first;
  SlopesAcross(const std::array<double, 16>& c, const Basis& v)
      : value(columns(c, v.value)), first(columns(c, v.first)) {}
  double du(const Basis& u) const { return along(value, u.first); }
  double dv(const Basis& u) const { return along(first, u.value); }
};

struct Scalars {
  double value, du, dv, duu, duv, dvv;
};
Scalars jet_of(const std::array<double, 16>& c, const Basis& u, const Basis& v) {
  const Line value = columns(c, v.value), first = columns(c, v.first),
             second = columns(c, v.second);
  return {along(value, u.value),  along(value, u.first), along(first, u.value),
          along(value, u.second), along(first, u.first), along(second, u.value)};
}

}  // namespace

Bezier from_bspline(const std::array<Vec3, 16>& grid) {
  Bezier b;
  for (int k = 0; k < 16; ++k) b.set(k, grid[k]);
  for (auto* c : {&b.x, &b.y, &b.z}) {
    each_line<1>(*c, to_bezier);
    each_line<4>(*c, to_bezier);
  }
  return b;
}

Vec3 point(const Bezier& b, double u, double v) {
  return combine(b, basis(u).value, basis(v).value);
}

BezierJet jet(const Bezier& b, double u, double v) {
  const Basis bu = basis(u), bv = basis(v);
  const Scalars x = jet_of(b.x, bu, bv), y = jet_of(b.y, bu, bv), z = jet_of(b.z, bu, bv);
  return {{x.value, y.value, z.value}, {x.du, y.du, z.du},    {x.dv, y.dv, z.dv},
          {x.duu, y.duu, z.duu},       {x.duv, y.duv, z.duv}, {x.dvv, y.dvv, z.dvv}};
}

Vec3 middle(const Bezier& b) {
  return {middle_of(b.x), middle_of(b.y), middle_of(b.z)};
}

std::array<Bezier, 2> split_u(const Bezier& b) {
  return halves<1>(b);
}
std::array<Bezier, 2> split_v(const Bezier& b) {
  return halves<4>(b);
}

InnerChords inner_chords(const Bezier& b) {
  return {b.control(7) - b.control(4) + b.control(11) - b.control(8),
          b.control(13) - b.control(1) + b.control(14) - b.control(2)};
}

bool longer_in_u(const Bezier& b) {
  const auto apart = [&](int k, int l) { return distance(b.control(k), b.control(l)); };
  return apart(0, 3) + apart(12, 15) >= apart(0, 12) + apart(3, 15);
}

Vec3 unit_normal(const Bezier& b, double u, double v) {
  const BezierJet j = jet(b, u, v);
  return normalized(cross(j.du, j.dv));
}

double extent_u(const Bezier& b) {
  double longest = 0;
  for (int j = 0; j < 4; ++j)
    longest = std::max(longest, distance(b.control(4 * j), b.control(4 * j + 3)));
  return longest;
}
double extent_v(const Bezier& b) {
  double longest = 0;
  for (int i = 0; i < 4; ++i)
    longest = std::max(longest, distance(b.control(i), b.control(12 + i)));
  return longest;
}

std::array<Bezier, 2> halved(const Bezier& b) {
  return longer_in_u(b) ? split_u(b) : split_v(b);
}

Change change_of(const Bezier& b, const Vec3& gradient) {
  std::array<double, 16> value;
  for (int k = 0; k < 16; ++k)
    value[k] = gradient.x * b.x[k] + gradient.y * b.y[k] + gradient.z * b.z[k];
  const auto range = [&](int first, int step) {
    const auto [low, high] = std::minmax(
        {value[first], value[first + step], value[first + 2 * step], value[first + 3 * step]});
    return high - low;
  };
  Change out;
  for (int j = 0; j < 4; ++j)
    out.u = std::max(out.u, range(4 * j, 1)), out.v = std::max(out.v, range(j, 4));
  return out;
}

Bezier restrict(const Bezier& b, double u0, double u1, double v0, double v1) {
  return between<4>(between<1>(b, u0, u1), v0, v1);
}

double area_mm2(const Bezier& b) {
  constexpr double kNode[] = {-0.9061798459386640, -0.5384693101056831, 0.0, 0.5384693101056831,
                              0.9061798459386640};
  constexpr double kWeight[] = {0.2369268850561891, 0.4786286704993665, 0.5688888888888889,
                                0.4786286704993665, 0.2369268850561891};
  std::array<Basis, 5> at;
  for (int k = 0; k < 5; ++k) at[k] = basis((1 + kNode[k]) / 2);
  double sum = 0;
  for (int j = 0; j < 5; ++j) {
    const SlopesAcross x(b.x, at[j]), y(b.y, at[j]), z(b.z, at[j]);
    for (int i = 0; i < 5; ++i) {
      const Vec3 du{x.du(at[i]), y.du(at[i]), z.du(at[i])};
      const Vec3 dv{x.dv(at[i]), y.dv(at[i]), z.dv(at[i])};
      sum += kWeight[i] * kWeight[j] * length(cross(du, dv)) / 4;
    }
  }
  return sum;
}

Bezier turned(Bezier b, const model::Pose& pose) {
  for (int k = 0; k < 16; ++k) b.set(k, pose.point(b.control(k)));
  return b;
}

Bezier shifted(Bezier b, const Vec3& by) {
  for (int k = 0; k < 16; ++k) b.x[k] += by.x, b.y[k] += by.y, b.z[k] += by.z;
  return b;
}

namespace {

/// Of four columns of control points at a time, by halves: the least and the greatest of numbers do
/// not depend on their order.
struct Columns {
  Lanes left, right;

  double least() const {
    return std::min(std::min(left[0], left[1]), std::min(right[0], right[1]));
  }
  double greatest() const {
    return std::max(std::max(left[0], left[1]), std::max(right[0], right[1]));
  }
};

/// The columns of `at(k)`, a pair of numbers of the control points from k on, each brought down to
/// one number by `pick`.
template <class At>
Columns columns_of(At&& at, Lanes (*pick)(Lanes, Lanes)) {
  Columns out{at(0), at(2)};
  for (int row = 4; row < 16; row += 4)
    out = {pick(out.left, at(row)), pick(out.right, at(row + 2))};
  return out;
}
template <class At>
double least_of(At&& at) {
  return columns_of(at, lesser).least();
}
template <class At>
double greatest_of(At&& at) {
  return columns_of(at, greater).greatest();
}

}  // namespace

model::Box3 control_box(const Bezier& b) {
  const auto least = [](const std::array<double, 16>& c) {
    return least_of([&](int k) { return lanes_at(c, k); });
  };
  const auto greatest = [](const std::array<double, 16>& c) {
    return greatest_of([&](int k) { return lanes_at(c, k); });
  };
  return {{least(b.x), least(b.y), least(b.z)}, {greatest(b.x), greatest(b.y), greatest(b.z)}};
}

model::Interval control_range(const Bezier& b, double base, const Vec3& g) {
  std::array<double, 16> values;
  for (int k = 0; k < 16; ++k) values[k] = base + g.x * b.x[k] + g.y * b.y[k] + g.z * b.z[k];
  const auto at = [&](int k) { return lanes_at(values, k); };
  return {least_of(at), greatest_of(at)};
}

double control_radius(const Bezier& b, const Vec3& centre) {
  std::array<double, 16> squared;
  for (int k = 0; k < 16; ++k) {
    const double dx = b.x[k] - centre.x, dy = b.y[k] - centre.y, dz = b.z[k] - centre.z;
    squared[k] = dx * dx + dy * dy + dz * dz;
  }
  return std::sqrt(greatest_of([&](int k) { return lanes_at(squared, k); }));
}

}  // namespace limitgauge::verifier
