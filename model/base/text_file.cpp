#include "model/base/text_file.h"

#include <array>
#include <fstream>
#include <system_error>

#include "model/base/error.h"

namespace limitgauge::model {
namespace {

void require_file(const std::filesystem::path& path) {
  std::error_code failure;
  const std::filesystem::file_status status = std::filesystem::status(path, failure);
  const SourcePlace place{path.string()};
  if (status.type() == std::filesystem::file_type::not_found)
    throw InputError(place, "there is no such file");
  if (failure) throw InputError(place, "the file cannot be reached: " + failure.message());
  if (std::filesystem::is_directory(status))
    throw InputError(place, "this is a directory", "a file");
}

}  // namespace

bool is_file(const std::filesystem::path& path) {
  std::error_code failure;
  return std::filesystem::is_regular_file(path, failure);
}

std::string read_text_file(const std::filesystem::path& path) {
  require_file(path);
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
