#pragma once

#include <cstdint>
#include <deque>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "app/output/folder_files.h"

namespace limitgauge::app {

/// A stretch of what is sent: text, or else bytes of a file.
struct AnswerPart {
  std::string text;
  std::shared_ptr<const OpenFile> file;
  std::uint64_t offset = 0, bytes = 0;  ///< of the file

  std::uint64_t size() const { return file ? bytes : text.size(); }
};

/// What a request is answered with.
struct HttpAnswer {
  int status = 200;
  std::vector<std::pair<std::string, std::string>> fields;
  std::vector<AnswerPart> body;
  bool body_is_held_back = false;  ///< only told of, as HEAD asks
  bool ends_connection = false;
};

/// An answer with its head, part by part, as it goes over the line. Its length stands in the head.
std::deque<AnswerPart> parts_of(HttpAnswer answer);

}  // namespace limitgauge::app
