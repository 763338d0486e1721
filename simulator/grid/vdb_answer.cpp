#include "simulator/grid/vdb_answer.h"

#include <cmath>
#include <cstdint>
#include <cstring>
#include <optional>
#include <vector>

#include "model/base/error.h"
#include "model/mesh/mesh_defect.h"

namespace limitgauge::simulator {
namespace {

constexpr char kStock = 's', kRefusal = 'r', kShortage = 'm';

/// Behind the first character of a stock's answer; then come vertices and triangles.
struct Header {
  double voxel_mm = 0;
  std::uint64_t vertices = 0, triangles = 0;
  double blunt_mm = 0;
};

template <class T>
void add(std::string& bytes, const T* values, std::size_t count) {
  bytes.append(reinterpret_cast<const char*>(values), count * sizeof(T));
}

/// None where fewer than `count` are left.
template <class T>
std::optional<std::vector<T>> take(std::string_view& bytes, std::uint64_t count) {
  if (count > bytes.size() / sizeof(T)) return std::nullopt;
  std::vector<T> values(count);
  if (count > 0) std::memcpy(values.data(), bytes.data(), count * sizeof(T));
  bytes.remove_prefix(count * sizeof(T));
  return values;
}

std::optional<VdbStock> stock_of(std::string_view bytes) {
  const auto header = take<Header>(bytes, 1);
  if (!header) return std::nullopt;
  const auto [voxel_mm, vertices, triangles, blunt_mm] = header->front();
  if (!(voxel_mm > 0) || !std::isfinite(voxel_mm)) return std::nullopt;
  if (!(blunt_mm > 0) || !std::isfinite(blunt_mm)) return std::nullopt;
  auto points = take<model::Vec3>(bytes, vertices);
  if (!points) return std::nullopt;
  auto corners = take<std::array<std::uint32_t, 3>>(bytes, triangles);
  if (!corners || !bytes.empty()) return std::nullopt;
  return VdbStock{{std::move(*points), std::move(*corners)}, voxel_mm, blunt_mm};
}

/// Words may hold what stands in the file: no control characters reach the reader's terminal.
std::string printable(std::string_view words) {
  constexpr std::size_t kLongest = 400;  // the longest of ours have half of it
  std::string text;
  for (const char c : words.substr(0, kLongest)) text += c >= ' ' && c <= '~' ? c : '?';
  return words.size() > kLongest ? text + "..." : text;
}

}  // namespace

std::string vdb_answer(const VdbStock& stock) {
  const model::TriangleMesh& mesh = stock.mesh;
  const Header header{stock.voxel_mm, mesh.vertices.size(), mesh.triangles.size(), stock.blunt_mm};
  std::string bytes(1, kStock);
  bytes.reserve(1 + sizeof header + mesh.vertices.size() * sizeof mesh.vertices[0] +
                mesh.triangles.size() * sizeof mesh.triangles[0]);
  add(bytes, &header, 1);
  add(bytes, mesh.vertices.data(), mesh.vertices.size());
  add(bytes, mesh.triangles.data(), mesh.triangles.size());
  return bytes;
}

std::string vdb_refusal(std::string_view why) {
  return std::string(1, kRefusal).append(why);
}

std::string vdb_shortage(std::string_view why) {
  return std::string(1, kShortage).append(why);
}

VdbStock read_vdb_answer(std::string_view answer, const std::filesystem::path& path) {
  const char kind = answer.empty() ? '\0' : answer.front();
  const std::string_view rest = answer.substr(answer.empty() ? 0 : 1);
  if (kind == kRefusal) throw model::InputError({path.string()}, printable(rest));
  if (kind == kShortage) throw model::ResourceError(path.string() + ": error: " + printable(rest));
  auto stock = kind == kStock ? stock_of(rest) : std::nullopt;
  if (!stock)
    throw model::InputError({path.string()}, "OpenVDB makes no sense of the file: it is damaged",
                            "a stock.vdb of an earlier run");
  if (const auto defect = find_defect(stock->mesh))
    throw model::InputError({path.string()},
                            "the zero set bounds no solid (its band is torn): " + defect->wrong,
                            "a level set as simulations write it");
  return std::move(*stock);
}

}  // namespace limitgauge::simulator
