#include "verifier/reach/reach_map.h"

#include <deque>
#include <memory>
#include <mutex>
#include <stdexcept>

#include "model/base/chunks.h"
#include "verifier/reach/cell_classifier.h"

namespace limitgauge::verifier {

ReachMap::ReachMap(const SurfaceCells& cells, std::vector<Entry> entries)
    : entries_(std::move(entries)) {
  std::vector<IndexedCell> parts;
  parts.reserve(entries_.size());
  for (const Entry& e : entries_) {
    // A part is a point where its whole cell is one.
    IndexedCell part = indexed(cells.cells()[e.cell.whole]);
    part.rect = rect_of(e.cell);
    parts.push_back(part);
    area_[static_cast<int>(e.reach)] += e.area_mm2;
  }
  index_ = std::make_unique<const ParameterIndex>(std::span<const IndexedCell>(parts));
}

Reach ReachMap::of(const SurfaceCell& cell) const {
  const auto k = index_->find(cell.patch, cell.u_at(0.5), cell.v_at(0.5));
  if (!k || !rect_of(entries_[*k].cell).holds(rect_of(cell))) return Reach::undecided;
  return entries_[*k].reach;
}

Reach ReachMap::at(int patch, double u, double v) const {
  const Entry* entry = entry_at(patch, u, v);
  return entry ? entry->reach : Reach::undecided;
}

const ReachMap::Entry* ReachMap::entry_at(int patch, double u, double v) const {
  const auto k = index_->find(patch, u, v);
  return k ? &entries_[*k] : nullptr;
}

namespace {

/// On the floor of a slot as wide as the cutter one line of positions is free, which no small cell
/// is proven by either.
constexpr double kCoarserOnLevel = 2;

/// Hundreds of thousands of them: a vector that grows would hold three times as many.
using Entries = std::deque<ReachMap::Entry>;
using OpenCells = std::deque<OpenCell>;

/// Both, one after the other; lets go of them on the way.
std::vector<ReachMap::Entry> joined(Entries first, Entries second) {
  std::vector<ReachMap::Entry> all;
  all.reserve(first.size() + second.size());
  for (Entries* part : {&first, &second})
    for (; !part->empty(); part->pop_front()) all.push_back(part->front());
  return all;
}

using Decided = ReachDecision;

Decided decide(const CellClassifier& classifier, OpenCell& open, const SurfaceCell& cell,
               CellHalves& parts, const ReachOptions& options, bool last) {
  Decided decided{classifier.decide(open, cell, parts)};
  const double smallest =
      open.level ? kCoarserOnLevel * options.smallest_radius_mm : options.smallest_radius_mm;
  decided.halve = decided.reach == Reach::undecided && !last &&
                  control_radius(cell.shape, middle(cell.shape)) > smallest;
  decided.in_u = longer_in_u(cell.shape);
  if (!decided.halve) decided.area_mm2 = area_mm2(cell.shape);
  return decided;
}

/// Puts each cell of `level` where it belongs, and lets go of it.
OpenCells sorted(OpenCells level, const std::vector<Decided>& decided, Entries& done) {
  OpenCells next;
  for (const Decided& d : decided) {
    const OpenCell& open = level.front();
    if (!d.halve) {
      done.push_back({open.cell, d.reach, 0, d.area_mm2});
    } else {
      for (const CellPart& half : halved(open.cell, d.in_u))
        next.push_back({half, open.witness, open.cleared, open.pending, false, open.recorded});
    }
    level.pop_front();
  }
  return next;
}

/// Where a shared search stands: what its records are known by, and how many cells other parts of
/// it begin with.
struct Shared {
  const ReachSharing& with;
  std::uint32_t cutter = 0;
  std::size_t elsewhere = 0;
};

/// What was decided elsewhere; there the end of the effort may have come later.
std::optional<Decided> recorded(const Shared& shared, std::uint32_t depth, OpenCell& open,
                                const SurfaceCells& cells, bool last) {
  const ReachDecision* found =
      shared.with.known ? shared.with.known->find(shared.cutter, depth, open.cell) : nullptr;
  if (!found && open.recorded)
    throw std::logic_error("the records of a shared search end before the search does");
  open.recorded = found != nullptr;
  if (!found) return std::nullopt;
  Decided decided = *found;
  if (decided.halve && last) {
    decided.halve = false;
    decided.area_mm2 = area_mm2(cells.cell_of(open.cell).shape);
  }
  return decided;
}

/// Halves of cells for as many threads as there are, whose memory goes from one part of a search to
/// the next.
class SharedHalves {
 public:
  explicit SharedHalves(const SurfaceCells& cells) : cells_(cells) {}

