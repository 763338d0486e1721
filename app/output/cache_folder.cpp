#include "app/output/cache_folder.h"

#include <unistd.h>

#include <cstdlib>
#include <system_error>

#include "model/base/absolute_path.h"
#include "model/base/error.h"

namespace limitgauge::app {
namespace fs = std::filesystem;
namespace {

constexpr const char* kExpected = "a folder that can be written, with --cache";

fs::path stated_by(const char* variable) {
  const char* value = std::getenv(variable);
  // The XDG specification: what is not absolute counts as not set.
  return value != nullptr && value[0] == '/' ? fs::path(value) : fs::path();
}

fs::path users_own() {
  if (const fs::path cache = stated_by("XDG_CACHE_HOME"); !cache.empty())
    return cache / "limitgauge";
  if (const fs::path home = stated_by("HOME"); !home.empty()) return home / ".cache" / "limitgauge";
  throw model::InputError({"--cache", 0, 0},
                          "neither XDG_CACHE_HOME nor HOME says where results can be kept",
                          kExpected);
}

}  // namespace

fs::path cache_folder(const fs::path& stated) {
  const fs::path folder =
      model::absolute_path(stated.empty() ? users_own() : stated).lexically_normal();
  std::error_code error;
  fs::create_directories(folder, error);
  if (!error && ::access(folder.c_str(), W_OK | X_OK) != 0)
    error = std::error_code(errno, std::generic_category());
  if (!error) return folder;
  throw model::InputError({folder.string(), 0, 0},
                          "results cannot be kept here: " + error.message(), kExpected);
}

}  // namespace limitgauge::app
