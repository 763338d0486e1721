#include "verifier/gate/findings.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numeric>

namespace limitgauge::verifier {
namespace {

using model::Vec3;

/// Union of spots that lie close together, by a grid of buckets wider than any reach.
class Clusters {
 public:
  explicit Clusters(const std::vector<Spot>& spots) : spots_(spots), parent_(spots.size()) {
    std::iota(parent_.begin(), parent_.end(), std::size_t{0});
    double widest = 0;
    for (const Spot& s : spots) widest = std::max(widest, s.radius_mm);
    bucket_mm_ = kTogether_mm + 2 * widest;
    for (std::size_t i = 0; i < spots.size(); ++i) join(i);
  }
  std::size_t root(std::size_t i) {
    while (parent_[i] != i) i = parent_[i] = parent_[parent_[i]];
    return i;
  }

 private:
  using Key = std::array<long, 3>;

  void join(std::size_t i) {
    const Vec3& p = spots_[i].place.point;
    Key at{};
    for (int k = 0; k < 3; ++k) at[k] = std::lround(std::floor(p[k] / bucket_mm_));
    for (long n = 0; n < 27; ++n) {
      const auto near =
          buckets_.find({at[0] + n % 3 - 1, at[1] + n / 3 % 3 - 1, at[2] + n / 9 - 1});
      if (near == buckets_.end()) continue;
      for (const std::size_t j : near->second)
        if (distance(spots_[j].place.point, p) <=
            kTogether_mm + spots_[i].radius_mm + spots_[j].radius_mm)
          parent_[root(i)] = root(j);
    }
    buckets_[at].push_back(i);
  }

  const std::vector<Spot>& spots_;
  std::vector<std::size_t> parent_;
  std::map<Key, std::vector<std::size_t>> buckets_;
  double bucket_mm_ = 0;
};

void name_move(Finding& f, BodyRef body, std::span<const Pass> passes,
               std::span<const AssemblySweep> parts, const RemovedSpace& space) {
  f.raw_stock = space.is_stock(body);
  f.stage = f.move = f.line = 0;
  f.body = "cutter";
  if (f.raw_stock) return;
  f.stage = body.pass;
  if (body.pass >= passes.size()) {
    f.stage = parts[body.pass - passes.size()].stage;
    f.body = parts[body.pass - passes.size()].body;
  }
  f.move = space.move_of(body);
  f.line = passes[f.stage].path->moves[f.move].line;
}

/// The nearest body of each run of consecutive moves that are all near: what leaves and comes back
/// is another pass.
std::vector<NearPass> passes_around(const Vec3& p, const RemovedSpace& space,
                                    std::span<const Pass> passes, double reach_mm) {
  constexpr std::size_t kMost = 3;
  std::vector<BodyRef> bodies;
  space.within(p, reach_mm, bodies);
  std::erase_if(bodies, [&](BodyRef body) { return space.is_stock(body); });
  std::sort(bodies.begin(), bodies.end());
  std::vector<NearPass> out;
  for (std::size_t i = 0; i < bodies.size(); ++i) {
    const BodyRef body = bodies[i];
    const std::uint32_t move = space.move_of(body);
    const NearPass here{body.pass, move, passes[body.pass].path->moves[move].line,
                        space.distance(body, p).value};
    const bool goes_on =
        i > 0 && bodies[i - 1].pass == body.pass && bodies[i - 1].index + 1 == body.index;
    if (!goes_on)
      out.push_back(here);
    else if (here.distance_mm < out.back().distance_mm)
      out.back() = here;
  }
  // What the last stage should have taken, its own passes are to blame for.
  const std::size_t last = passes.size() - 1;
  std::stable_sort(out.begin(), out.end(), [last](const NearPass& a, const NearPass& b) {
    if ((a.stage == last) != (b.stage == last)) return a.stage == last;
    return a.distance_mm < b.distance_mm;
  });
  if (out.size() > kMost) out.resize(kMost);
  return out;
}

}  // namespace

void keep_deepest(std::vector<Finding>& findings) {
  std::stable_sort(findings.begin(), findings.end(),
                   [](const Finding& a, const Finding& b) { return a.depth_mm > b.depth_mm; });
  if (findings.size() > kMostFindings) findings.resize(kMostFindings);
}

std::vector<Finding> gather_findings(const Exceedance& found, const std::optional<Witness>& witness,
                                     std::span<const Pass> passes,
                                     std::span<const AssemblySweep> parts,
                                     const RemovedSpace& space) {
  std::vector<Spot> spots = found.spots;
  if (witness) spots.push_back({witness->place, witness->depth_mm, 0, 0, witness->body});
  Clusters clusters(spots);
  std::map<std::size_t, Finding> by_root;
  for (std::size_t i = 0; i < spots.size(); ++i) {
    const Spot& spot = spots[i];
    Finding& f = by_root[clusters.root(i)];
    f.area_mm2 += spot.area_mm2;
    f.extent_mm.add(spot.place.point);
    if (spot.depth_mm <= f.depth_mm) continue;
    f.place = spot.place, f.depth_mm = spot.depth_mm;
    name_move(f, spot.body, passes, parts, space);
  }
  std::vector<Finding> findings;
  for (auto& [root, finding] : by_root) findings.push_back(std::move(finding));
  return findings;
}

void name_passes(std::vector<Finding>& leftovers, const RemovedSpace& space,
                 std::span<const Pass> passes) {
  // A pass that bounds a leftover is not much further away than the nearest.
  constexpr double kShare = 1.5, kFurther_mm = 0.05;
  for (Finding& f : leftovers) {
    const double nearest = std::max(0.0, space.nearest(f.place.point).distance.value);
    f.passes = passes_around(f.place.point, space, passes, kShare * nearest + kFurther_mm);
  }
}

}  // namespace limitgauge::verifier
