#include "verifier/gate/field_samples.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "verifier/surface/surface_tree.h"

namespace limitgauge::verifier {
namespace {

using model::Vec3;

constexpr int kProbe = 8;
constexpr int kMostSamplesAlongPatch = 4096;
constexpr int kPatchesOfFacet = 3;

/// Steps over a length, `fewest` at least.
int steps_over(double length_mm, double spacing_mm, double fewest) {
  return static_cast<int>(std::clamp(std::ceil(length_mm / spacing_mm), fewest,
                                     static_cast<double>(kMostSamplesAlongPatch)));
}

/// Steps in u so that no step along any of a few u-lines is longer than the spacing on average.
int steps_along(const ReferenceSurface& surface, int patch, bool in_u, double spacing_mm) {
  double longest = 0;
  for (int line = 0; line <= kProbe; ++line) {
    double sum = 0;
    Vec3 last;
    for (int k = 0; k <= kProbe; ++k) {
      const double a = static_cast<double>(k) / kProbe, b = static_cast<double>(line) / kProbe;
      const Vec3 p = surface.evaluate(patch, in_u ? a : b, in_u ? b : a).position;
      if (k > 0) sum = std::max(sum, distance(p, last));
      last = p;
    }
    longest = std::max(longest, sum * kProbe);
  }
  return steps_over(longest, spacing_mm, 2);
}

/// Begins a grid of the samples that are added next, and adds its quads.
void add_grid(int patch, int patches, int columns, int rows, DeviationField& field) {
  const auto base = static_cast<std::uint32_t>(field.samples.size());
  field.grids.push_back({patch, static_cast<std::uint32_t>(columns),
                         static_cast<std::uint32_t>(rows), base, patches});
  const auto at = [&](int i, int j) { return base + static_cast<std::uint32_t>(j * columns + i); };
  for (int j = 0; j + 1 < rows; ++j)
    for (int i = 0; i + 1 < columns; ++i)
      field.quads.push_back({at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)});
}

void add_sample(const ReferenceSurface& surface, int patch, double u, double v,
                DeviationField& field) {
  const SurfaceSample s = surface.evaluate(patch, u, v);
  DeviationField::Sample sample;
  sample.place = {patch, u, v, s.position};
  sample.normal = s.normal;
  field.samples.push_back(sample);
}

void sample_patch(const ReferenceSurface& surface, int patch, double spacing_mm,
                  DeviationField& field) {
  const int nu = steps_along(surface, patch, true, spacing_mm),
            nv = steps_along(surface, patch, false, spacing_mm);
  add_grid(patch, 1, nu + 1, nv + 1, field);
  for (int j = 0; j <= nv; ++j)
    for (int i = 0; i <= nu; ++i)
      add_sample(surface, patch, static_cast<double>(i) / nu, static_cast<double>(j) / nv, field);
}

/// A facet as its grid takes it: corner 0 and 1 are the ends of its longest side.
struct FacetShape {
  int first = 0;  ///< which corner of the facet is corner 0
  double length_mm = 0, height_mm = 0;
  double foot = 0;  ///< where corner 2 lies along the side, of its length
};

FacetShape shape_of(const std::array<Vec3, 3>& p) {
  FacetShape shape;
  for (int k = 0; k < 3; ++k) {
    const Vec3 side = p[(k + 1) % 3] - p[k], rise = p[(k + 2) % 3] - p[k];
    const double length_mm = length(side);
    if (length_mm <= shape.length_mm) continue;
    shape = {k, length_mm, length(cross(side, rise)) / length_mm,
             std::clamp(dot(rise, side) / (length_mm * length_mm), 0.0, 1.0)};
  }
  return shape;
}

/// Where columns stand along the longest side: evenly on both sides of the corner opposite.
std::vector<double> column_places(const FacetShape& shape, double spacing_mm) {
  const auto steps_within = [&](double share) {
    return share > 0 ? steps_over(share * shape.length_mm, spacing_mm, 1) : 0;
  };
  const int before = steps_within(shape.foot), after = steps_within(1 - shape.foot);
  std::vector<double> places;
  for (int i = 0; i < before; ++i) places.push_back(shape.foot * i / before);
  places.push_back(shape.foot);
  for (int i = 1; i <= after; ++i)
    places.push_back(i == after ? 1 : shape.foot + (1 - shape.foot) * i / after);
  return places;
}

/// Shares of the three corners in the point `t` along the longest side and `up` of the way across.
std::array<double, 3> shares_at(double t, double up, double foot) {
  const std::array<double, 3> low{1 - t, t, 0};
  const double r = t < foot ? t / foot : foot < 1 ? (t - foot) / (1 - foot) : 0;
  const std::array<double, 3> high =
      t < foot ? std::array<double, 3>{1 - r, 0, r} : std::array<double, 3>{0, r, 1 - r};
  std::array<double, 3> shares;
  for (int k = 0; k < 3; ++k) shares[k] = low[k] + up * (high[k] - low[k]);
  return shares;
}

/// The point with these shares of the facet's corners is on the patch of the corner that has the
/// largest. There the next corner's is u/2 - uv/6, the one's before v/2 - uv/6.
void add_facet_sample(const ReferenceSurface& surface, int first_patch,
                      const std::array<double, 3>& shares, DeviationField& field) {
  const auto k = static_cast<int>(std::max_element(shares.begin(), shares.end()) - shares.begin());
  const double next = shares[(k + 1) % 3], before = shares[(k + 2) % 3];
  const double b = 3 - 2 * (before - next);
  const double u = 12 * next / (b + std::sqrt(std::max(b * b - 24 * next, 0.0)));
  const double v = 6 * before / (3 - u);
  add_sample(surface, first_patch + k, std::min(u, 1.0), std::min(v, 1.0), field);
}

void sample_facet(const ReferenceSurface& surface, int first_patch, double spacing_mm,
                  DeviationField& field) {
  std::array<Vec3, 3> corners;
  for (int k = 0; k < 3; ++k) corners[k] = surface.evaluate(first_patch + k, 0, 0).position;
  const FacetShape shape = shape_of(corners);
  const std::vector<double> columns = column_places(shape, spacing_mm);
  const int nv = steps_over(shape.height_mm, spacing_mm, 1);
  add_grid(first_patch, kPatchesOfFacet, static_cast<int>(columns.size()), nv + 1, field);
  for (int j = 0; j <= nv; ++j)
    for (const double t : columns) {
      std::array<double, 3> shares = shares_at(t, static_cast<double>(j) / nv, shape.foot);
      std::rotate(shares.begin(), shares.end() - shape.first, shares.end());
      add_facet_sample(surface, first_patch, shares, field);
    }
}

/// A quarter of each quad's area goes to each of its corners.
void share_out_areas(DeviationField& field) {
  for (const auto& quad : field.quads) {
    const auto p = [&](int k) { return field.samples[quad[k]].place.point; };
    const double area = length(cross(p(2) - p(0), p(3) - p(1))) / 2;
    for (const std::uint32_t k : quad) field.samples[k].area_mm2 += static_cast<float>(area / 4);
  }
}

}  // namespace

DeviationField sample_surface(const ReferenceSurface& surface, double spacing_mm) {
  DeviationField field;
  const bool is_faceted = surface.tree().is_faceted();
  const int step = is_faceted ? kPatchesOfFacet : 1;
  for (int patch = 0; patch < surface.patch_count(); patch += step) {
    if (!surface.has_surface(patch)) continue;
    if (is_faceted)
      sample_facet(surface, patch, spacing_mm, field);
    else
      sample_patch(surface, patch, spacing_mm, field);
  }
  share_out_areas(field);
  return field;
}

}  // namespace limitgauge::verifier
