#include "simulator/triangle_minimum.h"

#include <algorithm>
#include <queue>
#include <vector>

namespace limitgauge::simulator {
namespace {

using model::Vec3;

struct Piece {
  TriangleCorners corners;
  double least = 0;  // lower bound
};
struct HigherBound {
  bool operator()(const Piece& a, const Piece& b) const { return a.least > b.least; }
};

class TriangleSearch {
 public:
  TriangleSearch(const CutterProfile& body, const SweptMove& move, double bound, double precision)
      : body_(body), move_(move), news_(bound), precision_(precision) {}

  std::optional<SurfacePlace> run(const TriangleCorners& triangle) {
    look_at(triangle);
    while (!queue_.empty()) {
      const Piece piece = queue_.top();
      queue_.pop();
      if (piece.least >= news_) break;
      halve(piece.corners);
    }
    return best_;
  }

 private:
  void look_at(const TriangleCorners& c) {
    const Vec3 centre = (c[0] + c[1] + c[2]) / 3;
    const SweptSample s = swept_distance(body_, move_, centre);
    double least = s.distance;
    for (const Vec3& corner : c)
      least = std::min(least, s.distance + dot(s.gradient, corner - centre));
    if (least >= news_) return;
    if (s.distance < news_) {
      best_ = SurfacePlace{centre, s.distance};
      news_ = s.distance - precision_;
    }
    queue_.push({c, least});
  }

  void halve(const TriangleCorners& c) {
    int longest = 0;
    double most = 0;
    for (int i = 0; i < 3; ++i)
      if (const double l = length_squared(c[(i + 1) % 3] - c[i]); l > most) most = l, longest = i;
    const Vec3 &a = c[longest], &b = c[(longest + 1) % 3], &apex = c[(longest + 2) % 3];
    const Vec3 middle = (a + b) * 0.5;
    // Nothing is left to tell apart between two neighbouring numbers.
    if (middle == a || middle == b) return;
    look_at({a, middle, apex});
    look_at({middle, b, apex});
  }

  const CutterProfile& body_;
  const SweptMove& move_;
  double news_;  // only what is lower matters
  double precision_;
  std::optional<SurfacePlace> best_;
  std::priority_queue<Piece, std::vector<Piece>, HigherBound> queue_;
};

}  // namespace

std::optional<SurfacePlace> least_on_triangle(const CutterProfile& body, const SweptMove& move,
                                              const TriangleCorners& triangle, double bound,
                                              double precision_mm) {
  return TriangleSearch(body, move, bound, precision_mm).run(triangle);
}

}  // namespace limitgauge::simulator
