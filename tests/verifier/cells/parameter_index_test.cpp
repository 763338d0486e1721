#include "verifier/cells/parameter_index.h"

#include <algorithm>
#include <cstdint>
#include <random>
#include <set>
#include <vector>

#include <catch2/catch.hpp>

namespace limitgauge::verifier {
namespace {

/// Parts of one patch, halved at random as often as it takes for `count` of them.
std::vector<IndexedCell> random_parts(std::mt19937& random, std::size_t count) {
  std::vector<ParameterRect> parts = {{0, 1, 0, 1}};
  while (parts.size() < count) {
    const std::size_t k = random() % parts.size();
    const ParameterRect r = parts[k];
    ParameterRect low = r, high = r;
    if (random() % 2 == 0)
      low.u1 = high.u0 = (r.u0 + r.u1) / 2;
    else
      low.v1 = high.v0 = (r.v0 + r.v1) / 2;
    parts[k] = low, parts.push_back(high);
  }
  std::vector<IndexedCell> cells;
  for (const ParameterRect& r : parts) cells.push_back({0, false, r});
  return cells;
}

ParameterRect random_rect(std::mt19937& random, const ParameterRect& within) {
  std::uniform_real_distribution<double> share(0, 1);
  const auto pair = [&](double low, double high) {
    const double a = low + (high - low) * share(random), b = low + (high - low) * share(random);
    return std::pair(std::min(a, b), std::max(a, b));
  };
  const auto [u0, u1] = pair(within.u0, within.u1);
  const auto [v0, v1] = pair(within.v0, within.v1);
  return {u0, u1, v0, v1};
}

}  // namespace

TEST_CASE(
    "cells that overlap a rectangle are those within a part of it and those beyond, each once",
    "[property][cells]") {
  std::mt19937 random(11);
  for (int round = 0; round < 40; ++round) {
    const std::vector<IndexedCell> cells = random_parts(random, 200);
    const ParameterIndex index{std::span<const IndexedCell>(cells)};
    const ParameterRect rect = random_rect(random, {-0.2, 1.2, -0.2, 1.2});
    // Within it or not: what is counted is what touches.
    const ParameterRect inner = random_rect(random, round % 2 == 0 ? rect : ParameterRect{});
    std::multiset<std::uint32_t> expected, found;
    std::set<std::uint32_t> before;
    for (std::uint32_t k = 0; k < cells.size(); ++k) {
      if (cells[k].rect.touches(rect)) expected.insert(k);
      if (cells[k].rect.touches(inner)) before.insert(k);
    }
    index.overlapping(0, rect, [&](std::uint32_t k) { found.insert(k); });
    CHECK(found == expected);
    std::multiset<std::uint32_t> beyond, left;
    for (const std::uint32_t k : expected)
      if (before.count(k) == 0) left.insert(k);
    index.overlapping_beyond(0, rect, inner, [&](std::uint32_t k) { beyond.insert(k); });
    CHECK(beyond == left);
  }
}

TEST_CASE("places of what is left out as a point are in no cell", "[property][cells]") {
  std::mt19937 random(12);
  std::uniform_real_distribution<double> share(0, 1);
  for (int round = 0; round < 40; ++round) {
    std::vector<IndexedCell> cells = random_parts(random, 60);
    for (IndexedCell& cell : cells) cell.is_point = random() % 4 == 0;
    const ParameterIndex index{std::span<const IndexedCell>(cells)};
    for (int k = 0; k < 500; ++k) {
      const double u = share(random), v = share(random);
      const auto found = index.find(0, u, v);
      const auto holds = [&](const IndexedCell& cell) { return cell.rect.holds({u, u, v, v}); };
      const auto expected = std::find_if(cells.begin(), cells.end(), holds);
      CHECK(found.has_value() == !expected->is_point);
      if (found) CHECK(holds(cells[*found]));
    }
  }
}

}  // namespace limitgauge::verifier
