#pragma once

#include <functional>
#include <optional>
#include <utility>
#include <vector>

#include "tests/defects/nose.h"
#include "verifier/surface/reference_surface.h"

namespace limitgauge::tests::defects {

/// A place on S.
struct Place {
  int patch = 0;
  double u = 0, v = 0;
};

/// Where a cutter that comes down at some (x, y) touches S: the height of its tip, and the contact.
struct Touch {
  double tip_z = 0;
  Place place;
  double rho = 0;  ///< radius on the cutter at which it touches
};

/// A limit surface as dense exact samples, with searches that start from them: what the certificate
/// does by bounds, done by looking everywhere.
class SampledSurface {
 public:
  struct Node {
    Place place;
    model::Vec3 point, normal;
  };
  /// The nodes of one patch: (steps + 1)² from `first` on, u fastest.
  struct Grid {
    int patch = 0;
    std::size_t first = 0;
    int steps = 0;
  };

  SampledSurface(const verifier::ReferenceSurface& surface, double spacing_mm);

  /// The highest contact of a cutter that comes down over (x, y); none where it misses S.
  std::optional<Touch> drop(const Nose& nose, double x, double y) const;

  using Field = std::function<double(const Place&, const verifier::SurfaceSample&)>;
  /// Climbs from `start` to a local maximum of `field` by a compass search with turning directions,
  /// down to steps of `finest_mm`. The field may be −infinity where it has no value.
  Place climb(const Place& start, const Field& field, double finest_mm, double& value) const;

  /// Calls `visit(node)` for every node whose (x, y) may lie within `radius_mm` of (x, y).
  template <class Visit>
  void near_in_plan(double x, double y, double radius_mm, Visit&& visit) const {
    const auto [i0, i1] = bin_range(box_.low.x, x, radius_mm, bins_x_);
    const auto [j0, j1] = bin_range(box_.low.y, y, radius_mm, bins_y_);
    for (int j = j0; j <= j1; ++j)
      for (int i = i0; i <= i1; ++i)
        for (const std::uint32_t k : bins_[static_cast<std::size_t>(j) * bins_x_ + i].nodes)
          visit(nodes_[k]);
  }

  const std::vector<Node>& nodes() const { return nodes_; }
  const std::vector<Grid>& grids() const { return grids_; }
  const Grid& grid_of(int patch) const { return grids_[static_cast<std::size_t>(grid_of_[patch])]; }
  double spacing_mm() const { return spacing_; }
  const verifier::ReferenceSurface& surface() const { return surface_; }
  /// Whether S ends at the place.
  bool is_on_rim(const Place& place) const;
  verifier::SurfaceSample at(const Place& place) const {
    return surface_.evaluate(place.patch, place.u, place.v);
  }

 private:
  struct Bin {
    double highest = -std::numeric_limits<double>::infinity();
    std::vector<std::uint32_t> nodes;
  };
  struct Seen {
    double value = 0;
    std::uint32_t node = 0;
  };

  void fill_bins();
  static std::pair<int, int> bin_range(double from, double at, double radius, int count);
  std::vector<Seen> starts(const Nose& nose, double x, double y) const;
  void climb_on_nose(const Nose& nose, double x, double y, Touch& touch) const;
  std::optional<verifier::SurfaceSample> pulled_in(Place& place, double x, double y,
                                                   double wall) const;

  verifier::ReferenceSurface surface_;
  double spacing_ = 0;
  std::vector<Node> nodes_;
  std::vector<Grid> grids_;
  std::vector<int> grid_of_;  ///< by patch
  model::Box3 box_;
  int bins_x_ = 0, bins_y_ = 0;
  std::vector<Bin> bins_;
};

}  // namespace limitgauge::tests::defects
