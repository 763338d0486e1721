#include "study/store/store.h"

#include <algorithm>
#include <chrono>
#include <cstdint>
#include <fstream>
#include <iterator>
#include <sstream>
#include <stdexcept>
#include <vector>

#include <zlib.h>

#include "model/base/error.h"
#include "model/base/output_file.h"

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

namespace fs = std::filesystem;
namespace {

constexpr std::size_t kKeyDigits = 64, kFolderDigits = 2;
/// A part file that is older belongs to a writer that was killed.
constexpr std::chrono::hours kOldestWriter{1};

bool hexadecimal(const std::string& text, std::size_t digits) {
  return text.size() == digits && text.find_first_not_of("0123456789abcdef") == std::string::npos;
}

bool is_word(const std::string& text) {
  return !text.empty() &&
         text.find_first_not_of("abcdefghijklmnopqrstuvwxyz0123456789_") == std::string::npos;
}

fs::path place(const fs::path& folder, const std::string& kind, const std::string& key) {
  if (!is_word(kind)) throw std::invalid_argument("no kind of entry: " + kind);
  if (!hexadecimal(key, kKeyDigits)) throw std::invalid_argument("no key of an entry: " + key);
  return folder / kind / key.substr(0, kFolderDigits) / key.substr(kFolderDigits, kFolderDigits) /
         key.substr(2 * kFolderDigits);
}

/// Calls `visit` with what is in `folder`, as far as it can be read: others delete there too.
template <class Visit>
void each_in(const fs::path& folder, const Visit& visit) {
  std::error_code error;
  for (fs::directory_iterator at(folder, error), end; !error && at != end; at.increment(error))
    visit(*at);
}

template <class Visit>
void each_hexadecimal_folder_in(const fs::path& folder, const Visit& visit) {
  each_in(folder, [&](const fs::directory_entry& entry) {
    if (hexadecimal(entry.path().filename().string(), kFolderDigits)) visit(entry.path());
  });
}

struct Entry {
  fs::path file;
  fs::file_time_type used;
  std::uint64_t bytes;
};

void remove_if_left_behind(const fs::path& file) {
  std::error_code error;
  const fs::file_time_type written = fs::last_write_time(file, error);
  if (!error && written < fs::file_time_type::clock::now() - kOldestWriter) fs::remove(file, error);
}

/// Only what has the name of an entry is one: a folder of the user's own loses nothing.
std::vector<Entry> entries_in(const fs::path& folder) {
  std::vector<Entry> found;
  const auto take = [&found](const fs::directory_entry& entry) {
    const std::string name = entry.path().filename().string();
    if (model::is_part_file(name)) return remove_if_left_behind(entry.path());
    if (!hexadecimal(name, kKeyDigits - 2 * kFolderDigits)) return;
    std::error_code error;
    const fs::file_time_type used = entry.last_write_time(error);
    if (error) return;
    const std::uint64_t bytes = entry.file_size(error);
    if (!error) found.push_back({entry.path(), used, bytes});
  };
  each_in(folder, [&](const fs::directory_entry& kind) {
    if (!is_word(kind.path().filename().string())) return;
    each_hexadecimal_folder_in(kind.path(), [&](const fs::path& first) {
      each_hexadecimal_folder_in(first, [&](const fs::path& second) { each_in(second, take); });
    });
  });
  return found;
}

}  // namespace

Store::Store(fs::path folder, std::uint64_t limit_bytes)
    : folder_(std::move(folder)), limit_bytes_(limit_bytes) {}

std::optional<std::string> Store::get(const std::string& kind, const std::string& key) const {
  const fs::path file = place(folder_, kind, key);
  std::ifstream in(file, std::ios::binary);
  if (!in) return std::nullopt;
  const std::string packed{std::istreambuf_iterator<char>(in), {}};
  std::optional<std::string> content = unpack_entry(packed, key);
  // A folder that can only be read is one to read from: its entries just do not grow younger.
  std::error_code ignored;
  if (content) fs::last_write_time(file, fs::file_time_type::clock::now(), ignored);
  return content;
}

bool Store::has(const std::string& kind, const std::string& key) const {
  std::error_code ignored;
  return fs::is_regular_file(place(folder_, kind, key), ignored);
}

void Store::put(const std::string& kind, const std::string& key, const std::string& content) const {
  model::write_whole_file(place(folder_, kind, key), pack_entry(content, key));
}

Store::Trimmed Store::trim(fs::file_time_type keep_since) const {
  std::vector<Entry> entries = entries_in(folder_);
  std::sort(entries.begin(), entries.end(),
            [](const Entry& a, const Entry& b) { return a.used < b.used; });
  Trimmed done;
  for (const Entry& entry : entries) done.kept_bytes += entry.bytes;
  done.kept_entries = entries.size();
  for (const Entry& entry : entries) {
    if (done.kept_bytes <= limit_bytes_ || entry.used >= keep_since) break;
    std::error_code error;
    fs::remove(entry.file, error);
    if (error) continue;
    done.kept_bytes -= entry.bytes;
    --done.kept_entries;
    done.bytes += entry.bytes;
    ++done.entries;
  }
  return done;
}

}  // namespace limitgauge::study
