#include "engine/strategy/raster/isoline.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <optional>

namespace limitgauge::engine::strategy {
namespace {

/// An edge of the node grid: node index times two, plus one for the edge upwards.
using EdgeId = std::int64_t;

/// A directed piece of an isoline through one cell.
struct Piece {
  EdgeId from = 0, to = 0;
};

/// Which piece begins at an edge: open addressing, since a curve has thousands.
class EdgeTable {
 public:
  explicit EdgeTable(std::size_t count)
      : mask_(std::bit_ceil(2 * count + 1) - 1), slots_(mask_ + 1) {}

  void add(EdgeId edge, std::size_t piece) { slots_[slot_of(edge)] = {edge, piece, true}; }
  std::optional<std::size_t> find(EdgeId edge) const {
    const Slot& slot = slots_[slot_of(edge)];
    if (!slot.taken) return std::nullopt;
    return slot.piece;
  }

 private:
  struct Slot {
    EdgeId edge = 0;
    std::size_t piece = 0;
    bool taken = false;
  };
  std::size_t slot_of(EdgeId edge) const {
    constexpr std::uint64_t kGolden = 0x9E3779B97F4A7C15ULL;
    std::size_t at = (static_cast<std::uint64_t>(edge) * kGolden >> 32) & mask_;
    while (slots_[at].taken && slots_[at].edge != edge) at = (at + 1) & mask_;
    return at;
  }

  std::size_t mask_;
  std::vector<Slot> slots_;
};

float rounded_up(double value) {
  const auto nearest = static_cast<float>(value);
  return static_cast<double>(nearest) < value
             ? std::nextafter(nearest, std::numeric_limits<float>::infinity())
             : nearest;
}

class SquareMarch {
 public:
  SquareMarch(const Raster& raster, const std::vector<float>& field, const Window& window,
              double value)
      : raster_(raster), field_(field), window_(window), value_(value), least_(rounded_up(value)) {}

  std::vector<Isoline> run() {
    scan();
    EdgeTable starts(pieces_.size()), arrived(pieces_.size());
    for (std::size_t k = 0; k < pieces_.size(); ++k) starts.add(pieces_[k].from, k);
    for (std::size_t k = 0; k < pieces_.size(); ++k) arrived.add(pieces_[k].to, k);
    std::vector<Isoline> lines;
    used_.assign(pieces_.size(), 0);
    for (std::size_t k = 0; k < pieces_.size(); ++k)
      if (!arrived.find(pieces_[k].from)) lines.push_back(follow(k, starts));
    for (std::size_t k = 0; k < pieces_.size(); ++k)
      if (!used_[k]) lines.push_back(follow(k, starts));
    return lines;
  }

 private:
  /// Most cells are not crossed: rows of flags find those that are without branching.
  void scan() {
    const int columns = window_.last_column - window_.first_column + 1;
    std::vector<std::uint8_t> below = high_row(window_.first_row), mixed(below.size());
    for (int j = window_.first_row; j < window_.last_row; ++j) {
      std::vector<std::uint8_t> above = high_row(j + 1);
      for (int i = 0; i + 1 < columns; ++i)
        mixed[i] = static_cast<std::uint8_t>((below[i] ^ below[i + 1]) | (below[i] ^ above[i]) |
                                             (below[i] ^ above[i + 1]));
      const auto end = mixed.begin() + (columns - 1);
      for (auto at = std::find(mixed.begin(), end, 1); at != end; at = std::find(at + 1, end, 1))
        add_cell(window_.first_column + static_cast<int>(at - mixed.begin()), j);
      below = std::move(above);
    }
  }
  std::vector<std::uint8_t> high_row(int j) const {
    const int columns = window_.last_column - window_.first_column + 1;
    std::vector<std::uint8_t> high(static_cast<std::size_t>(columns));
    const float* row = &field_[node(window_.first_column, j)];
    const float least = least_;
    for (int i = 0; i < columns; ++i) high[i] = row[i] >= least;
    return high;
  }
  std::size_t node(int i, int j) const { return static_cast<std::size_t>(j) * raster_.columns + i; }
  bool inside(int i, int j) const { return field_[node(i, j)] >= value_; }
  EdgeId right_of(int i, int j) const { return static_cast<EdgeId>(node(i, j)) * 2; }
  EdgeId up_of(int i, int j) const { return static_cast<EdgeId>(node(i, j)) * 2 + 1; }

