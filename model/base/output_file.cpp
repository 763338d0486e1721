#include "model/base/output_file.h"

#include <fcntl.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstdint>
#include <cstring>
#include <fstream>
#include <random>
#include <span>
#include <system_error>

#include "model/base/absolute_path.h"
#include "model/base/error.h"
#include "model/text/hexadecimal.h"

namespace limitgauge::model {
namespace fs = std::filesystem;
namespace {

constexpr std::string_view kPart = ".part-";

[[noreturn]] void refuse(const fs::path& file, const std::string& why) {
  throw ResourceError(file.string() + ": error: cannot write the file" +
                      (why.empty() ? "" : ": " + why));
}

/// `what` is written under another name than `file`, which errors are to name.
void write_as(const fs::path& what, const fs::path& file,
              const std::function<void(std::ostream&)>& write) {
  errno = 0;
  std::ofstream out(what, std::ios::binary);
  if (out) write(out);
  // Closing can fail too: a server is asked for its room only then.
  out.close();
  const int reason = errno;
  if (!out) refuse(file, reason == 0 ? "" : std::strerror(reason));
}

/// 0 where all is well. Some file systems have nothing to sync, of folders above all: no fault of
/// what was written.
int error_of_syncing(const fs::path& file, int (*sync)(int) = &::fsync) {
  const int descriptor = ::open(file.c_str(), O_RDONLY | O_CLOEXEC);
  if (descriptor < 0) return errno;
  const int wrong = sync(descriptor) == 0 ? 0 : errno;
  ::close(descriptor);
  return wrong == EINVAL || wrong == EROFS || wrong == ENOTSUP ? 0 : wrong;
}

void require_synced(const fs::path& file, int wrong) {
  if (wrong == 0) return;
  throw ResourceError(file.string() +
                      ": error: the disk does not take what was written: " + std::strerror(wrong));
}

/// A file beside another one, under a name that no other writer has, which takes that one's name in
/// the end or is removed.
class PartFile {
 public:
  explicit PartFile(const fs::path& file)
      : file_(file), part_(file.parent_path() / (std::string(kPart) + random_digits())) {
    const int descriptor = ::open(part_.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
    if (descriptor < 0) refuse(file, std::strerror(errno));
    ::close(descriptor);
  }
  ~PartFile() {
    std::error_code ignored;
    if (!renamed_) fs::remove(part_, ignored);
  }
  PartFile(const PartFile&) = delete;
  PartFile& operator=(const PartFile&) = delete;

  const fs::path& path() const { return part_; }
  void take_name() {
    if (const int wrong = error_of_syncing(part_); wrong != 0) refuse(file_, std::strerror(wrong));
    std::error_code error;
    fs::rename(part_, file_, error);
    if (error) refuse(file_, error.message());
    renamed_ = true;
    // The name is there for everybody; that it outlasts a power cut as well is all that is left.
    error_of_syncing(file_.parent_path());
  }

 private:
  const fs::path file_, part_;
  bool renamed_ = false;
};

bool is_no_file(const fs::path& path) {
  std::error_code missing;
  const fs::file_status there = fs::status(path, missing);
  return fs::exists(there) && !fs::is_regular_file(there);
}

}  // namespace

void write_file(const fs::path& file, const std::function<void(std::ostream&)>& write) {
  write_as(file, file, write);
}

void write_file(const fs::path& file, std::string_view bytes) {
  write_file(file, [&](std::ostream& out) { out << bytes; });
}

void make_folder(const fs::path& folder) {
  std::error_code error;
  fs::create_directories(folder, error);
  if (!error) return;
  throw ResourceError(folder.string() + ": error: cannot make the folder: " + error.message());
}

void write_whole_file(const fs::path& stated, const std::function<void(std::ostream&)>& write) {
  if (is_no_file(stated)) return write_file(stated, write);
  const fs::path file = behind_links(absolute_path(stated));
  make_folder(file.parent_path());
  PartFile part(file);
  write_as(part.path(), file, write);
  part.take_name();
}

void write_whole_file(const fs::path& file, std::string_view bytes) {
  write_whole_file(file, [&](std::ostream& out) { out << bytes; });
}

bool is_part_file(std::string_view name) {
  return name.starts_with(kPart);
}

void sync_file(const fs::path& file) {
  require_synced(file, error_of_syncing(file));
}

void sync_file_system(const fs::path& folder) {
  require_synced(folder, error_of_syncing(folder, &::syncfs));
}

std::string random_digits() {
  constexpr std::size_t kWords = 4;
  std::random_device chance;
  std::array<std::uint32_t, kWords> words{};
  for (std::uint32_t& word : words) word = chance();
  return hexadecimal(std::span(reinterpret_cast<const unsigned char*>(words.data()), sizeof words));
}

fs::path behind_links(const fs::path& path) {
  // As many as the kernel follows.
  constexpr int kMostLinks = 40;
  std::error_code error;
  fs::path at = path;
  for (int links = 0; fs::is_symlink(fs::symlink_status(at, error)); ++links) {
    if (links == kMostLinks)
      throw InputError({path.string(), 0, 0}, "its symbolic links lead round in a circle",
                       "a name that leads somewhere");
    at = at.parent_path() / fs::read_symlink(at, error);
  }
  return at;
}

}  // namespace limitgauge::model
