#pragma once

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <stdexcept>
#include <string>
#include <vector>

#include "tests/support/folders.h"
#include "tests/support/messages.h"

namespace limitgauge::model::test {

/// The files of a folder of fixtures/ that end in `extension`, sorted by name.
inline std::vector<std::filesystem::path> fixture_files(const std::string& folder,
                                                        const std::string& extension) {
  std::vector<std::filesystem::path> files;
  const std::filesystem::path root = tests::fixtures() / folder;
  for (const auto& entry : std::filesystem::directory_iterator(root)) {
    if (entry.path().extension() == extension) files.push_back(entry.path());
  }
  std::sort(files.begin(), files.end());
  return files;
}

inline std::string text_of(const std::filesystem::path& path) {
  std::ifstream in(path, std::ios::binary);
  if (!in) throw std::runtime_error("cannot open " + path.string());
  return {std::istreambuf_iterator<char>(in), {}};
}

/// The file beside `path` that has another extension.
inline std::string text_beside(std::filesystem::path path, const std::string& extension) {
  return text_of(path.replace_extension(extension));
}

using tests::message_of;

}  // namespace limitgauge::model::test
