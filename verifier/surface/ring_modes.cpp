#include "verifier/surface/ring_modes.h"

#include <Eigen/Eigenvalues>
#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>
#include <stdexcept>

#include "verifier/surface/regular_piece.h"

namespace limitgauge::verifier {
namespace {

using model::Vec3;
using std::numbers::pi;

double sum_of(const RingWeights& w) {
  return std::accumulate(w.face.begin(), w.face.end(),
                         std::accumulate(w.edge.begin(), w.edge.end(), w.vertex));
}

/// Weights on the opposite corners that belong to weights on the edges.
void add_faces(RingWeights& w, int faces, double lambda) {
  for (int i = 0; i < faces; ++i)
    w.face.push_back((w.edge[i] + w.edge[(i + 1) % w.edge.size()]) / (16 * lambda - 4));
}

/// sin(iπk/faces) on edges 0 to `faces`; exactly zero on the first and the last.
RingWeights pinned_wave(int faces, int k, double lambda) {
  RingWeights w;
  for (int i = 0; i <= faces; ++i)
    w.edge.push_back(i % faces == 0 ? 0 : std::sin(pi * k * i / faces));
  add_faces(w, faces, lambda);
  return w;
}

/// What one refinement hands down, from the inner edges and the faces, to a sharp edge's end.
double into_sharp_edge(double inner_edge, double face) {
  return inner_edge / 16 + face / 4;
}

/// The weights of the function after one refinement, as weights on the ring before: (weights) ×
/// (refinement matrix of a dart).
RingWeights before_refinement(const RingWeights& l) {
  const int n = static_cast<int>(l.face.size());
  const double vertex_share = l.vertex / (n * n);
  std::vector<double> into_face(n);
  for (int i = 0; i < n; ++i)
    into_face[i] =
        vertex_share + l.face[i] + ((i > 0 ? l.edge[i] : 0) + (i + 1 < n ? l.edge[i + 1] : 0)) / 4;
  RingWeights out;
  out.vertex = l.vertex * (n - 2) / n + l.edge[0] / 4;
  for (int i = 0; i < n; ++i) {
    out.vertex += (l.edge[i] + into_face[i]) / 4;
    out.edge.push_back(vertex_share + l.edge[i] / (i > 0 ? 4 : 2) +
                       (into_face[i > 0 ? i - 1 : n - 1] + into_face[i]) / 4);
    out.face.push_back(into_face[i] / 4);
  }
  return out;
}

/// The weights of a dart's ring that are symmetric about its sharp edge, as a column: vertex, edges
/// up to the opposite one, faces up to there. What is antisymmetric does not see the sharp edge,
/// and refinement keeps the two apart.
class SymmetricRing {
 public:
  explicit SymmetricRing(int faces) : faces_(faces) {}

  /// The eigenvalues of this are those of the refinement, its right eigenvectors their left ones.
  Eigen::MatrixXd refinement() const {
    Eigen::MatrixXd matrix(size(), size());
    for (int j = 0; j < size(); ++j)
      matrix.col(j) = column(before_refinement(weights(Eigen::VectorXd::Unit(size(), j))));
    return matrix;
  }
  RingWeights weights(const Eigen::VectorXd& column) const {
    RingWeights w{column[0], {}, {}};
    for (int i = 0; i < faces_; ++i) {
      w.edge.push_back(column[1 + std::min(i, faces_ - i)]);
      w.face.push_back(column[1 + edges() + std::min(i, faces_ - 1 - i)]);
    }
    return w;
  }

 private:
  int edges() const { return faces_ / 2 + 1; }
  int size() const { return 1 + edges() + (faces_ + 1) / 2; }
  Eigen::VectorXd column(const RingWeights& w) const {
    Eigen::VectorXd column(size());
    column[0] = w.vertex;
    for (int i = 0; i < edges(); ++i) column[1 + i] = w.edge[i];
    for (int i = 1 + edges(); i < size(); ++i) column[i] = w.face[i - 1 - edges()];
    return column;
  }

