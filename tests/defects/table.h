#pragma once

#include <ostream>
#include <vector>

#include "tests/defects/bench.h"
#include "tests/defects/scenes.h"

namespace limitgauge::tests::defects {

/// What the suite found, in figures that decide whether it passes.
struct Summary {
  std::size_t cases = 0, due = 0, missed = 0, misplaced = 0, misnamed = 0, uncontained = 0;
  std::size_t twins = 0, false_alarms = 0, undecided_twins = 0, broken = 0, with_voxels = 0;
  std::size_t surfaces = 0, cutters = 0;

  bool good() const {
    return missed == 0 && misplaced == 0 && misnamed == 0 && uncontained == 0 &&
           false_alarms == 0 && broken == 0;
  }
};

Summary summarize(const std::vector<PairResult>& results);
/// The tables as Markdown.
void write_tables(std::ostream& out, const std::vector<PairResult>& results);
/// One line a case that went wrong, and one a twin; enough to run it again.
void write_failures(std::ostream& out, const std::vector<PairResult>& results);
/// The same of scenes, one row a kind.
void write_scene_table(std::ostream& out, const std::vector<SceneResult>& results);
void write_scene_failures(std::ostream& out, const std::vector<SceneResult>& results);
/// One line a case, tab-separated.
void write_cases(std::ostream& out, const std::vector<PairResult>& results);

}  // namespace limitgauge::tests::defects
