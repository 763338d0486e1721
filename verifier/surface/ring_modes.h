#pragma once

#include "verifier/surface/sector.h"

namespace limitgauge::verifier {

/// Left eigenvectors of the refinement matrix of a vertex's ring: a linear function of the ring
/// that each refinement multiplies by λ. The surface beside the vertex is a sum over them of λ^k
/// times a fixed function of the direction times the vector that the eigenvector gives, so the
/// vectors of the two largest λ < 1 span the tangent plane.
///
/// Edge ends and opposite corners of smooth edges are coupled as e' = (v + e + f + f)/4 and
/// f' = (v + e + e + d)/4 whatever the vertex does, so a wave sin(iθ) over the edges stays one:
/// λ(θ) = (m + √(m² − 1/4))/2 with m = 5/8 + cos θ / 8, and the weight on an opposite corner is
/// (its two edges' weights) / (16λ − 4). For full turns λ is Halstead, Kass, DeRose 1993.
double ring_eigenvalue(double cosine);

/// Full turn: cos(2π(i − turn)/n) on edge i. n ≥ 3. The vertex has no weight, so its rule does not
/// matter.
RingWeights full_wave(int faces, double turn);
/// Full turn around a fixed vertex: equal weights on all edges, and minus their sum on the vertex.
RingWeights full_lift(int faces);
/// Between two edges of a crease: sin(iπk/faces) on the inner edges. Weights on the vertex and the
/// crease edges follow from the columns of the matrix. λ(πk/faces) must not be 1/2, the eigenvalue
/// of the crease itself, for even k. (The masks of Biermann, Levin and Zorin 2000 belong to their
/// modified rules, which coincide for two faces only.)
RingWeights crease_wave(int faces, int k);
/// The same where the vertex is fixed.
RingWeights corner_wave(int faces, int k);
/// A vertex with one crease (edge 0 of the slit sector) and the smooth rule: the limit position,
/// and the direction along the crease: the first two eigenvectors of what refinement does to rings
/// symmetric about the crease, to double precision. Across it is
/// full_wave(faces, faces / 4), since what is antisymmetric does not see the crease.
struct DartModes {
  RingWeights limit, along;
};
DartModes dart_modes(int faces);

/// Derivatives, along the two edges of face 0's corner `k`, on the diagonal of face 0, of the
/// function of the surface's parameters that has `values` on the ring and that a refinement
/// multiplies by `eigenvalue`.
struct Slopes {
  double next = 0, prev = 0;
};
Slopes diagonal_slopes(Neighbourhood n, int k, const Sector& s, const RingWeights& values,
                       double eigenvalue);

}  // namespace limitgauge::verifier
