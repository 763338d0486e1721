#pragma once

#include <cstddef>

#include "reports/study/study_report.h"

namespace limitgauge::reports {

/// A study with all that its reports read.
struct SampleStudy {
  study::Plan plan;
  study::Table table;
  study::Analysis analysis;
  study_report::About about;
};

/// A grid of step-over, tolerance and allowance, 5 x 4 x 3 cases of a finish with a ball of 6 mm
/// over a dome: time by the length of the rows, uncut by their cusps, gouge by the tolerance. Some
/// pass, some fail, one each is undecided, an error and lost.
SampleStudy sample_study();
/// The same with `steps` values of the step-over in place of 5: 12 cases for each.
SampleStudy sample_study_of(std::size_t steps);
/// A list of three cases whose names, settings, labels and reasons are markup, formulas, control
/// characters and no UTF-8.
SampleStudy hostile_study();
/// Every case failed, was lost or is an error; nothing to recommend.
SampleStudy failed_study();
/// One case that passed.
SampleStudy single_study();

}  // namespace limitgauge::reports
