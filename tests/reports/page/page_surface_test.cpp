#include <algorithm>
#include <cmath>
#include <set>

#include "reports/page/field_data.h"
#include "tests/support/catch.h"

using namespace limitgauge;
using namespace limitgauge::reports::page;
using verifier::DeviationField;

namespace {

/// Flat patches side by side, each of `columns` x `rows` samples that all deviate by nothing.
verifier::StageDeviation flat(const std::vector<std::pair<std::uint32_t, std::uint32_t>>& sizes) {
  verifier::StageDeviation d;
  DeviationField& field = d.field;
  int patch = 0;
  for (const auto& [columns, rows] : sizes) {
    field.grids.push_back({patch, columns, rows, std::uint32_t(field.samples.size())});
    for (std::uint32_t j = 0; j < rows; ++j)
      for (std::uint32_t i = 0; i < columns; ++i) {
        DeviationField::Sample s;
        s.place.patch = patch;
        s.place.u = double(i) / (columns - 1), s.place.v = double(j) / (rows - 1);
        s.place.point = {patch + s.place.u, s.place.v, 0};
        s.normal = {0, 0, 1};
        s.line = std::uint32_t(field.samples.size());
        field.samples.push_back(s);
      }
    ++patch;
  }
  d.gouge_threshold_mm = 0.05, d.uncut_threshold_mm = 0.1;
  return d;
}

std::size_t cells(const PageGrid& grid) {
  std::size_t sum = 0;
  for (const auto& p : grid.patches) sum += std::size_t(p.columns - 1) * (p.rows - 1);
  return sum;
}

}  // namespace

TEST_CASE("a field within the budget is shown whole", "[unit][page]") {
  const auto d = flat({{11, 6}, {3, 21}});
  const PageGrid grid = page_grid(d.field, 90);
  CHECK(grid.stride == 1);
  CHECK(cells(grid) == 50 + 40);
  std::size_t next = 0;
  visit_page_samples(grid, [&](std::size_t k) { CHECK(k == next++); });
  CHECK(next == d.field.samples.size());
}

TEST_CASE("a larger field is thinned by the smallest stride, borders and all", "[unit][page]") {
  const auto d = flat({{101, 52}, {3, 201}, {2, 2}});
  const PageGrid grid = page_grid(d.field, 1000);
  // 5100 + 400 + 1 cells; a stride of 2 leaves 50 x 26 + 1 x 100 + 1, of 3 34 x 17 + 1 x 67 + 1.
  CHECK(grid.stride == 3);
  CHECK(cells(grid) == 34 * 17 + 67 + 1);
  std::set<std::size_t> shown;
  visit_page_samples(grid, [&](std::size_t k) { CHECK(shown.insert(k).second); });
  for (const auto& g : d.field.grids)
    for (const std::uint32_t corner :
         {0U, g.columns - 1, (g.rows - 1) * g.columns, g.rows * g.columns - 1})
      CHECK(shown.count(g.first + corner) == 1);
}

TEST_CASE("every patch keeps a cell, whatever the budget", "[unit][page]") {
  const auto d = flat({{5, 5}, {9, 4}, {2, 2}});
  CHECK(cells(page_grid(d.field, 1)) == 3);
}

TEST_CASE("each measured line is stood for by the nearest shown one", "[unit][page]") {
  for (std::uint32_t measured = 2; measured < 40; ++measured)
    for (std::uint32_t shown = 2; shown <= measured; ++shown) {
      CHECK(measured_index(0, shown, measured) == 0);
      CHECK(measured_index(shown - 1, shown, measured) == measured - 1);
      for (std::uint32_t i = 0; i < shown; ++i)
        REQUIRE(page_index(measured_index(i, shown, measured), shown, measured) == i);
      for (std::uint32_t k = 0; k < measured; ++k) {
        // In steps of 1 / ((shown - 1) (measured - 1)), whole numbers, a half for the tie.
        const auto i = std::int64_t(page_index(k, shown, measured));
        REQUIRE(2 * std::abs(i * (measured - 1) - std::int64_t(k) * (shown - 1)) <= measured - 1);
      }
    }
}

TEST_CASE("of a thinned field no place beyond a threshold is lost", "[unit][page]") {
  auto d = flat({{101, 101}});
  auto& samples = d.field.samples;
  const auto at = [](std::size_t i, std::size_t j) { return j * 101 + i; };
  samples[at(39, 41)].deviation_mm = -0.06F;  // a gouge
  samples[at(38, 41)].deviation_mm = -0.07F;  // its deepest place
  samples[at(70, 70)].deviation_mm = 0.3F;    // a leftover ...
  samples[at(13, 81)].deviation_mm = 0.09F;   // ... within the limit
  samples[at(90, 21)].deviation_mm = 5, samples[at(90, 21)].reachable = false;
  const PageGrid grid = page_grid(d.field, 500);
  REQUIRE(grid.stride == 5);
  const std::vector<std::size_t> carried = carried_samples(d, grid);
  const auto has = [&](std::size_t k) {
    return std::count(carried.begin(), carried.end(), k) == 1;
  };
  CHECK(has(at(38, 41)));
  CHECK(has(at(70, 70)));
  CHECK_FALSE(has(at(39, 41)));
  CHECK_FALSE(has(at(13, 81)));
  std::size_t others = 0, i = 0;
  visit_page_samples(grid, [&](std::size_t k) { others += carried[i++] != k; });
  CHECK(others == 1);  // the gouge: the leftover is where a sample is shown
}

TEST_CASE("a field says from where its values are", "[unit][page]") {
  auto d = flat({{101, 101}});
  d.field.samples[5].deviation_mm = 1;
  d.field.samples[7].deviation_mm = 2;  // both stood for by number 1 of every 5
  d.field.samples[10].raw_stock = true, d.field.samples[15].reachable = false;
  const PageGrid grid = page_grid(d.field, 500);
  Blob blob;
  const Json field = field_data(d, grid, 3, blob);
  CHECK(field["surface"] == 3);
  const std::size_t flags = field["flags"]["at"];
  CHECK(blob.bytes().substr(flags, 4) == std::string("\0\4\2\1", 4));
  CHECK(field["deviation_mm"]["count"] == 21 * 21);
}

TEST_CASE("stages on the same samples share their surface", "[unit][page]") {
  const auto a = flat({{11, 6}}), b = flat({{11, 7}});
  auto moved = a;
  moved.field.samples[7].place.point.z = 0.25;
  Blob blob;
  Surfaces surfaces;
  const auto add = [&](const verifier::StageDeviation& d) {
    return surfaces.add(d.field, page_grid(d.field), blob);
  };
  CHECK(add(a) == 0);
  CHECK(add(b) == 1);
  CHECK(add(a) == 0);
  CHECK(add(moved) == 2);
  CHECK(surfaces.json().size() == 3);
  CHECK(surfaces.json()[0]["patches"][0]["rows"] == 6);
}
