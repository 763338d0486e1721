#include "verifier/certificate/unavoidable.h"

#include <algorithm>
#include <cmath>

#include "model/base/chunks.h"
#include "verifier/cells/cell_bounds.h"
#include "verifier/reach/cell_contact.h"
#include "verifier/reach/lowest_tip.h"
#include "verifier/tolerance.h"

namespace limitgauge::verifier {
namespace {

using model::Vec3;

constexpr std::size_t kBatch = 32;
/// Better positions that proofs of the lower end may turn up before they are given up.
constexpr int kProofs = 40;

/// A cell that may hold the worst point; every point of it has a free tip within `upper`.
struct Open {
  CellPart cell;
  double upper = 0;
  bool is_spot = false;  ///< too small to be halved, once it was looked at
};
bool lower_of(const Open& a, const Open& b) {
  return a.upper < b.upper;
}

/// A point for which a good position was searched.
struct Tried {
  SurfacePlace place;
  double value = 0;
  Vec3 tip;
};

/// Positions that touch the middles of cells: the classification proved those of reachable cells;
/// where it has no proof they are searched for, if asked.
std::vector<Vec3> tips_of(const SurfaceCells& cells, const ReachMap& map,
                          const Reachability& reachability, std::size_t cutter_index,
                          bool with_search, const model::RunControl& control) {
  const auto& entries = map.entries();
  std::vector<std::optional<Vec3>> found(entries.size());
  model::parallel_for(entries.size(), control.threads, [&](std::size_t k) {
    if (entries[k].reach == Reach::unreachable) return;
    const SurfaceCell cell = cells.cell_of(entries[k].cell);
    const bool round = reachability.profile().flat_mm <= 0;
    const auto c = CellContact::of(offset_cell(cell.shape, {}), reachability.profile(),
                                   reachability.allowance_mm());
    const bool proven = entries[k].reach == Reach::reachable && entries[k].cutter == cutter_index;
    if (proven && c && (round || (!c->turning() && !c->level())))
      found[k] = c->tip();
    else if (with_search)
      found[k] = reachability.touching_tip(middle(cell.shape), middle_normal(cell));
  });
  std::vector<Vec3> tips;
  for (const auto& tip : found)
    if (tip) tips.push_back(*tip);
  return tips;
}

std::vector<SweptBody> positions_of(std::span<const Vec3> tips) {
  std::vector<SweptBody> out;
  out.reserve(tips.size());
  for (const Vec3& tip : tips) out.emplace_back(tip, tip);
  return out;
}

/// A retracted cutter over the middle of S: nothing of it is lower than its tip.
Vec3 retracted(const SurfaceCells& cells, double allowance_mm) {
  const model::Box3& box = cells.nodes().front().box;
  return {box.centre().x, box.centre().y, box.high.z + std::max(0.0, allowance_mm) + kRetracted_mm};
}

class Search {
 public:
  Search(const SurfaceCells& cells, const Reachability& reachability, std::vector<Vec3> tips,
         const model::Cutter& cutter, const UnavoidableOptions& options,
         const model::RunControl& control)
      : cells_(cells),
        cutter_(cutter),
        options_(options),
        control_(control),
        allowance_(reachability.allowance_mm()),
        lowest_(cells, reachability),
        tips_(std::move(tips)),
        given_(cutter, positions_of(tips_)),
        added_(cutter, {}) {}

  Unavoidable run(const ReachMap& map) {
    start(map);
    Unavoidable out;
    LowestTip::Proof proof;
    const Tried* worst = nullptr;
    for (int n = 0; n < kProofs; ++n) {
      do close_cells();
      while (reopen());
      worst = worst_tried();
      if (!worst || best_ <= 0) break;
      const std::size_t left =
          options_.largest_square_count - std::min(out.squares, options_.largest_square_count);
      proof = lowest_.prove(worst->place.point, allowance_ + best_ - tolerance(), left);
      out.squares += proof.squares;
      if (!proof.better) break;
      add_better(worst->place.point, *proof.better);
    }
    out.uncut_mm.high = std::max(0.0, highest() - allowance_ + kRounding_mm);
    if (worst && best_ > 0) {
      out.uncut_mm.low = std::max(0.0, proof.low_mm - allowance_ - kRounding_mm);
      out.place = worst->place;
    }
    out.reached_resolution = out.uncut_mm.width() <= 2 * tolerance() + 4 * kRounding_mm;
    out.cells = seen_, out.points = tried_.size();
    return out;
  }

