#include "engine/surface/section/section_strips.h"

#include <algorithm>
#include <numeric>
#include <utility>

#include "model/base/chunks.h"

namespace limitgauge::engine::surface {
namespace {

/// Planes cut by one thread at a time: neighbours go through the same memory.
constexpr std::size_t kMostPlanesAChunk = 16;

/// Fewer where a strip has so few planes that threads would be idle.
std::size_t planes_a_chunk(std::size_t planes, unsigned threads) {
  return std::clamp<std::size_t>(model::chunk_count(planes, std::max(1U, threads)), 1,
                                 kMostPlanesAChunk);
}

/// Of the grids that are held.
std::size_t points_held(const std::vector<std::optional<GridSection>>& held) {
  std::size_t sum = 0;
  for (const auto& section : held)
    if (section) sum += section->grid().points.size();
  return sum;
}

/// Lets go of all but those that are wanted (ascending).
void keep_only(std::span<const std::size_t> wanted, std::vector<std::optional<GridSection>>& held) {
  for (std::size_t g = 0; g < held.size(); ++g)
    if (!std::binary_search(wanted.begin(), wanted.end(), g)) held[g].reset();
}

/// A grid of a strip and the planes [first, last) of the strip that may meet it.
struct MetPiece {
  const GridSection* section = nullptr;
  std::size_t first = 0, last = 0;
  SectionStarts starts = {};  ///< of these planes
};

/// The chains of planes [begin, end) of a strip: grid by grid, so that neighbours go through the
/// same memory.
std::vector<std::vector<SectionChain>> chains_of(std::span<const MetPiece> pieces,
                                                 std::span<const double> values, std::size_t begin,
                                                 std::size_t end) {
  std::vector<std::vector<SectionChain>> found(end - begin);
  SectionScratch scratch;
  for (const MetPiece& piece : pieces) {
    if (piece.starts.empty()) continue;
    for (std::size_t k = std::max(begin, piece.first); k < std::min(end, piece.last); ++k)
      piece.section->trace(piece.starts, k - piece.first, values[k], scratch, found[k - begin]);
  }
  return found;
}

/// The sections of the planes of one strip of a family.
void trace_strip(std::vector<MetPiece> pieces, const SectionStrips::Strip& strip,
                 std::span<const double> family, const model::RunControl& control,
                 const SectionStrips::Take& take) {
  const std::span<const double> values = family.subspan(strip.first, strip.last - strip.first);
  model::parallel_chunks(pieces.size(), 1, control, [&](std::size_t i, std::size_t) {
    MetPiece& piece = pieces[i];
    piece.starts = piece.section->starts(values.subspan(piece.first, piece.last - piece.first));
  });
  const std::size_t chunk = planes_a_chunk(values.size(), control.threads);
  model::parallel_chunks(values.size(), chunk, control, [&](std::size_t begin, std::size_t end) {
    auto found = chains_of(pieces, values, begin, end);
    for (std::size_t k = begin; k < end; ++k) take(strip.first + k, found[k - begin]);
    control.report(static_cast<double>(strip.first + end) / static_cast<double>(family.size()));
  });
}

}  // namespace

std::size_t points_of(std::span<const SectionPiece> pieces) {
  std::size_t sum = 0;
  for (const SectionPiece& piece : pieces) sum += piece.points;
  return sum;
}

void measure_ranges(std::vector<SectionPiece>& pieces, int axis, const model::RunControl& control) {
  model::parallel_chunks(pieces.size(), 1, control, [&](std::size_t p, std::size_t) {
    SectionPiece& piece = pieces[p];
    piece.low = std::numeric_limits<double>::infinity();
    piece.high = -piece.low;
    for (const Vec3& point : piece.make().points) {
      piece.low = std::min(piece.low, point[axis]);
      piece.high = std::max(piece.high, point[axis]);
    }
  });
}

SectionStrips::SectionStrips(std::vector<SectionPiece> pieces, int axis, std::size_t most_points,
                             const model::RunControl& control)
    : pieces_(std::move(pieces)), axis_(axis), most_points_(most_points) {
  if (points_of(pieces_) > most_points_) return;
  std::vector<std::size_t> all(pieces_.size());
  std::iota(all.begin(), all.end(), std::size_t{0});
  kept_.resize(pieces_.size());
  make(all, control, kept_);
  for (std::size_t g = 0; g < pieces_.size(); ++g) {
    pieces_[g].low = kept_[g]->low();
    pieces_[g].high = kept_[g]->high();
  }
}

void SectionStrips::make(std::span<const std::size_t> wanted, const model::RunControl& control,
                         Held& held) const {
  model::parallel_chunks(wanted.size(), 1, control, [&](std::size_t i, std::size_t) {
    auto& section = held[wanted[i]];
    if (!section) section.emplace(pieces_[wanted[i]].make(), axis_);
  });
}

std::vector<SectionStrips::Planes> SectionStrips::meeting(std::span<const double> values) const {
  const auto up_to = [&](double at) {
    return static_cast<std::size_t>(std::upper_bound(values.begin(), values.end(), at) -
                                    values.begin());
  };
  std::vector<Planes> met;
  met.reserve(pieces_.size());
  for (const SectionPiece& piece : pieces_) met.push_back({up_to(piece.low), up_to(piece.high)});
  return met;
}

std::vector<std::size_t> SectionStrips::pieces_in(const Strip& strip,
                                                  std::span<const Planes> met) const {
  std::vector<std::size_t> found;
  for (std::size_t g = 0; g < met.size(); ++g)
    if (met[g].meet(strip)) found.push_back(g);
  return found;
}

SectionStrips::Loads SectionStrips::loads(std::span<const double> values) const {
  std::vector<std::size_t> ended(values.size() + 1);
  Loads found{std::vector<std::size_t>(values.size() + 1), {}};
  const std::vector<Planes> met = meeting(values);
  for (std::size_t g = 0; g < met.size(); ++g) {
    if (met[g].none()) continue;
    found.begun[met[g].first] += pieces_[g].points;
    ended[met[g].last] += pieces_[g].points;
  }
  std::size_t here = 0;
  for (std::size_t k = 0; k < values.size(); ++k) {
    here += found.begun[k];
    here -= ended[k];
    found.met.push_back(here);
  }
  return found;
}

std::vector<SectionStrips::Strip> SectionStrips::strips(std::span<const double> values) const {
  if (values.empty()) return {};
  if (!kept_.empty()) return {{0, values.size(), points_of(pieces_)}};
  const Loads load = loads(values);
  // What the worst plane takes by itself is held once in any case.
  const std::size_t most =
      std::max(most_points_, *std::max_element(load.met.begin(), load.met.end()));
  std::vector<Strip> found;
  for (std::size_t k = 0; k < values.size(); ++k) {
    if (!found.empty() && found.back().points + load.begun[k] <= most) {
      found.back().last = k + 1;
      found.back().points += load.begun[k];
    } else {
      found.push_back({k, k + 1, load.met[k]});
    }
  }
  return found;
}

std::size_t SectionStrips::trace(std::span<const double> values, const model::RunControl& control,
                                 const Take& take) const {
  const std::vector<Planes> met = meeting(values);
  std::size_t most = 0;
  Held made(pieces_.size());
  for (const Strip& strip : strips(values)) {
    const std::vector<std::size_t> wanted = pieces_in(strip, met);
    if (kept_.empty()) {
      // What the strip before has met as well stays.
      keep_only(wanted, made);
      make(wanted, control, made);
    }
    const Held& held = kept_.empty() ? made : kept_;
    most = std::max(most, points_held(held));
    std::vector<MetPiece> pieces;
    for (const std::size_t g : wanted)
      pieces.push_back({&*held[g], std::max(met[g].first, strip.first) - strip.first,
                        std::min(met[g].last, strip.last) - strip.first});
    trace_strip(std::move(pieces), strip, values, control, take);
  }
  return most;
}

}  // namespace limitgauge::engine::surface
