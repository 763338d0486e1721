#include "witness/bounds.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

#include "witness/tolerance.h"

namespace limitgauge::witness {
namespace {

using model::Cage;
using model::Index;
using model::Vec3;

constexpr double kHalfUlp = std::numeric_limits<double>::epsilon() / 2;         // 2^-53
constexpr double kHalfUlpBelowOne = std::numeric_limits<float>::epsilon() / 4;  // 2^-25

bool runs_out(double sharpness) {
  return sharpness > 0 && sharpness < model::kInfiniteSharpness;
}

double size_of_coordinates(const Cage& cage) {
  Vec3 most;
  for (const Vec3& v : cage.vertices) {
    most.x = std::max(most.x, std::abs(v.x));
    most.y = std::max(most.y, std::abs(v.y));
    most.z = std::max(most.z, std::abs(v.z));
  }
  return length(most);
}

double size_of(const Cage& cage) {
  model::Box3 box;
  for (const Vec3& v : cage.vertices) box.add(v);
  return box.empty() ? 0 : length(box.size());
}

/// The greatest number of points around a vertex or of a face.
int greatest_ring(const Cage& cage) {
  const model::CageSummary summary = summarize(cage);
  int most = 4;
  for (const auto* counts :
       {&summary.face_sizes, &summary.interior_valences, &summary.boundary_valences})
    if (!counts->empty()) most = std::max(most, counts->back()[0]);
  return most;
}

/// The finite sharpnesses of a cage, and at each of its vertices.
struct RunningOut {
  std::map<Index, std::vector<double>> at;
  double greatest = 0, rounding = 0;

  explicit RunningOut(const Cage& cage) {
    for (const auto& c : cage.creases)
      for (const Index v : c.vertices) add(v, c.sharpness);
    for (const auto& c : cage.corners) add(c.vertex, c.sharpness);
  }
  void add(Index vertex, double s) {
    if (!runs_out(s)) return;
    at[vertex].push_back(s);
    greatest = std::max(greatest, s);
    rounding = std::max(rounding, std::abs(s - static_cast<double>(in_single_precision(s))));
  }
  /// What taking means in single precision adds to a weight; the mean of two equal ones is exact.
  double of_means() const {
    double most = 0;
    for (const auto& [vertex, s] : at) {
      const bool exact = s.size() == 1 || (s.size() == 2 && s[0] == s[1]);
      if (!exact) most = std::max(most, kHalfUlpBelowOne * static_cast<double>(s.size()));
    }
    return most;
  }
};

}  // namespace

float in_single_precision(double sharpness) {
  constexpr auto kInfinite = static_cast<float>(model::kInfiniteSharpness);
  if (sharpness >= model::kInfiniteSharpness) return kInfinite;
  auto single = static_cast<float>(sharpness);
  if (std::ceil(static_cast<double>(single)) < std::ceil(sharpness))
    single = std::nextafter(single, kInfinite);
  return std::min(single, std::nextafter(kInfinite, 0.0F));
}

Bounds bounds_of(const Cage& cage, int steps) {
  Bounds bounds;
  const double a_step = (2.0 * greatest_ring(cage) + 4) * kHalfUlp;
  bounds.rounding_mm = size_of_coordinates(cage) * (steps * a_step + kEvaluation);
  const RunningOut running(cage);
  bounds.sharpness_mm =
      size_of(cage) * std::ceil(running.greatest) * (running.rounding + running.of_means());
  return bounds;
}

}  // namespace limitgauge::witness
