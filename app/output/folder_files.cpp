#include "app/output/folder_files.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstring>
#include <utility>

#include "model/base/error.h"

namespace limitgauge::app {
namespace {

bool is_plain(const std::string& name) {
  return !name.empty() && name.front() != '.' &&
         std::none_of(name.begin(), name.end(),
                      [](unsigned char c) { return c < ' ' || c == '\\'; });
}

/// One step down from `folder`; -1 where there is none. Does not wait for the other end of a pipe.
int step(int folder, const std::string& name, int flags) {
  if (!is_plain(name)) return -1;
  return openat(folder, name.c_str(), O_RDONLY | O_NOFOLLOW | O_CLOEXEC | O_NONBLOCK | flags);
}

/// A file that is there must not be said to be missing.
void require_descriptors() {
  if (errno == EMFILE || errno == ENFILE || errno == ENOMEM)
    throw model::ResourceError(std::string("limitgauge: error: no file can be opened: ") +
                               std::strerror(errno));
}

}  // namespace

OpenFile::~OpenFile() {
  close(descriptor_);
}

std::string OpenFile::read(std::size_t offset, std::size_t length) const {
  std::string bytes(length, '\0');
  const ssize_t got = pread(descriptor_, bytes.data(), length, static_cast<off_t>(offset));
  bytes.resize(got > 0 ? static_cast<std::size_t>(got) : 0);
  return bytes;
}

FolderFiles::FolderFiles(const std::filesystem::path& folder)
    : descriptor_(::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC)) {
  if (descriptor_ < 0) {
    throw model::InputError({folder.string(), 0, 0}, "the folder cannot be opened",
                            "the output folder of a finished run");
  }
}

FolderFiles::~FolderFiles() {
  close(descriptor_);
}

std::shared_ptr<const OpenFile> FolderFiles::open(std::string_view path) const {
  errno = 0;
  int at = fcntl(descriptor_, F_DUPFD_CLOEXEC, 0);
  while (at >= 0) {
    const std::size_t slash = path.find('/');
    const bool last = slash == std::string_view::npos;
    const int next = step(at, std::string(path.substr(0, slash)), last ? 0 : O_DIRECTORY);
    const int reason = errno;
    close(std::exchange(at, next));
    errno = reason;
    if (last) break;
    path.remove_prefix(slash + 1);
  }
  struct stat about {};
  if (at < 0) {
    require_descriptors();
    return nullptr;
  }
  if (fstat(at, &about) == 0 && S_ISREG(about.st_mode))
    return std::make_shared<const OpenFile>(at, static_cast<std::size_t>(about.st_size));
  close(at);
  return nullptr;
}

std::string media_type(std::string_view path) {
  constexpr std::array<std::pair<std::string_view, const char*>, 12> kTypes = {{
      {".html", "text/html; charset=utf-8"},
      {".json", "application/json"},
      {".sarif", "application/sarif+json"},
      {".xml", "application/xml"},
      {".csv", "text/csv; charset=utf-8"},
      {".png", "image/png"},
      {".svg", "image/svg+xml"},
      {".txt", "text/plain; charset=utf-8"},
      {".ngc", "text/plain; charset=utf-8"},
      {".apt", "text/plain; charset=utf-8"},
      {".vtm", "application/xml"},
      {".vtp", "application/octet-stream"},
  }};
  for (const auto& [ending, type] : kTypes)
    if (path.ends_with(ending)) return type;
  return "application/octet-stream";
}

}  // namespace limitgauge::app
