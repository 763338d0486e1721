#include "reports/vtk/vtp.h"

#include <algorithm>
#include <limits>
#include <numeric>

#include "model/base/error.h"
#include "model/base/memory.h"
#include "reports/run/report.h"
#include "reports/vtk/vtk_support.h"
#include "reports/vtk/vtp_file.h"

namespace limitgauge::reports {
namespace {

/// VTK reads 32-bit connectivity as it is; half the size of its own 64-bit ids.
void require_32_bit(std::size_t corners, const std::filesystem::path& file) {
  if (corners > std::size_t(std::numeric_limits<std::int32_t>::max()))
    throw model::ResourceError(file.string() + ": too many corners for a .vtp file");
}

template <typename Cells>
std::vector<std::int32_t> corners_of(const Cells& cells) {
  std::vector<std::int32_t> corners;
  if (!cells.empty()) model::reserve_large(corners, cells.size() * cells.front().size());
  for (const auto& cell : cells)
    for (const std::uint32_t corner : cell) corners.push_back(static_cast<std::int32_t>(corner));
  return corners;
}

/// One value of each item of `items`, as `T`.
template <typename T, typename Items, typename Pick>
std::vector<T> column(const Items& items, Pick pick) {
  std::vector<T> out;
  out.reserve(items.size());
  for (const auto& item : items) out.push_back(static_cast<T>(pick(item)));
  return out;
}

template <typename T>
std::span<const T> view(const std::vector<T>& values) {
  return values;
}

template <typename T>
void push(std::vector<T>& xyz, const model::Vec3& p) {
  for (int axis = 0; axis < 3; ++axis) xyz.push_back(static_cast<T>(p[axis]));
}

/// Of each item of `items`, as x, y, z.
template <typename T, typename Items, typename Pick>
std::vector<T> places(const Items& items, Pick pick) {
  std::vector<T> xyz;
  model::reserve_large(xyz, 3 * items.size());
  for (const auto& item : items) push(xyz, pick(item));
  return xyz;
}

std::vector<double> tips_of(const model::Toolpath& path) {
  std::vector<double> xyz;
  xyz.reserve(3 * (path.moves.size() + 1));
  push(xyz, path.start);
  for (const model::Move& move : path.moves) push(xyz, move.to);
  return xyz;
}

std::vector<std::int32_t> numbers_up_to(std::size_t n) {
  std::vector<std::int32_t> numbers(n);
  std::iota(numbers.begin(), numbers.end(), 0);
  return numbers;
}

/// The corners of n lines, each from one point to the next.
std::vector<std::int32_t> lines_between(std::size_t n) {
  std::vector<std::int32_t> corners;
  corners.reserve(2 * n);
  for (std::int32_t i = 0; i < static_cast<std::int32_t>(n); ++i)
    corners.push_back(i), corners.push_back(i + 1);
  return corners;
}

/// Single precision: these are figures to colour a path by. Whether they are there, one a move.
bool add_removal(VtpFile& vtp, std::span<const simulator::MoveRemoval> removal, std::size_t moves) {
  using simulator::MoveRemoval;
  if (removal.empty() || removal.size() != moves) return false;
  const auto add = [&](const char* name, auto pick) {
    vtp.add_cell_data(name, view(column<float>(removal, pick)));
  };
  add("removed_volume_mm3", [](const MoveRemoval& r) { return r.volume_mm3; });
  add("removal_rate_mm3_min", [](const MoveRemoval& r) { return r.rate_mm3_min; });
  add("axial_engagement_mm", [](const MoveRemoval& r) { return r.axial_mm; });
  add("radial_engagement_mm", [](const MoveRemoval& r) { return r.radial_mm; });
  return true;
}

/// In double precision: probe reads them back.
void add_axes(VtpFile& vtp, const model::ToolAxes& axes) {
  for (int k = 0; k < 3; ++k) {
    std::vector<double> part = {axes.start[k]};
    for (const model::Vec3& axis : axes.to) part.push_back(axis[k]);
    vtp.add_point_data(kAxisColumns[k], view(part));
  }
}

}  // namespace

void write_toolpath_vtp(const model::Toolpath& path, const std::filesystem::path& file,
                        std::span<const simulator::MoveRemoval> removal,
                        std::span<const Fact> facts, const model::ToolAxes* axes) {
  const std::size_t n = path.moves.size();
  require_32_bit(2 * n, file);
  using model::Move;
  // Each column is let go of as soon as VTK has its copy: a path has millions of moves.
  VtpFile vtp;
  vtp.set_points(view(tips_of(path)));
  vtp.set_lines(lines_between(n), 2);
  vtp.add_cell_data("line",
                    view(column<std::uint32_t>(path.moves, [](const Move& m) { return m.line; })));
  vtp.add_cell_data("feed_mm_min",
                    view(column<float>(path.moves, [](const Move& m) { return m.feed_mm_min; })));
  vtp.add_cell_data("kind",
                    view(column<std::uint8_t>(path.moves, [](const Move& m) { return m.kind; })));
  vtp.add_cell_data("move", view(numbers_up_to(n)));
  if (axes) add_axes(vtp, *axes);
  const bool has_removal = add_removal(vtp, removal, n);
  vtp.colour_cells_by(has_removal ? "removal_rate_mm3_min" : "feed_mm_min");
  vtp.set_facts(facts);
  vtp.write(file);
}

void write_deviation_vtp(const verifier::DeviationField& field, const std::filesystem::path& file,
                         std::span<const Fact> facts) {
  using Sample = verifier::DeviationField::Sample;
  const auto& samples = field.samples;
  require_32_bit(4 * field.quads.size(), file);
  const auto add = [&]<typename T>(VtpFile& vtp, const char* name, T, auto pick) {
    vtp.add_point_data(name, view(column<T>(samples, pick)));
  };
  VtpFile vtp;
  vtp.set_points(view(places<double>(samples, [](const Sample& s) { return s.place.point; })));
  vtp.set_polygons(corners_of(field.quads), 4);
  add(vtp, "deviation_mm", 0.f, [](const Sample& s) { return s.deviation_mm; });
  add(vtp, "uncut_mm", 0.f, [](const Sample& s) { return std::max(s.deviation_mm, 0.f); });
  add(vtp, "gouge_mm", 0.f, [](const Sample& s) { return std::max(-s.deviation_mm, 0.f); });
  add(vtp, "reachable", std::uint8_t{}, [](const Sample& s) { return s.reachable; });
  add(vtp, "patch", std::int32_t{}, [](const Sample& s) { return s.place.patch; });
  add(vtp, "u", 0., [](const Sample& s) { return s.place.u; });
  add(vtp, "v", 0., [](const Sample& s) { return s.place.v; });
  add(vtp, "line", std::uint32_t{}, [](const Sample& s) { return s.line; });
  vtp.set_normals("normal", view(places<float>(samples, [](const Sample& s) { return s.normal; })));
  vtp.colour_points_by("deviation_mm");
  vtp.set_facts(facts);
  vtp.write(file);
}

void write_stock_vtp(const simulator::StockMesh& mesh, const std::filesystem::path& file,
                     std::span<const Fact> facts) {
  require_32_bit(3 * mesh.triangles.size(), file);
  VtpFile vtp;
  vtp.set_points(view(places<float>(mesh.vertices, [](const model::Vec3& p) { return p; })));
  vtp.set_polygons(corners_of(mesh.triangles), 3);
  vtp.set_facts(facts);
  vtp.write(file);
}

}  // namespace limitgauge::reports
