#include "verifier/findings.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <tuple>

namespace limitgauge::verifier {
namespace {

using model::Vec3;

struct Hit {
  SurfacePlace place;
  double depth_mm = 0, area_mm2 = 0;
  std::size_t stage = 0, move = 0;
  std::uint32_t line = 0;
  bool raw_stock = false;
};

/// Union of hits that lie within a reach of each other, by a grid of buckets as wide as the reach.
class Clusters {
 public:
  Clusters(const std::vector<Hit>& hits, double reach_mm) : parent_(hits.size()) {
    std::iota(parent_.begin(), parent_.end(), std::size_t{0});
    using Key = std::tuple<long, long, long>;
    std::map<Key, std::vector<std::size_t>> buckets;
    const auto cell = [&](double x) { return std::lround(std::floor(x / reach_mm)); };
    for (std::size_t i = 0; i < hits.size(); ++i) {
      const Vec3& p = hits[i].place.point;
      const Key at{cell(p.x), cell(p.y), cell(p.z)};
      for (long dx = -1; dx <= 1; ++dx)
        for (long dy = -1; dy <= 1; ++dy)
          for (long dz = -1; dz <= 1; ++dz) {
            const auto near =
                buckets.find({std::get<0>(at) + dx, std::get<1>(at) + dy, std::get<2>(at) + dz});
            if (near == buckets.end()) continue;
            for (const std::size_t j : near->second)
              if (distance(hits[j].place.point, p) <= reach_mm) parent_[root(i)] = root(j);
          }
      buckets[at].push_back(i);
    }
  }
  std::size_t root(std::size_t i) {
    while (parent_[i] != i) i = parent_[i] = parent_[parent_[i]];
    return i;
  }

 private:
  std::vector<std::size_t> parent_;
};

std::vector<Hit> hits_of(const DeviationField& field, Side side, double threshold_mm) {
  std::vector<Hit> hits;
  for (const DeviationField::Sample& s : field.samples) {
    const double depth = side == Side::gouge ? -static_cast<double>(s.deviation_mm)
                                             : static_cast<double>(s.deviation_mm);
    if (depth <= threshold_mm || (side == Side::uncut && !s.reachable)) continue;
    hits.push_back(
        {s.place, depth, static_cast<double>(s.area_mm2), s.stage, s.move, s.line, s.raw_stock});
  }
  return hits;
}

}  // namespace

std::vector<Finding> find_clusters(const DeviationField& field, Side side, double threshold_mm,
                                   const std::optional<Witness>& witness,
                                   std::span<const Pass> passes, double spacing_mm) {
  std::vector<Hit> hits = hits_of(field, side, threshold_mm);
  if (witness) {
    Hit hit{witness->place, witness->depth_mm, 0, 0, 0, 0, witness->body.pass >= passes.size()};
    if (!hit.raw_stock) {
      hit.stage = witness->body.pass, hit.move = witness->body.index;
      hit.line = passes[hit.stage].path->moves[hit.move].line;
    }
    hits.push_back(hit);
  }
  Clusters clusters(hits, 2 * spacing_mm);
  std::map<std::size_t, Finding> by_root;
  for (std::size_t i = 0; i < hits.size(); ++i) {
    Finding& f = by_root[clusters.root(i)];
    f.area_mm2 += hits[i].area_mm2;
    if (hits[i].depth_mm <= f.depth_mm) continue;
    f.place = hits[i].place, f.depth_mm = hits[i].depth_mm;
    f.stage = hits[i].stage, f.move = hits[i].move, f.line = hits[i].line;
    f.raw_stock = hits[i].raw_stock;
  }
  std::vector<Finding> findings;
  for (const auto& [root, finding] : by_root) findings.push_back(finding);
  std::stable_sort(findings.begin(), findings.end(),
                   [](const Finding& a, const Finding& b) { return a.depth_mm > b.depth_mm; });
  if (findings.size() > kMostFindings) findings.resize(kMostFindings);
  return findings;
}

}  // namespace limitgauge::verifier
