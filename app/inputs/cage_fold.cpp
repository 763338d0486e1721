#include "app/inputs/cage_fold.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <vector>

#include "model/base/tolerance.h"

namespace limitgauge::app {
namespace {

using model::Index;
using Corners = std::vector<Index>;

/// A number for each vertex, the same for vertices at the same place.
std::vector<Index> numbers_of_places(const model::Cage& cage) {
  std::map<std::array<std::int64_t, 3>, Index> known;
  std::vector<Index> numbers;
  for (const model::Vec3& v : cage.vertices) {
    std::array<std::int64_t, 3> place;
    for (const int axis : {0, 1, 2}) place[axis] = std::llround(v[axis] / model::kLeastLengthMm);
    numbers.push_back(known.try_emplace(place, static_cast<Index>(known.size())).first->second);
  }
  return numbers;
}

/// From the least number on: whichever corner a face is written from.
Corners from_least(Corners corners) {
  std::rotate(corners.begin(), std::ranges::min_element(corners), corners.end());
  return corners;
}

}  // namespace

std::optional<std::pair<Index, Index>> folded_faces(const model::Cage& cage) {
  const std::vector<Index> numbers = numbers_of_places(cage);
  std::vector<bool> is_hole(static_cast<std::size_t>(cage.face_count()), false);
  for (const Index hole : cage.holes) is_hole[static_cast<std::size_t>(hole)] = true;
  std::map<Corners, Index> known;
  for (Index f = 0; f < cage.face_count(); ++f) {
    if (is_hole[static_cast<std::size_t>(f)]) continue;
    Corners corners;
    for (const Index v : cage.face(f)) corners.push_back(numbers[static_cast<std::size_t>(v)]);
    known.try_emplace(from_least(corners), f);
    std::ranges::reverse(corners);
    if (const auto found = known.find(from_least(corners)); found != known.end())
      return std::pair(found->second, f);
  }
  return std::nullopt;
}

}  // namespace limitgauge::app
