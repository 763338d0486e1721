#include "study/store/store_entry.h"

#include <zlib.h>

#include <cstdint>
#include <sstream>

#include "model/base/error.h"

namespace limitgauge::study {
namespace {

constexpr const char* kMark = "limitgauge-entry/1";
/// No stream of zlib grows more than 1032 times: a length beyond that is damage.
constexpr std::uint64_t kMostGrowth = 1032;
constexpr std::size_t kLongestHeader = 200;

std::uint32_t checksum(const std::string& bytes) {
  return static_cast<std::uint32_t>(
      crc32_z(0, reinterpret_cast<const Bytef*>(bytes.data()), bytes.size()));
}

std::string compressed(const std::string& content) {
  uLongf size = compressBound(content.size());
  std::string packed(size, '\0');
  const int code = compress2(reinterpret_cast<Bytef*>(packed.data()), &size,
                             reinterpret_cast<const Bytef*>(content.data()), content.size(), 1);
  if (code != Z_OK) throw model::ResourceError("out of memory for an entry of the cache");
  packed.resize(size);
  return packed;
}

}  // namespace

std::string pack_entry(const std::string& content, const std::string& key) {
  const std::string packed = compressed(content);
  std::ostringstream file;
  file << kMark << ' ' << key << ' ' << content.size() << ' ' << packed.size() << ' '
       << checksum(content) << '\n'
       << packed;
  return std::move(file).str();
}

std::optional<std::string> unpack_entry(const std::string& file, const std::string& key) {
  const std::size_t end = file.substr(0, kLongestHeader).find('\n');
  if (end == std::string::npos) return std::nullopt;
  std::istringstream header(file.substr(0, end));
  std::string mark, stated_key;
  std::uint64_t size = 0, packed_size = 0;
  std::uint32_t sum = 0;
  if (!(header >> mark >> stated_key >> size >> packed_size >> sum)) return std::nullopt;
  if (mark != kMark || stated_key != key || packed_size != file.size() - end - 1 ||
      size > kMostGrowth * packed_size)
    return std::nullopt;
  std::string content(size, '\0');
  uLongf written = content.size();
  const int code = uncompress(reinterpret_cast<Bytef*>(content.data()), &written,
                              reinterpret_cast<const Bytef*>(file.data()) + end + 1, packed_size);
  if (code != Z_OK || written != size || checksum(content) != sum) return std::nullopt;
  return content;
}

}  // namespace limitgauge::study
