#pragma once

#include <opensubdiv/far/primvarRefiner.h>
#include <opensubdiv/far/topologyRefiner.h>

#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

#include "model/part/cage.h"

namespace limitgauge::witness {

namespace Far = OpenSubdiv::Far;
namespace Sdc = OpenSubdiv::Sdc;

/// A position as PrimvarRefinerReal<double> combines it.
struct Primvar {
  model::Vec3 p;
  void Clear() { p = {}; }
  void AddWithWeight(const Primvar& other, double weight) { p += other.p * weight; }
};
using Primvars = std::vector<Primvar>;

/// The control points of a cage.
Primvars control_points(const model::Cage& cage);

/// OpenSubdiv does not take a cage, a vertex of more edges than it can count for one.
class CageRefused : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// Uniform refinement of a cage by OpenSubdiv's Far. Whatever includes OpenSubdiv includes this
/// header, which no other folder does.
class FarRefinement {
 public:
  /// Throws CageRefused. `levels` ≥ 1.
  FarRefinement(const model::Cage& cage, int levels);

  int levels() const { return refiner_->GetMaxLevel(); }
  const Far::TopologyLevel& level(int at) const { return refiner_->GetLevel(at); }
  const Far::TopologyLevel& last() const { return level(levels()); }
  /// Positions at the vertices of the last level, of those at the first.
  Primvars refined(Primvars points) const;
  const Far::TopologyRefiner& refiner() const { return *refiner_; }

 private:
  std::unique_ptr<Far::TopologyRefiner> refiner_;
};

/// What is left of sharpness at a vertex is to be used up: its limit is not by a mask yet.
bool is_semi_sharp(const Far::TopologyLevel& level, model::Index vertex);

/// Far's mask is that of the limit. At the end of a crease Far has the smooth mask, at an interior
/// vertex of valence two the corner's, and where sharpness is left, the mask of what is no longer
/// the rule one refinement later.
bool has_exact_mask(const Far::TopologyLevel& level, model::Index vertex);

/// "OpenSubdiv 3.5.0", as built against.
std::string evaluator_name();

}  // namespace limitgauge::witness
