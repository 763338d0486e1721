#include "verifier/reach/reach_entries.h"

#include "verifier/reach/packed_cell.h"

namespace limitgauge::verifier {
namespace {

constexpr std::string_view kEntriesBegin = "limitgauge reach map 1\n";

}  // namespace

std::string entries_to_bytes(const std::vector<ReachMap::Entry>& entries) {
  model::Packer out;
  out.mark(kEntriesBegin);
  out.number(std::uint64_t{entries.size()});
  for (const ReachMap::Entry& entry : entries) {
    pack(out, entry.cell);
    pack(out, entry.reach);
    out.number(entry.cutter);
    out.number(entry.area_mm2);
  }
  return out.take();
}

std::optional<std::vector<ReachMap::Entry>> entries_of_bytes(std::string_view bytes) {
  model::Unpacker in(bytes);
  in.mark(kEntriesBegin);
  std::vector<ReachMap::Entry> entries(in.count(kCellBytes));
  for (ReachMap::Entry& entry : entries) {
    entry.cell = unpack_cell(in);
    entry.reach = unpack_reach(in);
    entry.cutter = in.number<std::uint32_t>();
    entry.area_mm2 = in.number<double>();
  }
  if (!in.done()) return std::nullopt;
  return entries;
}

}  // namespace limitgauge::verifier
