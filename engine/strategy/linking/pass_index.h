#pragma once

#include <cstddef>
#include <vector>

#include "engine/strategy/linking/cut_pass.h"
#include "model/geometry/vec3.h"

namespace limitgauge::engine::strategy {

/// How a pass may be begun: at one of its points, forwards or from its end.
struct PassStart {
  int pass = 0;
  int point = 0;
  bool reversed = false;
};

/// The starts of passes still to be cut, in bins over XY.
class PassIndex {
 public:
  explicit PassIndex(const std::vector<CutPass>& passes);

  int left() const { return left_; }
  void remove(int pass);
  struct Near {
    double squared_mm2 = 0;
    PassStart start;
  };
  /// The nearest start of each of the `count` nearest passes, nearest first; of equally near ones
  /// the first pass and point.
  std::vector<Near> nearest(const model::Vec3& from, std::size_t count);

 private:
  struct Entry {
    model::Vec3 at;
    PassStart start;
  };
  void add_starts(const CutPass& pass, int index, std::vector<Entry>& entries) const;
  int column(double x) const;
  int row(double y) const;
  void look_in(int column, int row, const model::Vec3& from, std::vector<Near>& found);
  void look_around(int ring, const model::Vec3& from, std::vector<Near>& found);

  model::Box3 box_;
  double bin_mm_ = 1;
  int columns_ = 1, rows_ = 1;
  std::vector<std::vector<Entry>> bins_;
  std::vector<char> alive_;
  int left_ = 0;
};

}  // namespace limitgauge::engine::strategy
