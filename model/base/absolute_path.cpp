#include "model/base/absolute_path.h"

#include <algorithm>
#include <cctype>
#include <system_error>

#include "model/base/error.h"

namespace limitgauge::model {

std::filesystem::path absolute_path(const std::filesystem::path& path) {
  std::error_code failure;
  std::filesystem::path absolute = std::filesystem::absolute(path, failure);
  if (!failure) return absolute;
  throw InputError({path.string()}, "the working folder cannot be told: " + failure.message(),
                   "a working folder that exists, or an absolute path");
}

std::string lower_extension(const std::filesystem::path& path) {
  std::string extension = path.extension().string();
  std::transform(extension.begin(), extension.end(), extension.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return extension;
}

}  // namespace limitgauge::model
