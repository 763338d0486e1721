#include "verifier/gate/deviation.h"

namespace limitgauge::verifier {
namespace {

void turn(Finding& finding, const model::Pose& pose) {
  finding.place.point = pose.point(finding.place.point);
  finding.extent_mm = pose.box(finding.extent_mm);
}

}  // namespace

void turn(StageDeviation& deviation, const model::Pose& pose) {
  for (auto* list : {&deviation.gouges, &deviation.uncuts, &deviation.missing_stock})
    for (Finding& finding : *list) turn(finding, pose);
  for (DeviationField::Sample& sample : deviation.field.samples) {
    sample.place.point = pose.point(sample.place.point);
    sample.normal = pose.direction(sample.normal);
  }
}

}  // namespace limitgauge::verifier
