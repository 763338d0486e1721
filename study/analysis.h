#pragma once

#include <string>
#include <vector>

#include "study/table.h"

namespace limitgauge::study {

/// Rows that no other passing or failing row beats in every objective at once (all are to be
/// small).
struct Front {
  std::vector<std::string> objectives;  ///< ids of figures, the first is the one that is paid with
  std::vector<std::size_t> rows;        ///< into Table::rows, by rising first objective
};

/// How one figure answers to one key, the others at the values of the reference case.
struct Response {
  std::size_t key = 0, figure = 0;  ///< into Table::keys and Table::figures
  struct Point {
    std::size_t row;
    double setting;  ///< the number, or the setting's place in the order of the design
    double value;
  };
  std::vector<Point> points;    ///< by rising setting
  double change = 0;            ///< largest less smallest value
  double elasticity = 0;        ///< d ln(value) / d ln(setting) by least squares; 0 where undefined
  bool has_elasticity = false;  ///< needs three points above zero
};

/// The setting to take, with why.
struct Recommendation {
  std::optional<std::size_t> row;  ///< into Table::rows; empty where nothing passes
  std::string reason;              ///< whole sentences
};

struct Analysis {
  std::vector<Front> fronts;  ///< machining time against uncut, against gouge, and against both
  std::vector<Response> responses;
  Recommendation recommendation;
};

}  // namespace limitgauge::study
