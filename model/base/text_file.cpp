#include "model/base/text_file.h"

#include <fcntl.h>
#include <poll.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstring>
#include <fstream>
#include <system_error>

#include "model/base/error.h"

namespace limitgauge::model {
namespace {

using std::filesystem::file_type;

/// As long a pipe may wait for whoever is to write into it.
constexpr int kWaitForWriter_ms = 500;

/// Throws InputError where there is nothing.
file_type type_of(const std::filesystem::path& path) {
  std::error_code failure;
  const std::filesystem::file_status status = std::filesystem::status(path, failure);
  if (status.type() == file_type::not_found)
    throw InputError({path.string()}, "there is no such file");
  if (failure)
    throw InputError({path.string()}, "the file cannot be reached: " + failure.message());
  return status.type();
}

[[noreturn]] void refuse_kind(const std::filesystem::path& path, file_type type) {
  const char* const wrong = type == file_type::directory ? "this is a directory"
                            : type == file_type::fifo    ? "this is a pipe"
                            : type == file_type::socket  ? "this is a socket"
                                                         : "this is a device";
  throw InputError({path.string()}, wrong, "a file");
}

/// An open file, closed at its end.
class Descriptor {
 public:
  explicit Descriptor(int number) : number_(number) {}
  ~Descriptor() { ::close(number_); }
  Descriptor(const Descriptor&) = delete;
  Descriptor& operator=(const Descriptor&) = delete;
  int number() const { return number_; }

 private:
  int number_;
};

/// Opening it the plain way would wait for a writer, without end where there is none.
int open_at_once(const std::filesystem::path& pipe) {
  const int opened = ::open(pipe.c_str(), O_RDONLY | O_NONBLOCK | O_CLOEXEC);
  if (opened < 0)
    throw InputError({pipe.string()},
                     std::string("the file cannot be opened for reading: ") + std::strerror(errno));
  return opened;
}

std::string read_pipe(const std::filesystem::path& pipe) {
  const Descriptor from(open_at_once(pipe));
  std::array<char, 1 << 16> block{};
  ssize_t count = ::read(from.number(), block.data(), block.size());
  pollfd waiting{from.number(), POLLIN, 0};
  if (count == 0 && ::poll(&waiting, 1, kWaitForWriter_ms) == 0)
    throw InputError({pipe.string()}, "nobody writes into this pipe", "a file, or a pipe in use");
  // A writer may take its time.
  ::fcntl(from.number(), F_SETFL, 0);
  std::string text;
  do {
    if (count > 0) text.append(block.data(), static_cast<std::size_t>(count));
    count = ::read(from.number(), block.data(), block.size());
  } while (count > 0);
  if (count < 0) throw InputError({pipe.string()}, "the file cannot be read to its end");
  return text;
}

}  // namespace

bool is_file(const std::filesystem::path& path) {
  std::error_code failure;
  return std::filesystem::is_regular_file(path, failure);
}

void require_file(const std::filesystem::path& path) {
  if (const file_type type = type_of(path); type != file_type::regular) refuse_kind(path, type);
}

std::string read_text_file(const std::filesystem::path& path) {
  const file_type type = type_of(path);
  if (type == file_type::fifo) return read_pipe(path);
  if (type != file_type::regular) refuse_kind(path, type);
  std::ifstream in(path, std::ios::binary);
  if (!in) throw InputError({path.string()}, "the file cannot be opened for reading");
  std::error_code failure;
  const std::uintmax_t size = std::filesystem::file_size(path, failure);
  if (failure) return read_text(in, path.string());
  std::string text(static_cast<std::size_t>(size), '\0');
  in.read(text.data(), static_cast<std::streamsize>(size));
  text.resize(static_cast<std::size_t>(in.gcount()));
  if (in.bad()) throw InputError({path.string()}, "the file cannot be read to its end");
  return text;
}

std::string read_text(std::istream& in, const std::string& name) {
  std::string text;
  std::array<char, 1 << 16> block{};
  while (in) {
    in.read(block.data(), static_cast<std::streamsize>(block.size()));
    text.append(block.data(), static_cast<std::size_t>(in.gcount()));
  }
  if (in.bad()) throw InputError({name}, "the text cannot be read to its end");
  return text;
}

}  // namespace limitgauge::model
