#pragma once

#include <string>
#include <vector>

#include "model/part/cage.h"
#include "model/part/cutter.h"

namespace limitgauge::tests::defects {

/// A surface of the suite: 10 to 14 mm wide, about the origin.
struct NamedCage {
  std::string name;
  model::Cage cage;
};

/// Smooth and creased, regular and with vertices of valence 3, 5 and 7, n-gons, open and closed,
/// each boundary rule. `fixtures` is the folder with the cages of the repository.
std::vector<NamedCage> suite_surfaces(const std::string& fixtures);
/// A flat, a ball, a bull and a taper.
std::vector<model::Cutter> suite_cutters();

}  // namespace limitgauge::tests::defects
