#include "model/base/output_file.h"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <fstream>
#include <random>
#include <string>
#include <system_error>

#include "model/base/error.h"

namespace limitgauge::model {
namespace fs = std::filesystem;
namespace {

constexpr std::string_view kPart = ".part-";

[[noreturn]] void refuse(const fs::path& file, const std::string& why) {
  throw ResourceError(file.string() + ": error: cannot write the file" +
                      (why.empty() ? "" : ": " + why));
}

/// Processes of several machines write into the same folder: their numbers alone may be the same.
fs::path part_beside(const fs::path& file) {
  std::random_device chance;
  return file.parent_path() / (std::string(kPart) + std::to_string(getpid()) + "-" +
                               std::to_string(chance()) + "-" + std::to_string(chance()));
}

int error_of_writing(int descriptor, std::string_view bytes) {
  while (!bytes.empty()) {
    const ssize_t written = ::write(descriptor, bytes.data(), bytes.size());
    if (written < 0 && errno == EINTR) continue;
    if (written < 0) return errno;
    bytes.remove_prefix(static_cast<std::size_t>(written));
  }
  return 0;
}

/// 0 where all is well. Closing can fail too: a server is asked for its room only then.
int error_of_file(const fs::path& part, std::string_view bytes) {
  const int descriptor = ::open(part.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
  if (descriptor < 0) return errno;
  const int wrong = error_of_writing(descriptor, bytes);
  const int closing = ::close(descriptor) == 0 || errno == EINTR ? 0 : errno;
  return wrong != 0 ? wrong : closing;
}

}  // namespace

void write_file(const fs::path& file, const std::function<void(std::ostream&)>& write) {
  errno = 0;
  std::ofstream out(file, std::ios::binary);
  if (out) write(out);
  out.close();
  const int reason = errno;
  if (!out) refuse(file, reason == 0 ? "" : std::strerror(reason));
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

void write_whole_file(const fs::path& file, std::string_view bytes) {
  make_folder(file.parent_path());
  const fs::path part = part_beside(file);
  const int wrong = error_of_file(part, bytes);
  std::error_code error;
  if (wrong == 0) fs::rename(part, file, error);
  if (wrong == 0 && !error) return;
  std::error_code ignored;
  fs::remove(part, ignored);
  refuse(file, wrong != 0 ? std::strerror(wrong) : error.message());
}

bool is_part_file(std::string_view name) {
  return name.starts_with(kPart);
}

}  // namespace limitgauge::model
