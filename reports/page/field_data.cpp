#include "reports/page/field_data.h"

#include <algorithm>

namespace limitgauge::reports::page {
namespace {

using verifier::DeviationField;
using verifier::StageDeviation;

/// Of single precision's 24: 1 part in 16 000 at worst, well below the width of a line on a page.
constexpr int kDeviationBits = 13;

/// How far a sample is beyond the threshold of findings, 0 within. Material that the cutter cannot
/// reach is no finding.
double beyond_mm(const DeviationField::Sample& s, const StageDeviation& d) {
  const double gouge = -double(s.deviation_mm) - d.gouge_threshold_mm;
  const double uncut = s.reachable ? double(s.deviation_mm) - d.uncut_threshold_mm : 0;
  return std::max({0.0, gouge, uncut});
}

/// Hands on the deepest samples of one patch to the shown ones that stand for them.
void carry_deepest(const StageDeviation& d, const PageGrid::Patch& p, std::size_t base,
                   std::vector<std::size_t>& carried) {
  const DeviationField::Grid& m = p.measured;
  for (std::uint32_t j = 0; j < m.rows; ++j)
    for (std::uint32_t i = 0; i < m.columns; ++i) {
      const std::size_t k = m.first + std::size_t(j) * m.columns + i;
      const double depth = beyond_mm(d.field.samples[k], d);
      if (depth == 0) continue;
      std::size_t& shown = carried[base + std::size_t(page_index(j, p.rows, m.rows)) * p.columns +
                                   page_index(i, p.columns, m.columns)];
      if (depth > beyond_mm(d.field.samples[shown], d)) shown = k;
    }
}

std::uint8_t flags_of(const DeviationField::Sample& s, bool own) {
  return static_cast<std::uint8_t>((s.reachable ? 0 : kUnreachable) |
                                   (s.raw_stock ? kRawStock : 0) | (own ? 0 : kFromNearby));
}

}  // namespace

std::vector<std::size_t> carried_samples(const StageDeviation& deviation, const PageGrid& grid) {
  std::vector<std::size_t> carried;
  visit_page_samples(grid, [&](std::size_t k) { carried.push_back(k); });
  if (grid.stride == 1) return carried;
  std::size_t base = 0;
  for (const PageGrid::Patch& p : grid.patches) {
    carry_deepest(deviation, p, base, carried);
    base += std::size_t(p.columns) * p.rows;
  }
  return carried;
}

Json field_data(const StageDeviation& deviation, const PageGrid& grid, std::size_t surface,
                Blob& blob) {
  const std::vector<std::size_t> carried = carried_samples(deviation, grid);
  std::vector<float> values;
  std::vector<std::uint32_t> line, stage;
  std::vector<std::uint8_t> flags;
  std::size_t at = 0;
  visit_page_samples(grid, [&](std::size_t own) {
    const std::size_t k = carried[at++];
    const DeviationField::Sample& s = deviation.field.samples[k];
    values.push_back(with_bits(s.deviation_mm, kDeviationBits));
    line.push_back(s.line), stage.push_back(s.stage);
    flags.push_back(flags_of(s, k == own));
  });
  return {{"surface", surface},
          {"deviation_mm", blob.add(values)},
          {"line", blob.add(line)},
          {"stage", blob.add(stage)},
          {"flags", blob.add(flags)}};
}

}  // namespace limitgauge::reports::page
