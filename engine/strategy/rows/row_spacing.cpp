#include "engine/strategy/rows/row_spacing.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

#include "engine/strategy/rows/drive_rows.h"
#include "model/base/chunks.h"

namespace limitgauge::engine::strategy {
namespace {

/// Distances are taken this much smaller than the cusps tried ask for, so that few rows need
/// halving afterwards.
constexpr double kPrudence = 0.97;
constexpr std::size_t kPairsAChunk = 8;

std::vector<double> with_middles(const std::vector<double>& rows) {
  std::vector<double> all;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    if (i > 0) all.push_back((rows[i - 1] + rows[i]) / 2);
    all.push_back(rows[i]);
  }
  return all;
}

/// How far apart rows may be between each two of the rows tried.
std::vector<double> distances_allowed(const BallSections& sections, const CutOptions& cut,
                                      const std::vector<double>& tried,
                                      const model::RunControl& control) {
  const std::vector<CentreRow> rows = rows_at(sections, with_middles(tried), control);
  const double step = cut.step_mm;
  std::vector<double> allowed(tried.size() - 1, step);
  model::parallel_chunks(
      allowed.size(), kPairsAChunk, control, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) {
          const double cusp =
              cusp_between(rows[2 * i], rows[2 * i + 1], rows[2 * i + 2], sections.reach_mm());
          const double apart = tried[i + 1] - tried[i];
          const double wanted = kPrudence * apart * std::sqrt(*cut.scallop_mm / cusp);
          if (cusp > 0) allowed[i] = std::clamp(wanted, kClosestShare * step, step);
        }
      });
  return allowed;
}

/// Each row as far from the one before as every interval between them allows.
std::vector<double> placed(const std::vector<double>& tried, const std::vector<double>& allowed) {
  std::vector<double> rows = {tried.front()};
  std::size_t i = 0;
  while (rows.back() < tried.back()) {
    const double from = rows.back();
    while (i + 1 < allowed.size() && tried[i + 1] <= from) ++i;
    double way = allowed[i];
    for (std::size_t k = i + 1; k < allowed.size() && tried[k] < from + way; ++k)
      way = std::min(way, std::max(allowed[k], tried[k] - from));
    rows.push_back(std::min(from + way, tried.back()));
  }
  return rows;
}

/// Puts rows into the middle of pairs whose cusp is too high; whether any was.
bool halve(const BallSections& sections, const CutOptions& cut, std::vector<CentreRow>& rows,
           std::vector<char>& settled, const model::RunControl& control) {
  std::vector<double> middles;
  std::vector<std::size_t> pairs;
  for (std::size_t i = 0; i + 1 < rows.size(); ++i) {
    if (settled[i] || rows[i + 1].across_mm - rows[i].across_mm < 2 * kClosestShare * cut.step_mm)
      continue;
    pairs.push_back(i);
    middles.push_back((rows[i].across_mm + rows[i + 1].across_mm) / 2);
  }
  std::vector<CentreRow> between = rows_at(sections, middles, control);
  std::vector<char> needed(pairs.size(), 0);
  model::parallel_chunks(
      pairs.size(), kPairsAChunk, control, [&](std::size_t begin, std::size_t end) {
        for (std::size_t k = begin; k < end; ++k)
          needed[k] = cusp_between(rows[pairs[k]], between[k], rows[pairs[k] + 1],
                                   sections.reach_mm()) > *cut.scallop_mm;
      });
  std::vector<CentreRow> all;
  std::vector<char> known;
  std::size_t k = 0;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const bool pair = k < pairs.size() && pairs[k] == i;
    all.push_back(std::move(rows[i]));
    known.push_back(!(pair && needed[k]));
    if (pair && needed[k]) {
      all.push_back(std::move(between[k]));
      known.push_back(0);
    }
    if (pair) ++k;
  }
  rows = std::move(all);
  settled = std::move(known);
  return std::find(needed.begin(), needed.end(), 1) != needed.end();
}

}  // namespace

std::vector<CentreRow> rows_at(const BallSections& sections, const std::vector<double>& across_mm,
                               const model::RunControl& control) {
  std::vector<Envelope> envelopes = sections.envelopes(across_mm, control);
  std::vector<CentreRow> rows;
  for (std::size_t i = 0; i < across_mm.size(); ++i)
    rows.push_back({across_mm[i], std::move(envelopes[i])});
  return rows;
}

std::vector<double> even_rows(const BallSections& sections, double step_mm) {
  const double reach = sections.reach_mm();
  return even_places(sections.low_mm() - reach, sections.high_mm() + reach, step_mm);
}

std::vector<CentreRow> scallop_rows(const BallSections& sections, const CutOptions& cut,
                                    const model::RunControl& control) {
  const std::vector<double> tried = even_rows(sections, cut.step_mm);
  if (tried.size() < 2) return rows_at(sections, tried, control);
  const std::vector<double> allowed = distances_allowed(sections, cut, tried, control);
  std::vector<CentreRow> rows = rows_at(sections, placed(tried, allowed), control);
  std::vector<char> settled(rows.size(), 0);
  while (halve(sections, cut, rows, settled, control)) control.check();
  return rows;
}

}  // namespace limitgauge::engine::strategy
