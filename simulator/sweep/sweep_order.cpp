#include "simulator/sweep/sweep_order.h"

#include <span>
#include <tuple>
#include <utility>

#include "model/base/chunks.h"
#include "model/geometry/box_tree.h"

namespace limitgauge::simulator {
namespace {

using model::Vec3;

constexpr std::uint32_t kLeafMoves = 4;
// Parts of a path below this are sorted by one thread.
constexpr std::uint32_t kPartMoves = 1 << 15;
constexpr std::size_t kSortChunk = 1 << 14;

struct Place {
  Vec3 middle;
  std::uint32_t index = 0;
};

// How many nodes lie below one over n moves, and below one over n + 1: the two sizes there are in
// each generation of halves.
std::pair<std::uint32_t, std::uint32_t> nodes_below(std::uint32_t n) {
  if (n < kLeafMoves) return {0, 0};
  const auto [half, more] = nodes_below(n / 2);
  const auto over = [](std::uint32_t moves, std::uint32_t a, std::uint32_t b) {
    return moves <= kLeafMoves ? 0 : 2 + a + b;
  };
  return n % 2 == 0 ? std::pair(over(n, half, half), over(n + 1, half, more))
                    : std::pair(over(n, half, more), over(n + 1, more, more));
}

struct Part {
  std::uint32_t node, begin, end;
  std::uint32_t below;  // where the nodes below this one go
};

class Sorter {
 public:
  Sorter(const model::Toolpath& path, const model::RunControl& control)
      : control_(control), places_(path.moves.size()) {
    model::parallel_chunks(places_.size(), kSortChunk, control_, [&](std::size_t a, std::size_t b) {
      for (std::size_t i = a; i < b; ++i)
        places_[i] = {(move_from(path, i) + path.moves[i].to) * 0.5, static_cast<std::uint32_t>(i)};
    });
  }

  SweepOrder sort() {
    const auto n = static_cast<std::uint32_t>(places_.size());
    if (n == 0) return {};
    order_.nodes.resize(1 + nodes_below(n).first);
    std::vector<Part> parts{{0, 0, n, 1}};
    while (!parts.empty()) parts = next_generation(parts);
    order_.moves.resize(n);
    for (std::uint32_t s = 0; s < n; ++s) order_.moves[s] = places_[s].index;
    return std::move(order_);
  }

 private:
  // Large parts are split once, small ones to the end.
  std::vector<Part> next_generation(const std::vector<Part>& parts) {
    std::vector<Part> halves(2 * parts.size());
    model::parallel_for(parts.size(), control_.threads, [&](std::size_t i) {
      control_.check();
      if (parts[i].end - parts[i].begin <= kPartMoves) return sort_part(parts[i]);
      std::tie(halves[2 * i], halves[2 * i + 1]) = split(parts[i]);
    });
    std::erase_if(halves, [](const Part& p) { return p.begin == p.end; });
    return halves;
  }

  void sort_part(const Part& part) {
    if (part.end - part.begin <= kLeafMoves) {
      order_.nodes[part.node] = {part.begin, part.end - part.begin};
      return;
    }
    const auto [low, high] = split(part);
    sort_part(low);
    sort_part(high);
  }

  std::pair<Part, Part> split(const Part& part) {
    const std::size_t half = model::halve_by_place(
        std::span(places_).subspan(part.begin, part.end - part.begin),
        [](const Place& place) -> const Vec3& { return place.middle; },
        [](const Place& place) { return place.index; });
    const std::uint32_t middle = part.begin + static_cast<std::uint32_t>(half);
    order_.nodes[part.node] = {part.below, 0};
    const std::uint32_t below_low = part.below + 2;
    const std::uint32_t below_high = below_low + nodes_below(middle - part.begin).first;
    return {{part.below, part.begin, middle, below_low},
            {part.below + 1, middle, part.end, below_high}};
  }

  const model::RunControl& control_;
  std::vector<Place> places_;
  SweepOrder order_;
};

}  // namespace

SweepOrder order_moves(const model::Toolpath& path, const model::RunControl& control) {
  return Sorter(path, control).sort();
}

}  // namespace limitgauge::simulator
