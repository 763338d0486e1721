#pragma once

#include <span>
#include <vector>

#include "verifier/surface/neighbourhood.h"

namespace limitgauge::verifier {

/// One Catmull-Clark step of the neighbourhoods that share faces and sharpness, wherever their
/// points lie: the rules are looked up once, and points of the next level are sums by lists.
class Refinement {
 public:
  /// Of `n` nothing is read but how its points are joined and how sharply.
  explicit Refinement(const Neighbourhood& n);

  /// All points of the next level that a child of face 0 can touch, from those of this one.
  std::vector<model::Vec3> points(std::span<const model::Vec3> before) const;

  /// The neighbourhood of a child, as refine() has it, without its points: these are entries of
  /// points(), by `from`.
  struct Child {
    Neighbourhood net;
    std::vector<model::Index> from;
  };
  Child child(int k) const;

 private:
  enum class Rule { smooth, crease, corner };  // a dart is smooth
  struct Edge {
    model::Index a = 0, b = 0;
    double sharpness = 0;
    std::vector<int> faces;
  };
  struct Vertex {
    model::Index at = 0;
    Rule now = Rule::smooth, then = Rule::smooth;  ///< before and after this level's sharpness
    double left = 0;                               ///< how much of `now` counts where they differ
    std::vector<model::Index> ends, sharp_now, sharp_then;  ///< of the edges
    std::vector<int> faces;
  };

  bool is_centre(model::Index v) const;
  int centre_of(model::Index v) const;
  int find_edge(model::Index a, model::Index b) const;
  void collect_edges();
  Vertex vertex_of(model::Index v) const;
  bool touches(int f, int j, int k) const;
  model::Vec3 edge_point(const Edge& e, std::span<const model::Vec3> before,
                         const model::Vec3* face_points) const;
  static model::Vec3 by_rule(Rule rule, const Vertex& v, std::span<const model::Index> sharp,
                             std::span<const model::Vec3> before, const model::Vec3* face_points);
  static model::Vec3 vertex_point(const Vertex& v, std::span<const model::Vec3> before,
                                  const model::Vec3* face_points);

  Neighbourhood n_;  ///< without points
  std::vector<model::Index> centre_;
  std::vector<Edge> edges_;
  std::vector<Vertex> vertices_;  ///< beside centre_
};

}  // namespace limitgauge::verifier