  std::unique_ptr<CellHalves> take() {
    const std::lock_guard lock(mutex_);
    if (idle_.empty()) return std::make_unique<CellHalves>(cells_);
    std::unique_ptr<CellHalves> out = std::move(idle_.back());
    idle_.pop_back();
    return out;
  }
  void give_back(std::unique_ptr<CellHalves> halves) {
    halves->forget();
    const std::lock_guard lock(mutex_);
    idle_.push_back(std::move(halves));
  }

 private:
  const SurfaceCells& cells_;
  std::mutex mutex_;
  std::vector<std::unique_ptr<CellHalves>> idle_;
};

/// Halves cells until each is proven for one cutter, or the effort is spent.
Entries classify_cells(OpenCells level, const Reachability& reachability,
                       const ReachOptions& options, const Shared& shared,
                       const model::RunControl& control) {
  const SurfaceCells& own = reachability.cells();
  const CellClassifier classifier(own, reachability);
  SharedHalves halves(own);
  Entries done;
  std::size_t seen = shared.elsewhere;
  std::uint32_t depth = 0;
  while (!level.empty()) {
    seen += level.size();
    const bool last = seen > options.largest_cell_count;
    std::vector<Decided> decided(level.size());
    // The halves that are kept go with it: four times as many took 70 MB more, and no less time.
    constexpr std::size_t kChunk = 256;
    model::parallel_chunks(level.size(), kChunk, control, [&](std::size_t begin, std::size_t end) {
      std::unique_ptr<CellHalves> parts = halves.take();
      for (std::size_t i = begin; i < end; ++i) {
        const auto known = recorded(shared, depth, level[i], own, last);
        decided[i] =
            known ? *known
                  : decide(classifier, level[i], own.cell_of(level[i].cell), *parts, options, last);
      }
      halves.give_back(std::move(parts));
    });
    if (shared.with.record)
      for (std::size_t i = 0; i < level.size(); ++i)
        shared.with.record->add(shared.cutter, depth, level[i].cell, decided[i]);
    ++depth;
    level = sorted(std::move(level), decided, done);
  }
  return done;
}

}  // namespace

ReachMap classify_reach(const SurfaceCells& cells, const Reachability& reachability,
                        const ReachOptions& options, const model::RunControl& control) {
  return classify_reach(cells, std::span(&reachability, 1), std::span(&options, 1), control);
}

ReachMap classify_reach(const SurfaceCells& cells, std::span<const Reachability> cutters,
                        std::span<const ReachOptions> options, const model::RunControl& control,
                        const ReachSharing& sharing) {
  // What is left for the next cutter, with what those before it have proven.
  Entries left, done;
  std::size_t elsewhere = 0;
  for (std::uint32_t i = 0; i < cells.cells().size(); ++i) {
    const Bezier& shape = cells.cells()[i].shape;
    if (!(control_radius(shape, shape.control(0)) > 0)) continue;
    if (i < sharing.first || i >= sharing.end)
      ++elsewhere;
    else
      left.push_back({cells.whole(i), Reach::unreachable, 0, 0});
  }
  for (std::size_t k = 0; k < cutters.size() && !left.empty(); ++k) {
    Entries next;
    for (const Reach before : {Reach::unreachable, Reach::undecided}) {
      OpenCells level;
      for (const ReachMap::Entry& e : left)
        if (e.reach == before) level.push_back({e.cell, {}, {}, {}, false, false});
      // How many are left to later cutters elsewhere is not known here: none, which is no more.
      const Shared shared{sharing, static_cast<std::uint32_t>(k),
                          k == 0 && before == Reach::unreachable ? elsewhere : 0};
      Entries found = classify_cells(std::move(level), cutters[k], options[k], shared, control);
      for (; !found.empty(); found.pop_front()) {
        ReachMap::Entry& e = found.front();
        e.cutter = static_cast<std::uint32_t>(k);
        if (e.reach == Reach::unreachable) e.reach = before;
        (e.reach == Reach::reachable ? done : next).push_back(e);
      }
    }
    left = std::move(next);
  }
  return ReachMap(cells, joined(std::move(done), std::move(left)));
}

}  // namespace limitgauge::verifier
