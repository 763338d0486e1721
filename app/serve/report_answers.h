#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "app/output/folder_files.h"
#include "app/serve/byte_ranges.h"
#include "app/serve/http_answer.h"
#include "app/serve/http_request.h"

namespace limitgauge::app {

/// What a folder's server answers: files to whoever calls it by its own name, and nothing else.
class ReportAnswers {
 public:
  /// Throws InputError for a folder that cannot be opened.
  explicit ReportAnswers(const std::filesystem::path& folder);

  /// `authorities`: what a request may call this server, 127.0.0.1:PORT for one.
  void answer_to(std::vector<std::string> authorities) { authorities_ = std::move(authorities); }
  /// Whatever is asked for has an answer, which says why where it is no file.
  HttpAnswer answer(const HttpRequest& request) const;

 private:
  HttpAnswer answer_admitted(const HttpRequest& request) const;
  HttpAnswer answer_file(const HttpRequest& request) const;
  HttpAnswer stretches(const std::shared_ptr<const OpenFile>& file, const std::string& type,
                       const std::vector<ByteRange>& ranges) const;

  FolderFiles files_;
  std::vector<std::string> authorities_;
  std::string boundary_;  ///< between ranges of one answer: drawn by lot, in no file
};

/// An answer without a file: why not.
HttpAnswer refusal(int status, const std::string& why);

}  // namespace limitgauge::app
