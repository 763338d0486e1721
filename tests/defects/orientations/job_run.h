#pragma once

#include <optional>
#include <string>
#include <vector>

#include "model/part/cage.h"
#include "model/part/cutter.h"
#include "model/part/stock.h"
#include "tests/defects/orientations/machine.h"
#include "tests/defects/orientations/stated_setup.h"
#include "tests/defects/surfaces/sampled_surface.h"
#include "verifier/gate/deviation.h"

namespace limitgauge::tests::defects {

/// A job of one stage that reads a program, as its files will say it.
struct JobText {
  model::Cage cage;                ///< in the part's frame, and so is the block
  std::vector<model::Vec3> block;  ///< eight corners; bit k of the number: high along axis k
  model::Cutter cutter;
  StatedSetup setup;
  std::optional<Machine> machine;
  std::string control;  ///< of a machine
  std::string program;
  double gouge_mm = 0, uncut_mm = 0, allowance_mm = 0;  ///< the gate
  double resolution_mm = 0;
};

/// A place that result.json names.
struct NamedPlace {
  Place place;
  model::Vec3 point;
  double depth_mm = 0;
  long line = 0;  ///< 0: none
};

/// What result.json says of a stage that was measured.
struct StageSaid {
  std::string verdict;
  std::size_t stretch = 0, stretches = 0;  ///< from 1; 0 where the program turns nothing
  verifier::Interval gouge, uncut;
  std::vector<NamedPlace> gouges, uncuts;
  std::vector<std::string> process;  ///< "rapid_through_stock at line 12"
};

struct JobSaid {
  int exit_code = -1;
  std::string errors;  ///< what the program printed of them
  std::string verdict;
  std::optional<StageSaid> stage;  ///< the last that cut and was measured
};

/// Writes the files into a folder of its own and has the built program run them:
/// `limitgauge run`. The folder is kept below `keep` where that is not empty.
JobSaid run_job(const JobText& job, const std::string& keep = {});

}  // namespace limitgauge::tests::defects
