#pragma once

#include <functional>
#include <memory>
#include <span>
#include <variant>
#include <vector>

#include "model/base/run_control.h"
#include "model/mesh/triangle_mesh.h"
#include "simulator/grid/lattice.h"
#include "simulator/mesh/net_source.h"

namespace limitgauge::simulator {

/// Says where a vertex of the net goes.
class NetPlacer {
 public:
  virtual ~NetPlacer() = default;
  /// `crossings` are where a cycle crosses the edges of the cell that begins at `cell`.
  virtual model::Vec3 place(const Index3& cell, std::span<const model::Vec3> crossings) = 0;
};
/// A placer for a few leaves, one after the other, always the same ones; called from any thread.
using MakePlacer = std::function<std::unique_ptr<NetPlacer>()>;

/// How much a net would take.
struct NetSize {
  std::size_t vertices = 0, triangles = 0, leaves = 0;
  double bytes() const;  ///< at its peak
};
NetSize surface_net_size(const NetSource& source, const model::RunControl& control);

/// The surface between negative and other values, turned outwards from the negative: one vertex for
/// each cycle of a cell, one quad, cut in two, about each lattice edge that the surface crosses.
///
/// Closed and manifold for any signs, as long as those at the rim are not negative. For the
/// segments of the cells' faces and the cycles make a closed surface: every segment lies on two
/// cells' cycles, and about every crossed lattice edge four cells close a ring. The quads are its
/// dual, so that each of their edges, one a segment, is shared by two, and those about a vertex
/// make one fan, in the order of its cycle. Two segments may join the same two vertices only where
/// they lie on one face with two segments; then both get a vertex in their middle and the quads
/// there one in theirs. A quad's diagonal joins cells that share no more than its lattice edge, so
/// that no other edge joins them.
model::TriangleMesh surface_net(const NetSource& source, const Lattice& lattice,
                                const MakePlacer& placers, const model::RunControl& control);
/// The same, or how much it would take where that is more than `most_bytes`: the cells that say so
/// are those that the net is made of.
std::variant<model::TriangleMesh, NetSize> surface_net_within(double most_bytes,
                                                              const NetSource& source,
                                                              const Lattice& lattice,
                                                              const MakePlacer& placers,
                                                              const model::RunControl& control);

}  // namespace limitgauge::simulator
