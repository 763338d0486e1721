#include "app/inputs/input_cache.h"

#include <sys/stat.h>

#include <algorithm>

#include "model/base/error.h"

namespace limitgauge::app {
namespace {

constexpr std::size_t kMostKept = 4;

std::int64_t nanoseconds(const timespec& time) {
  return std::int64_t{1'000'000'000} * time.tv_sec + time.tv_nsec;
}

bool same(const MeshPlace& a, const MeshPlace& b) {
  return a.scale == b.scale && a.translate_mm == b.translate_mm;
}

bool same(const model::Placement& a, const model::Placement& b) {
  return a.scale == b.scale && a.rotate_z_deg == b.rotate_z_deg && a.translate_mm == b.translate_mm;
}

/// The one of `kept` that `is_it` says yes to, or what `make` makes; in front from now on.
template <class T, class IsIt, class Make>
const T& in_front(std::vector<T>& kept, const IsIt& is_it, const Make& make) {
  const auto found = std::find_if(kept.begin(), kept.end(), is_it);
  if (found != kept.end()) {
    std::rotate(kept.begin(), found, found + 1);
  } else {
    kept.insert(kept.begin(), make());
    if (kept.size() > kMostKept) kept.pop_back();
  }
  return kept.front();
}

}  // namespace

FileState file_state(const std::filesystem::path& file) {
  struct stat found {};
  if (::stat(file.c_str(), &found) != 0 || !S_ISREG(found.st_mode))
    throw model::InputError({file.string(), 0, 0}, "cannot be read", "a file");
  return {static_cast<std::uint64_t>(found.st_dev), static_cast<std::uint64_t>(found.st_ino),
          static_cast<std::uint64_t>(found.st_size), nanoseconds(found.st_ctim),
          nanoseconds(found.st_mtim)};
}

Checksum InputCache::checksum(const std::filesystem::path& file) {
  const FileState state = file_state(file);
  const auto known = sums_.find(file);
  if (known != sums_.end() && known->second.first == state) return known->second.second;
  return sums_.insert_or_assign(file, std::pair(state, file_checksum(file))).first->second.second;
}

template <class Read>
StockFile InputCache::stock(const std::filesystem::path& file, const std::string& as_stated,
                            const MeshPlace& place, const Read& read) {
  const FileState state = file_state(file);
  const auto is_it = [&](const CachedStock& known) {
    return known.file == file && known.as_stated == as_stated && known.state == state &&
           same(known.place, place);
  };
  return in_front(stocks_, is_it,
                  [&] {
                    return CachedStock{file, as_stated, place, state, read()};
                  })
      .stock;
}

StockReaders InputCache::stock_readers() {
  StockReaders readers;
  readers.mesh = [this](const std::filesystem::path& file, const std::string& as_stated,
                        const MeshPlace& place) {
    return stock(file, as_stated, place, [&] { return load_mesh_stock(file, as_stated, place); });
  };
  readers.vdb = [this](const std::filesystem::path& file, const std::string& as_stated) {
    // No mesh is scaled by nothing: what was read as a .vdb stands apart.
    return stock(file, as_stated, {0, {}}, [&] { return load_vdb_stock(file, as_stated); });
  };
  return readers;
}

std::optional<JobSurface> InputCache::surface(const Job& job) {
  if (!job.design) return std::nullopt;
  const JobDesign& design = *job.design;
  const FileState state = file_state(design.file);
  const auto is_it = [&](const CachedSurface& known) {
    return known.kind == design.kind && known.file == design.file && known.state == state &&
           same(known.placement, design.placement);
  };
  return in_front(surfaces_, is_it,
                  [&] {
                    return CachedSurface{design.kind, design.file, design.placement, state,
                                         load_surface(job)};
                  })
      .surface;
}

}  // namespace limitgauge::app
