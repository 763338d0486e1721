#include "simulator/instrument/dexel_patches.h"

#include <algorithm>
#include <cmath>

#include "simulator/sweep/vector_loops.h"
#include "simulator/tolerance.h"

namespace limitgauge::simulator {
namespace {

constexpr std::size_t kAll = DexelPatches::kPatches;
constexpr int kSide = DexelPatches::kEdge;
using PerLine = std::array<double, std::size_t{kSide} * kSide>;

// Places of a patch's lines from its middle, in spacings, and the sum of their squares.
constexpr double place(int k) {
  return k - 0.5 * (kSide - 1);
}
constexpr double kSquares = kSide * (kSide * kSide - 1) * kSide / 12.0;

struct Slopes {
  double x = 0, y = 0;  // a spacing
};

// Of the plane nearest to the tops; none where a line has no material.
LIMITGAUGE_WIDE
Slopes fit(const double* __restrict tops) {
  double sum[kSide] = {}, across[kSide] = {};
  for (int j = 0; j < kSide; ++j)
    for (int i = 0; i < kSide; ++i) {
      const double top = tops[j * DexelPatches::kLines + i];
      sum[i] += top;
      across[i] += top * place(j);
    }
  Slopes s;
  for (int i = 0; i < kSide; ++i) s.x += sum[i] * place(i), s.y += across[i];
  s.x /= kSquares, s.y /= kSquares;
  return std::isfinite(s.x) && std::isfinite(s.y) ? s : Slopes{};
}

// How high the plane of those slopes must be in the middle to lie over all tops.
LIMITGAUGE_WIDE
double height_over(const double* __restrict tops, const Slopes& s) {
  const double slope_x = s.x, slope_y = s.y;
  double most[kSide];
  for (double& m : most) m = -std::numeric_limits<double>::infinity();
  for (int j = 0; j < kSide; ++j)
    for (int i = 0; i < kSide; ++i) {
      const double over =
          tops[j * DexelPatches::kLines + i] - (slope_x * place(i) + slope_y * place(j));
      most[i] = over > most[i] ? over : most[i];
    }
  return *std::max_element(most, most + kSide);
}

}  // namespace

void DexelPatches::lay(std::size_t patch, const double* tops, const DexelFrame& frame) {
  if ((laid_ >> patch & 1U) != 0) return;
  laid_ |= 1U << patch;
  const std::size_t i = patch % kASide * kEdge, j = patch / kASide * kEdge;
  const double* first = tops + j * kLines + i;
  const Slopes s = fit(first);
  height_[patch] = height_over(first, s);
  slope_x_[patch] = s.x / frame.dx, slope_y_[patch] = s.y / frame.dy;
}

std::uint32_t DexelPatches::touched(const DexelSweep& sweep, const DexelFrame& frame) const {
  const double half = 0.5 * (kEdge - 1);
  Numbers x, y, clear;
  for (std::size_t k = 0; k < kAll; ++k) {
    x[k] = frame.x + (static_cast<double>(k % kASide * kEdge) + half) * frame.dx;
    y[k] = frame.y + (static_cast<double>(k / kASide * kEdge) + half) * frame.dy;
  }
  sweep.clearances({x.data(), y.data(), height_.data(), slope_x_.data(), slope_y_.data(),
                    half * frame.dx, half * frame.dy},
                   kAll, clear.data());
  std::uint32_t bits = 0;
  // Half of what a line must lose to lose anything is for rounding. Not a number: not known.
  for (std::size_t k = 0; k < kAll; ++k)
    bits |= clear[k] >= -0.5 * kDexelRounding_mm ? 0U : 1U << k;
  return bits;
}

}  // namespace limitgauge::simulator