 private:
  /// Half the width to be reached.
  double tolerance() const { return std::max(options_.resolution_mm, options_.share * best_) / 2; }
  double good_enough() const { return allowance_ + std::max(best_, 0.0) + tolerance(); }

  void start(const ReachMap& map) {
    for (const ReachMap::Entry& e : map.entries())
      if (e.reach != Reach::reachable) open_.push_back({e.cell, 0});
    constexpr std::size_t kChunk = 256;
    model::parallel_chunks(open_.size(), kChunk, control_, [&](std::size_t begin, std::size_t end) {
      std::optional<BodyRef> hint;
      FarPasses far;
      for (std::size_t i = begin; i < end; ++i) {
        const Bezier shape = cells_.cell_of(open_[i].cell).shape;
        const Vec3 m = middle(shape);
        const Nearest nearest = given_.nearest(m, hint, &far);
        hint = nearest.body;
        open_[i].upper = nearest.distance.value + control_radius(shape, m);
      }
    });
    std::make_heap(open_.begin(), open_.end(), lower_of);
  }

  double highest() const {
    double most = open_.empty() ? -1e300 : open_.front().upper;
    for (const Open& o : closed_) most = std::max(most, o.upper);
    return most;
  }

  const Tried* worst_tried() const {
    const auto worst =
        std::max_element(tried_.begin(), tried_.end(),
                         [](const auto& a, const auto& b) { return a.value < b.value; });
    return worst == tried_.end() ? nullptr : &*worst;
  }

  struct Looked {
    double upper = 0;
    std::optional<Tried> tried;
    bool is_spot = false, in_u = true;  ///< whether and which way to halve it
  };

  /// Bounds a cell, and searches for a position for its middle where that alone keeps it open.
  Looked look(const Open& open, double enough, bool may_try) const {
    const SurfaceCell cell = cells_.cell_of(open.cell);
    const Vec3 m = middle(cell.shape);
    const double radius = control_radius(cell.shape, m);
    Looked out{open.upper, {}, radius < kSmallestCell_mm, longer_in_u(cell.shape)};
    Nearest nearest = given_.nearest(m);
    Vec3 tip = tips_[nearest.body.index];
    if (!extra_.empty()) {
      const Nearest other = added_.nearest(m);
      if (other.distance.value < nearest.distance.value)
        nearest = other, tip = extra_[other.body.index];
    }
    double value = nearest.distance.value;
    if (value > enough && may_try) {
      tip = lowest_.improved(tip, m, settle(value));
      value = lowest_.distance(tip, m);
      out.tried = Tried{middle_place(cell, m), value, tip};
    }
    out.upper = std::min({out.upper, value + radius, by_one(cell.shape, tip)});
    if (out.upper > enough && value <= enough)
      out.upper = std::min(out.upper, by_many(cell.shape, enough));
    return out;
  }

  /// How near to the best a position for a point with this value is searched.
  double settle(double value) const {
    return std::max(tolerance(), options_.share * (value - allowance_) / 2) / 4;
  }

  /// d is convex: no point of the cell is further from the cutter than a control point.
  double by_one(const Bezier& cell, const Vec3& tip) const {
    double most = -1e300;
    for (int k = 0; k < 16; ++k) most = std::max(most, lowest_.distance(tip, cell.control(k)));
    return most;
  }

  double by_many(const Bezier& cell, double enough) const {
    double least = 1e300;
    std::vector<BodyRef> candidates;
    for (const RemovedSpace* space : {&given_, &added_}) {
      if (space == &added_ && extra_.empty()) continue;
      CellBounder bounder(*space);
      bounder.find_candidates(cell, candidates);
      least = std::min(least, bounder.bound(cell, candidates, enough).upper);
    }
    return least;
  }

