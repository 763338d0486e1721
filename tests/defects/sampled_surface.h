#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "tests/defects/nose.h"
#include "verifier/reference_surface.h"

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

  SampledSurface(const verifier::ReferenceSurface& surface, double spacing_mm);

  /// The highest contact of a cutter that comes down over (x, y); none where it misses S.
  std::optional<Touch> drop(const Nose& nose, double x, double y) const;

  using Field = std::function<double(const Place&, const verifier::SurfaceSample&)>;
  /// Climbs from `start` to a local maximum of `field` by a compass search with turning directions,
  /// down to steps of `finest_mm`. The field may be −infinity where it has no value.
  Place climb(const Place& start, const Field& field, double finest_mm, double& value) const;

  const std::vector<Node>& nodes() const { return nodes_; }
  const verifier::ReferenceSurface& surface() const { return surface_; }
  verifier::SurfaceSample at(const Place& place) const {
    return surface_.evaluate(place.patch, place.u, place.v);
  }

 private:
  struct Grid {
    std::size_t first = 0;
    int steps = 0;
  };
  struct Bin {
    double highest = -std::numeric_limits<double>::infinity();
    std::vector<std::uint32_t> nodes;
  };
  struct Seen {
    double value = 0;
    std::uint32_t node = 0;
  };

  void fill_bins();
  std::vector<Seen> starts(const Nose& nose, double x, double y) const;
  void climb_on_nose(const Nose& nose, double x, double y, Touch& touch) const;
  std::optional<verifier::SurfaceSample> pulled_in(Place& place, double x, double y,
                                                   double wall) const;

  verifier::ReferenceSurface surface_;
  double spacing_ = 0;
  std::vector<Node> nodes_;
  model::Box3 box_;
  int bins_x_ = 0, bins_y_ = 0;
  std::vector<Bin> bins_;
};

}  // namespace limitgauge::tests::defects
