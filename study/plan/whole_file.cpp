#include "study/plan/whole_file.h"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <random>
#include <system_error>

#include "model/base/error.h"

namespace limitgauge::study {
namespace fs = std::filesystem;
namespace {

constexpr std::string_view kPart = ".part-";

[[noreturn]] void refuse(const fs::path& file, const std::string& why) {
  throw model::ResourceError(file.string() + ": error: cannot write the file: " + why);
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

bool is_part_file(std::string_view name) {
  return name.substr(0, kPart.size()) == kPart;
}

void write_whole(const fs::path& file, std::string_view bytes) {
  std::error_code error;
  fs::create_directories(file.parent_path(), error);
  if (error) refuse(file, error.message());
  const fs::path part = part_beside(file);
  const int wrong = error_of_file(part, bytes);
  if (wrong == 0) fs::rename(part, file, error);
  if (wrong == 0 && !error) return;
  std::error_code ignored;
  fs::remove(part, ignored);
  refuse(file, wrong != 0 ? std::strerror(wrong) : error.message());
}

}  // namespace limitgauge::study