  /// Crossed edges counter-clockwise; a piece runs from where the border of the cell leaves the
  /// higher side to where it enters it, so that the higher side lies on its left.
  void add_cell(int i, int j) {
    const std::array<bool, 4> high = {inside(i, j), inside(i + 1, j), inside(i + 1, j + 1),
                                      inside(i, j + 1)};
    if (high[0] == high[1] && high[1] == high[2] && high[2] == high[3]) return;
    const std::array<EdgeId, 4> edge = {right_of(i, j), up_of(i + 1, j), right_of(i, j + 1),
                                        up_of(i, j)};
    std::array<EdgeId, 2> leaving{}, entering{};
    int n = 0, m = 0;
    for (int c = 0; c < 4; ++c) {
      if (high[c] && !high[(c + 1) % 4]) leaving[n++] = edge[c];
      if (!high[c] && high[(c + 1) % 4]) entering[m++] = edge[c];
    }
    if (n == 1) {
      pieces_.push_back({leaving[0], entering[0]});
      return;
    }
    add_saddle(i, j, high[0], edge);
  }

  /// The two high corners join through the cell when its mean is high.
  void add_saddle(int i, int j, bool first_high, const std::array<EdgeId, 4>& e) {
    const double mean = (static_cast<double>(field_[node(i, j)]) + field_[node(i + 1, j)] +
                         field_[node(i, j + 1)] + field_[node(i + 1, j + 1)]) /
                        4;
    const bool joined = mean >= value_;
    if (first_high && joined) {
      pieces_.push_back({e[0], e[1]});
      pieces_.push_back({e[2], e[3]});
    } else if (first_high) {
      pieces_.push_back({e[0], e[3]});
      pieces_.push_back({e[2], e[1]});
    } else if (joined) {
      pieces_.push_back({e[1], e[2]});
      pieces_.push_back({e[3], e[0]});
    } else {
      pieces_.push_back({e[1], e[0]});
      pieces_.push_back({e[3], e[2]});
    }
  }

  FlatPoint crossing(EdgeId id) const {
    const auto at = static_cast<std::size_t>(id / 2);
    const bool up = id % 2 == 1;
    const std::size_t next = at + (up ? static_cast<std::size_t>(raster_.columns) : 1);
    const double a = field_[at], b = field_[next];
    // Infinite heights meet finite ones half way.
    const double t = std::isfinite(a) && std::isfinite(b) ? (value_ - a) / (b - a) : 0.5;
    const auto column = static_cast<double>(at % static_cast<std::size_t>(raster_.columns));
    const auto row = static_cast<double>(at / static_cast<std::size_t>(raster_.columns));
    return {raster_.x(column + (up ? 0 : t)), raster_.y(row + (up ? t : 0))};
  }

  Isoline follow(std::size_t k, const EdgeTable& starts) {
    Isoline line;
    line.points.push_back(crossing(pieces_[k].from));
    for (;;) {
      used_[k] = 1;
      line.points.push_back(crossing(pieces_[k].to));
      const std::optional<std::size_t> next = starts.find(pieces_[k].to);
      if (!next) return line;
      k = *next;
      if (used_[k]) break;
    }
    line.closed = true;
    return line;
  }

  const Raster& raster_;
  const std::vector<float>& field_;
  Window window_;
  double value_;
  float least_;  ///< a float is no less than it exactly when it is no less than the value
  std::vector<Piece> pieces_;
  std::vector<char> used_;
};

}  // namespace

std::vector<Isoline> isolines(const Raster& raster, const std::vector<float>& field,
                              const Window& window, double value) {
  if (window.empty()) return {};
  return SquareMarch(raster, field, window, value).run();
}

}  // namespace limitgauge::engine::strategy
