#pragma once

#include "reports/run/run_result.h"

namespace limitgauge::reports {

/// How the last stage of the sample job came out.
enum class Outcome { passed, failed, indeterminate };

/// A job of three stages (rough, semi, finish) on a wavy shell of 6x5 patches, 80x65 mm, made of
/// closed forms: no other part of the project had a hand in its figures. With `failed`, the second
/// stage fails and the third was not run; with `indeterminate`, the third is undecided.
/// `samples_per_edge` samples along each patch edge.
RunResult sample_result(Outcome outcome, int samples_per_edge = 9);

/// The failed job with programs of somebody else in place of planned paths: the first two stages
/// share one, and names try to be formulas, markup, links and placeholders.
RunResult foreign_result(int samples_per_edge = 41);

/// The passed job, its second stage with a shank, a holder and a tool that turns as it goes: at
/// each move's end it leans from +Z by 20 degrees towards where the move's index, in degrees, is
/// about +Z. It begins upright.
RunResult turning_result(int samples_per_edge = 41);

/// The failed job's programs cut without a design: its second stage fails by its process.
RunResult cut_result();

}  // namespace limitgauge::reports
