#pragma once

#include <cstddef>
#include <vector>

namespace limitgauge::study {

/// Which of `points` (all of one dimension) no other one dominates, that is, is at most as large in
/// all coordinates and smaller in one. By rising coordinates, then by index; points that are alike
/// are all in or all out. Up to three coordinates take O(n log n), more of them O(n log n + n f)
/// for f points on the front.
std::vector<std::size_t> pareto_front(const std::vector<std::vector<double>>& points);

}  // namespace limitgauge::study
