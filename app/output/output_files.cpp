#include "app/output/output_files.h"

#include <cerrno>
#include <cstring>
#include <fstream>
#include <system_error>

#include "model/base/error.h"

namespace limitgauge::app {

void write_file(const std::filesystem::path& file,
                const std::function<void(std::ostream&)>& write) {
  errno = 0;
  std::ofstream out(file, std::ios::binary);
  if (out) write(out);
  out.flush();
  if (out) return;
  const int reason = errno;
  throw model::ResourceError(file.string() + ": error: cannot write the file" +
                             (reason == 0 ? "" : std::string(": ") + std::strerror(reason)));
}

void make_folder(const std::filesystem::path& folder) {
  std::error_code error;
  std::filesystem::create_directories(folder, error);
  if (!error) return;
  throw model::ResourceError(folder.string() +
                             ": error: cannot make the folder: " + error.message());
}

}  // namespace limitgauge::app