  /// Takes cells worst first until all that are left are good enough, or the effort is spent.
  void close_cells() {
    while (!open_.empty() && open_.front().upper > good_enough() &&
           seen_ < options_.largest_cell_count) {
      control_.check();
      std::vector<Open> batch;
      while (!open_.empty() && batch.size() < kBatch && open_.front().upper > good_enough()) {
        std::pop_heap(open_.begin(), open_.end(), lower_of);
        batch.push_back(std::move(open_.back()));
        open_.pop_back();
      }
      seen_ += batch.size();
      const double enough = good_enough();
      const bool may_try = tried_.size() < options_.largest_point_count;
      std::vector<Looked> looked(batch.size());
      model::parallel_for(batch.size(), control_.threads,
                          [&](std::size_t i) { looked[i] = look(batch[i], enough, may_try); });
      remember(looked);
      for (std::size_t i = 0; i < batch.size(); ++i) settle_or_split(batch[i], looked[i]);
    }
  }

  void remember(const std::vector<Looked>& looked) {
    const std::size_t before = extra_.size();
    for (const Looked& l : looked)
      if (l.tried) {
        tried_.push_back(*l.tried);
        extra_.push_back(l.tried->tip);
      }
    if (extra_.size() == before) return;
    added_ = RemovedSpace(cutter_, positions_of(extra_));
    revalue();
  }

  /// A position found for one point may serve another as well.
  void revalue() {
    best_ = 0;
    for (Tried& t : tried_) {
      t.value = std::min(t.value, added_.nearest(t.place.point).distance.value);
      best_ = std::max(best_, t.value - allowance_);
    }
  }

  void settle_or_split(const Open& open, const Looked& looked) {
    if (looked.upper <= good_enough() || looked.is_spot) {
      closed_.push_back({open.cell, looked.upper, looked.is_spot});
      return;
    }
    for (const CellPart& half : halved(open.cell, looked.in_u)) {
      open_.push_back({half, looked.upper});
      std::push_heap(open_.begin(), open_.end(), lower_of);
    }
  }

  /// The worst point has a better position than was thought.
  void add_better(const Vec3& s, const Vec3& tip) {
    extra_.push_back(lowest_.improved(tip, s, settle(lowest_.distance(tip, s))));
    added_ = RemovedSpace(cutter_, positions_of(extra_));
    revalue();
  }

  /// Closed cells that are not good enough any more, since the worst value fell.
  bool reopen() {
    if (seen_ >= options_.largest_cell_count) return false;
    const double enough = good_enough();
    const auto again = std::partition(closed_.begin(), closed_.end(), [&](const Open& o) {
      return o.upper <= enough || o.is_spot;
    });
    if (again == closed_.end()) return false;
    for (auto it = again; it != closed_.end(); ++it) {
      open_.push_back(std::move(*it));
      std::push_heap(open_.begin(), open_.end(), lower_of);
    }
    closed_.erase(again, closed_.end());
    return true;
  }

  const SurfaceCells& cells_;
  const model::Cutter& cutter_;
  const UnavoidableOptions& options_;
  const model::RunControl& control_;
  double allowance_;
  LowestTip lowest_;
  std::vector<Vec3> tips_, extra_;  ///< given, and found
  RemovedSpace given_, added_;      ///< what they remove
  std::vector<Open> open_, closed_;
  std::vector<Tried> tried_;
  double best_ = 0;  ///< of the points tried, over the allowance
  std::size_t seen_ = 0;
};

}  // namespace

Unavoidable unavoidable_uncut(const SurfaceCells& cells, const ReachMap& map,
                              const Reachability& reachability, std::span<const Vec3> free_tips,
                              const model::Cutter& cutter, const UnavoidableOptions& options,
                              const model::RunControl& control, std::size_t cutter_index) {
  if (cells.cells().empty()) return {{0, 0}, {}, true, 0, 0, 0};
  std::vector<Vec3> tips =
      tips_of(cells, map, reachability, cutter_index, free_tips.empty(), control);
  tips.insert(tips.end(), free_tips.begin(), free_tips.end());
  tips.push_back(retracted(cells, reachability.allowance_mm()));
  Search search(cells, reachability, std::move(tips), cutter, options, control);
  return search.run(map);
}

}  // namespace limitgauge::verifier
