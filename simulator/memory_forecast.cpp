#include "simulator/memory_forecast.h"

#include <cmath>
#include <cstdio>
#include <string>

#include "engine/model/error.h"
#include "simulator/stock_grid.h"

namespace limitgauge::simulator {
namespace {

// A leaf of 8³ floats with its mask and its share of the tree above it.
constexpr double kLeafBytes = 2300;
// A leaf holds part of the band when the surface passes within half a leaf (on average over its
// directions 0.75 of its edge) and the band's half width.
constexpr double kLeafReachVoxels = 0.75 * 8 + kBandVoxels;

// Rounded up to two digits, so that the suggestion is a figure one can type.
double two_digits_up(double x) {
  const double unit = std::pow(10.0, std::floor(std::log10(x)) - 1);
  return std::ceil(x / unit) * unit;
}

std::string figure(const char* format, double x) {
  char text[64];
  std::snprintf(text, sizeof text, format, x);
  return text;
}

}  // namespace

double band_bytes(double area_mm2, double voxel_mm) {
  const double leaf_edge = 8 * voxel_mm;
  const double leaves =
      area_mm2 * 2 * kLeafReachVoxels * voxel_mm / (leaf_edge * leaf_edge * leaf_edge);
  return leaves * kLeafBytes;
}

void require_memory(double forecast_bytes, std::size_t limit_bytes, double voxel_mm) {
  const auto limit = static_cast<double>(limit_bytes);
  if (forecast_bytes <= limit) return;
  const double mib = 1024.0 * 1024.0;
  // The band's memory goes with the inverse square of the voxel.
  const double voxel = two_digits_up(voxel_mm * std::sqrt(forecast_bytes / limit));
  throw model::ResourceError("the stock needs about " + figure("%.0f", forecast_bytes / mib) +
                             " MiB at a voxel of " + figure("%g", voxel_mm) + " mm, allowed are " +
                             figure("%.0f", limit / mib) + " MiB; a voxel of " +
                             figure("%g", voxel) + " mm would do");
}

}  // namespace limitgauge::simulator
