#pragma once

#include <array>
#include <cstddef>
#include <string>
#include <vector>

#include "simulator/process/process_check.h"
#include "tests/simulator/paths.h"

namespace limitgauge::simulator::test {

/// The closed mesh of an upright box, seen from outside counter-clockwise.
model::TriangleMesh box_mesh(const model::Box3& box);
/// A closed tetrahedron, turned right side out.
model::TriangleMesh tetrahedron(const std::array<model::Vec3, 4>& corners);
model::Fixture fixture(const std::string& name, const model::TriangleMesh& mesh);

std::vector<Finding> of_kind(const std::vector<Finding>& all, FindingKind kind);
std::size_t count_of(const std::vector<Finding>& all, FindingKind kind);
/// The greatest depth in mm of a kind, −1 where there is none.
double worst_of(const std::vector<Finding>& all, FindingKind kind);

/// The pass with its path changed by `change(path)`.
template <class Change>
Pass changed(const Pass& pass, const Change& change) {
  model::Toolpath path = *pass.path;
  change(path);
  return {pass.cutter, std::make_shared<const model::Toolpath>(std::move(path))};
}
/// Every move in `pieces` equal parts.
Pass split(const Pass& pass, int pieces);

/// z from −8 to 0, 30 by 20 mm about the origin.
StockModel block();
model::Cutter flat4(double flutes = 20);
model::Cutter ball4();
/// A slot along x through block() whose floor is `depth` mm below the top, entered from the side.
Pass slot(const model::Cutter& c, double depth);

/// Findings at a tolerance of 0.01 mm.
inline constexpr double kTolerance = 0.01;
ProcessLimits plain_limits(double near_miss_mm = 0);
std::vector<Finding> check(const StockModel& before, const Pass& pass,
                           const ProcessLimits& limits = plain_limits(), unsigned threads = 2);

}  // namespace limitgauge::simulator::test
