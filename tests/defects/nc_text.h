#pragma once

#include <string>
#include <vector>

#include "model/part/toolpath.h"
#include "tests/defects/surfaces/raster.h"

namespace limitgauge::tests::defects {

/// One line of a program that moves, before it is text.
struct Block {
  bool rapid = false;
  model::Vec3 to;
  int row = -1;  ///< of the raster; −1 for links
};

/// A program being edited: its blocks, and lines of text put in before some of them.
struct NcText {
  struct Insertion {
    std::size_t before = 0;  ///< block
    std::string line;
  };
  std::vector<Block> blocks;
  std::vector<Insertion> insertions;
  std::vector<std::size_t> dropped;  ///< blocks whose lines are left out of the text
  bool modal = false;                ///< words that repeat the line before are left out

  /// The program as RS274, six decimals.
  std::string text() const;
};

/// Rapid over the row's start, feed down, along, rapid up, row by row.
NcText program_of(const Rows& rows, double safe_z_mm, bool modal);

/// What the project's reader makes of the text: what a run of the verifier is given.
model::Toolpath read_back(const std::string& text);

}  // namespace limitgauge::tests::defects