  int faces_;
};

/// `column` with one step of inverse iteration, which takes away what rounding in the other
/// eigenvectors' search left of them.
Eigen::VectorXd sharpened(const Eigen::MatrixXd& matrix, double eigenvalue,
                          const Eigen::VectorXd& column) {
  // Beside the eigenvalue, so that there is something to solve: what is wanted grows by 2^40.
  const double beside = eigenvalue + std::ldexp(1.0, -40);
  const auto identity = Eigen::MatrixXd::Identity(matrix.rows(), matrix.cols());
  return (matrix - beside * identity).partialPivLu().solve(column).normalized();
}

void scale(RingWeights& w, double by) {
  w.vertex *= by;
  for (double& e : w.edge) e *= by;
  for (double& f : w.face) f *= by;
}

/// Sum of all weights 1, as of a mean.
void make_mean(RingWeights& w) {
  scale(w, 1 / sum_of(w));
}

/// Without what rounding adds of the limit, and the greatest weight on an edge 1, the sharp edge's
/// positive.
void make_direction(RingWeights& w, const RingWeights& limit) {
  const double sum = sum_of(w);
  w.vertex -= sum * limit.vertex;
  double greatest = 0;
  for (std::size_t i = 0; i < w.face.size(); ++i) {
    w.edge[i] -= sum * limit.edge[i], w.face[i] -= sum * limit.face[i];
    greatest = std::max(greatest, std::abs(w.edge[i]));
  }
  scale(w, std::copysign(1 / greatest, w.edge[0]));
}

}  // namespace

double ring_eigenvalue(double cosine) {
  const double mean = 0.625 + cosine / 8;
  return (mean + std::sqrt(std::max(0.0, mean * mean - 0.25))) / 2;
}

RingWeights full_wave(int faces, double turn) {
  RingWeights w;
  const double step = 2 * pi / faces;
  for (int i = 0; i < faces; ++i) w.edge.push_back(std::cos(step * (i - turn)));
  add_faces(w, faces, ring_eigenvalue(std::cos(step)));
  return w;
}

RingWeights full_lift(int faces) {
  RingWeights w;
  w.edge.assign(faces, 1);
  add_faces(w, faces, ring_eigenvalue(1));
  w.vertex = -sum_of(w);
  return w;
}

RingWeights crease_wave(int faces, int k) {
  const double lambda = ring_eigenvalue(std::cos(pi * k / faces));
  RingWeights w = pinned_wave(faces, k, lambda);
  const double into_edge = into_sharp_edge(w.edge[1], w.face[0]);
  if (k % 2 == 0) {  // antisymmetric: nothing goes to the vertex
    w.edge.front() = into_edge / (lambda - 0.5), w.edge.back() = -w.edge.front();
    return w;
  }
  double into_vertex = 0;
  for (const double e : w.edge) into_vertex += 0.375 * e;
  for (const double f : w.face) into_vertex += f / 4;
  // (λ − 1/2)·e − v/8 = into_edge and (λ − 3/4)·v − e = into_vertex, for the weights e and v.
  const double determinant = (lambda - 0.5) * (lambda - 0.75) - 0.125;
  w.edge.front() = w.edge.back() = (into_edge * (lambda - 0.75) + into_vertex / 8) / determinant;
  w.vertex = ((lambda - 0.5) * into_vertex + into_edge) / determinant;
  return w;
}

RingWeights corner_wave(int faces, int k) {
  const double lambda = ring_eigenvalue(std::cos(pi * k / faces));
  RingWeights w = pinned_wave(faces, k, lambda);
  const double into_first = into_sharp_edge(w.edge[1], w.face.front());
  const double into_last = into_sharp_edge(w.edge[faces - 1], w.face.back());
  // In a slit both ends are one edge; what goes there of an even wave cancels.
  if (lambda != 0.5)
    w.edge.front() = into_first / (lambda - 0.5), w.edge.back() = into_last / (lambda - 0.5);
  w.vertex = -sum_of(w);
  return w;
}

DartModes dart_modes(int faces) {
  const SymmetricRing ring(faces);
  const Eigen::MatrixXd matrix = ring.refinement();
  const Eigen::EigenSolver<Eigen::MatrixXd> modes(matrix);
  const Eigen::VectorXd values = modes.eigenvalues().real();
  // The greatest is 1, of the limit; the next belongs to the direction along the crease.
  std::vector<Eigen::Index> order(static_cast<std::size_t>(values.size()));
  std::iota(order.begin(), order.end(), 0);
  std::partial_sort(order.begin(), order.begin() + 2, order.end(),
                    [&](Eigen::Index a, Eigen::Index b) { return values[a] > values[b]; });
  const auto mode = [&](int rank) {
    const Eigen::Index at = order[rank];
    return ring.weights(sharpened(matrix, values[at], modes.eigenvectors().col(at).real()));
  };
  DartModes dart{mode(0), mode(1)};
  make_mean(dart.limit);
  make_direction(dart.along, dart.limit);
  return dart;
}

Slopes diagonal_slopes(Neighbourhood n, int k, const Sector& s, const RingWeights& values,
                       double eigenvalue) {
  // What is not of the eigenfunction in the start falls by more than a half a step.
  constexpr int kSteps = 60;
  std::fill(n.points.begin(), n.points.end(), Vec3{});
  n.points[s.vertex].x = values.vertex;
  for (std::size_t i = 0; i < values.edge.size(); ++i) n.points[s.edge[i]].x = values.edge[i];
  for (std::size_t i = 0; i < values.face.size(); ++i) n.points[s.face[i]].x = values.face[i];
  for (int step = 0; step < kSteps; ++step) {
    n = refine(n)[k];
    for (Vec3& p : n.points) p.x /= eigenvalue;
  }
  const auto piece = regular_piece(refine(n)[(k + 2) & 3]);
  if (!piece) throw std::logic_error("the face across an irregular corner is not regular");
  const BezierJet j = jet(*piece, k == 1 || k == 2 ? 1 : 0, k >= 2 ? 1 : 0);
  const double u = j.du.x, v = j.dv.x;
  const std::array<Slopes, 4> by_corner = {{{u, v}, {v, -u}, {-u, -v}, {-v, u}}};
  return by_corner[k];
}

}  // namespace limitgauge::verifier
