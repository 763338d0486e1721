#pragma once

#include <cstdint>
#include <memory>
#include <mutex>
#include <optional>
#include <vector>

#include "verifier/cells/patch_charts.h"
#include "verifier/reach/cell_contact.h"

namespace limitgauge::verifier {

/// S round a cell that a cutter touches, as the graph of a height over the contact's plane, for any
/// point s of the cell with its own normal (CERTIFICATE.md, section 4): all that can be reached on
/// S from the cell over places of the plane nearer than `limit_mm` to s.
struct GraphRegion {
  /// A cell of S. What is said of distances holds for every point of it and every s.
  struct Cell {
    std::uint32_t index = 0;
    std::size_t from = 0;  ///< the cell of the region that it was reached from
    double near_mm = 0;    ///< no nearer to s in the plane; negative where that is not known
    double far_mm = 0;     ///< no further from s in space
    double bend = 0;       ///< no second derivative of the height is greater; 1/mm, 0 or more
    double rise_mm = 0;    ///< no higher above s along Z
  };
  std::vector<Cell> cells;  ///< that of the contact first
  double limit_mm = 0;

  /// What holds of the part over a disc round s, `radius_mm` up to `limit_mm`.
  struct Disc {
    double bend = 0, rise_mm = 0;
  };
  /// None where S may lie over the disc more than once.
  std::optional<Disc> over(double radius_mm) const;
};

/// Where S is such a graph: cells and how they lie beside one another.
class GraphRegions {
 public:
  /// All of which outlive this.
  GraphRegions(const std::vector<SurfaceCell>& cells, const ParameterIndex& index,
               const PatchCharts& charts);

  /// Of all cells, by index.
  const std::vector<model::Vec3>& middles() const { return middles_; }
  /// No cell's control points lie further from its middle.
  double largest_radius_mm() const { return largest_radius_mm_; }

  /// Round a contact of a part of cell `whole`, as far as `widest_mm`, as far as S goes on without
  /// an edge, an end or an irregular vertex, and as far as nothing bends more than `most_bend`
  /// (1/mm). None where the cell itself is no graph.
  std::optional<GraphRegion> around(const CellContact& contact, std::uint32_t whole,
                                    double widest_mm, double most_bend) const;

 private:
  /// What is worked out of a cell when it is first asked for, whichever thread asks.
  struct Shape {
    model::Vec3 normal;           ///< of the middle
    double cosine = 1, sine = 0;  ///< of how far other normals of it are turned
    std::optional<double> bend;   ///< greatest normal curvature towards the cutter, 0 or more
    std::vector<std::uint32_t> neighbours;  ///< cells that S goes on in, smoothly
  };
  class Search;

  const Shape& shape(std::uint32_t cell) const;
  bool ends(std::uint32_t cell) const;
  std::vector<std::uint32_t> neighbours(std::uint32_t cell) const;

  const std::vector<SurfaceCell>& cells_;
  const ParameterIndex& index_;
  const PatchCharts& charts_;
  std::vector<model::Vec3> middles_;
  std::vector<double> radii_mm_;
  double largest_radius_mm_ = 0;
  std::vector<std::vector<ParameterRect>> points_;  ///< by patch, those of irregular vertices
  mutable std::vector<std::unique_ptr<const Shape>> shapes_;
  mutable std::unique_ptr<std::once_flag[]> known_;
};

}  // namespace limitgauge::verifier
