#include "engine/strategy/locations/cutter_locations.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

#include "engine/strategy/locations/location_question.h"
#include "engine/strategy/locations/location_search.h"
#include "engine/tolerance.h"

namespace limitgauge::engine::strategy {
namespace {

void require_valid(const model::Cutter& cutter, double allowance_mm) {
  model::require_valid(cutter);
  if (!std::isfinite(allowance_mm) || allowance_mm < 0)
    throw std::invalid_argument("allowance must be zero or more");
}

std::vector<CutterShape> checked_shapes(const model::Cutter& cutter, double allowance_mm,
                                        Assembly assembly) {
  require_valid(cutter, allowance_mm);
  return cutter_shapes(cutter, allowance_mm, assembly == Assembly::whole);
}

Box3 extent_of(const Box3& box, const CutterShape& shape) {
  if (box.empty()) return box;
  const double reach = shape.reach_mm();
  return {{box.low.x - reach, box.low.y - reach, box.low.z - shape.height(reach)},
          {box.high.x + reach, box.high.y + reach, box.high.z - shape.bottom_mm()}};
}

std::optional<double> result_of(const GreatestLift& greatest) {
  if (!std::isfinite(greatest.value)) return std::nullopt;
  return greatest.value + kResultSlack_mm;
}

}  // namespace

struct CutterLocations::Tree {
  std::vector<CutterShape> shapes;  ///< the fluted part first
  LocationTree triangles;
  Box3 extent, fluted_extent;

  Tree(std::vector<surface::Grid> grids, std::vector<CutterShape> bodies)
      : shapes(std::move(bodies)), triangles(std::move(grids), shapes.front()) {
    fluted_extent = extent_of(triangles.box(), shapes.front());
    for (const CutterShape& shape : shapes) extent.add(extent_of(triangles.box(), shape));
  }

  template <class Question, class... Places>
  void search(GreatestLift& greatest, double enough, const Places&... places) const {
    if (triangles.empty()) return;
    for (const CutterShape& shape : shapes) {
      const Question question({shape, &shape == &shapes.front()}, places...);
      LocationSearch<Question>(triangles, question, greatest).run(enough);
      if (greatest.value > enough) return;
    }
  }
  void search_move(GreatestLift& greatest, double enough, const Vec3& a, const Vec3& b) const {
    if (a.x == b.x && a.y == b.y)
      search<PlaceQuestion>(greatest, enough, Vec3{a.x, a.y, std::min(a.z, b.z)});
    else
      search<MoveQuestion>(greatest, enough, a, b);
  }
};

CutterLocations::CutterLocations(std::vector<surface::Grid> grids, const model::Cutter& cutter,
                                 double allowance_mm, Assembly assembly)
    : tree_(std::make_shared<const Tree>(std::move(grids),
                                         checked_shapes(cutter, allowance_mm, assembly))) {}

std::optional<double> CutterLocations::tip_z(double x, double y) const {
  GreatestLift greatest;
  greatest.slack = kSearchSlack_mm;
  tree_->search<PlaceQuestion>(greatest, kNoEnd, Vec3{x, y, 0});
  return result_of(greatest);
}

std::optional<double> CutterLocations::tip_z_above(double x, double y, double least_mm) const {
  GreatestLift greatest;
  greatest.slack = kSearchSlack_mm;
  greatest.known = least_mm - kResultSlack_mm;
  tree_->search<PlaceQuestion>(greatest, kNoEnd, Vec3{x, y, 0});
  const std::optional<double> z = result_of(greatest);
  return z && *z > least_mm ? z : std::nullopt;
}

std::optional<double> CutterLocations::lift(const Vec3& a, const Vec3& b) const {
  GreatestLift greatest;
  greatest.slack = kSearchSlack_mm;
  tree_->search_move(greatest, kNoEnd, a, b);
  return result_of(greatest);
}

std::optional<double> CutterLocations::lift_above(const Vec3& a, const Vec3& b,
                                                  double least_mm) const {
  GreatestLift greatest;
  greatest.slack = kSearchSlack_mm;
  greatest.known = least_mm - kResultSlack_mm;
  tree_->search_move(greatest, kNoEnd, a, b);
  const std::optional<double> by = result_of(greatest);
  return by && *by > least_mm ? by : std::nullopt;
}

bool CutterLocations::clears(const Vec3& a, const Vec3& b, double slack_mm) const {
  GreatestLift greatest;
  greatest.known = slack_mm;
  tree_->search_move(greatest, slack_mm, a, b);
  return !(greatest.value > slack_mm);
}

const Box3& CutterLocations::extent() const {
  return tree_->extent;
}
const Box3& CutterLocations::fluted_extent() const {
  return tree_->fluted_extent;
}

}  // namespace limitgauge::engine::strategy
