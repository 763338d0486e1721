#include "verifier/reach/reach_records.h"

#include <bit>

#include "verifier/reach/packed_cell.h"

namespace limitgauge::verifier {
namespace {

constexpr std::string_view kRecordsBegin = "limitgauge reach records 1\n";

}  // namespace

std::size_t ReachRecords::Hash::operator()(const Key& key) const {
  std::uint64_t hash =
      (std::uint64_t{key.cutter} << 40) ^ (std::uint64_t{key.depth} << 32) ^ key.whole;
  for (const double value : {key.u, key.v, key.size_u, key.size_v})
    hash = (hash ^ std::bit_cast<std::uint64_t>(value)) * 0x9E3779B97F4A7C15U, hash ^= hash >> 29;
  return hash;
}

void ReachRecords::add(std::uint32_t cutter, std::uint32_t depth, const CellPart& cell,
                       const ReachDecision& decision) {
  known_[{cutter, depth, cell.whole, cell.u, cell.v, cell.size_u, cell.size_v}] = decision;
}

void ReachRecords::add(const ReachRecords& others) {
  known_.insert(others.known_.begin(), others.known_.end());
}

const ReachDecision* ReachRecords::find(std::uint32_t cutter, std::uint32_t depth,
                                        const CellPart& cell) const {
  const auto found =
      known_.find({cutter, depth, cell.whole, cell.u, cell.v, cell.size_u, cell.size_v});
  return found == known_.end() ? nullptr : &found->second;
}

std::string ReachRecords::to_bytes() const {
  model::Packer out;
  out.mark(kRecordsBegin);
  out.number(std::uint64_t{known_.size()});
  for (const auto& [key, decision] : known_) {
    out.number(key.cutter);
    out.number(key.depth);
    pack(out, CellPart{key.whole, key.u, key.v, key.size_u, key.size_v});
    pack(out, decision.reach);
    out.number(static_cast<std::uint8_t>(decision.halve + 2 * decision.in_u));
    out.number(decision.area_mm2);
  }
  return out.take();
}

std::optional<ReachRecords> ReachRecords::of_bytes(std::string_view bytes) {
  model::Unpacker in(bytes);
  in.mark(kRecordsBegin);
  ReachRecords records;
  for (std::size_t left = in.count(kCellBytes); left > 0 && in.good(); --left) {
    const auto cutter = in.number<std::uint32_t>(), depth = in.number<std::uint32_t>();
    const CellPart cell = unpack_cell(in);
    ReachDecision decision;
    decision.reach = unpack_reach(in);
    const auto bits = in.number<std::uint8_t>();
    decision.halve = (bits & 1) != 0, decision.in_u = (bits & 2) != 0;
    decision.area_mm2 = in.number<double>();
    records.add(cutter, depth, cell, decision);
  }
  if (!in.done()) return std::nullopt;
  return records;
}

}  // namespace limitgauge::verifier
