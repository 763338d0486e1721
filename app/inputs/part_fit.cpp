#include "app/inputs/part_fit.h"

#include <algorithm>

#include "model/base/error.h"
#include "model/text/number_text.h"

namespace limitgauge::app {
namespace {

/// Largest side of the box about cage and stock: the part lies within the one or the other.
double extent_mm(const Job& job, const model::Cage* cage) {
  model::Box3 box = bounding_box(job.stock);
  if (cage != nullptr)
    for (const model::Vec3& vertex : cage->vertices) box.add(vertex);
  const model::Vec3 size = box.size();
  return std::max({size.x, size.y, size.z});
}

double largest_diameter_mm(const Job& job) {
  double largest_mm = 0;
  for (const JobStage& stage : job.stages)
    largest_mm = std::max(largest_mm, 2 * largest_radius_mm(stage.cutter));
  return largest_mm;
}

void require_at_most(const PartLength& stated, double most_mm, const char* most_is) {
  if (stated.mm <= most_mm) return;
  throw model::InputError(stated.place, stated.what + " is " + model::shortest(stated.mm) + " mm",
                          "at most " + model::six_digits(most_mm) + " mm, " + most_is);
}

}  // namespace

void require_fit(const Job& job, const model::Cage* cage) {
  const double most_mm = extent_mm(job, cage);
  for (const PartLength& stated : job.part_lengths)
    require_at_most(stated, most_mm,
                    cage != nullptr ? "the largest extent of cage and stock"
                                    : "the largest extent of the stock");
  if (job.stated_voxel)
    require_at_most(*job.stated_voxel, largest_diameter_mm(job),
                    "the diameter of the largest cutter");
}

}  // namespace limitgauge::app
