#pragma once

#include <map>
#include <string>
#include <vector>

#include "tests/support/uniform_refinement.h"
#include "verifier/surface/reference_surface.h"

namespace limitgauge::tests {

/// A point whose position is known, and the kind of the patch's corner nearest to it.
struct LimitSample {
  int patch = 0;
  double u = 0, v = 0;
  model::Vec3 position;
  std::string kind;
};
/// The corners of all patches after `levels` ≥ 1 uniform refinements, by the limit masks.
std::vector<LimitSample> limit_samples(const model::Cage& cage, int levels);
/// The kind of the corner of `patch` nearest to (u, v), in words.
class CornerKinds {
 public:
  explicit CornerKinds(const model::Cage& cage);
  const std::string& nearest(int patch, double u, double v) const {
    return kinds_[patch][v > 0.5 ? (u > 0.5 ? 2 : 3) : (u > 0.5 ? 1 : 0)];
  }

 private:
  std::vector<std::array<std::string, 4>> kinds_;
};

/// Least number of refinements after which no sharpness is left to be used up.
int levels_of_sharpness(const model::Cage& cage);

double size_of(const model::Cage& cage);

/// Worst errors by kind of vertex, as parts of the cage's size.
struct ErrorTable {
  struct Row {
    long samples = 0;
    double worst = 0;
  };
  std::map<std::string, Row> rows;

  void add(const std::string& kind, double error);
  void add(const ErrorTable& other);
  double worst() const;
  std::string text() const;
};
ErrorTable evaluator_errors(const model::Cage& cage, int levels);

}  // namespace limitgauge::tests
