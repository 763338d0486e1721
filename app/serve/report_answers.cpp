#include "app/serve/report_answers.h"

#include <algorithm>
#include <random>
#include <sstream>
#include <utility>

#include "model/base/error.h"

namespace limitgauge::app {
namespace {

/// Nothing is kept, guessed, framed or told to others. What is no page can do nothing at all.
void secure(HttpAnswer& answer, bool is_page) {
  for (const auto& [name, value] : std::initializer_list<std::pair<const char*, const char*>>{
           {"Cache-Control", "no-store"},
           {"X-Content-Type-Options", "nosniff"},
           {"Referrer-Policy", "no-referrer"},
           {"X-Frame-Options", "DENY"},
           {"Cross-Origin-Resource-Policy", "same-origin"},
           {"Cross-Origin-Opener-Policy", "same-origin"},
           // The page brings its own policy for scripts and styles; both hold.
           {"Content-Security-Policy",
            is_page ? "frame-ancestors 'none'; base-uri 'none'; form-action 'none'"
                    : "default-src 'none'; frame-ancestors 'none'; sandbox"}})
    answer.fields.emplace_back(name, value);
}

std::string random_boundary() {
  std::random_device chance;
  std::ostringstream text;
  text << "limitgauge-" << std::hex << chance() << chance() << chance() << chance();
  return text.str();
}

std::string content_range(const ByteRange& range, std::uint64_t bytes) {
  return "bytes " + std::to_string(range.first) + "-" + std::to_string(range.last) + "/" +
         std::to_string(bytes);
}

AnswerPart stretch(const std::shared_ptr<const OpenFile>& file, const ByteRange& range) {
  return {{}, file, range.first, range.bytes()};
}

/// What is asked of a file of `bytes` bytes; nothing where that is all of it.
std::optional<std::vector<ByteRange>> asked_ranges(const HttpRequest& request,
                                                   std::uint64_t bytes) {
  // Ranges are defined for GET alone. If-Range holds for a version that the client knows by its
  // mark: there are none here, so it never does.
  const std::optional<std::string> field = request.only("range");
  const bool conditional = std::any_of(request.fields.begin(), request.fields.end(),
                                       [](const auto& one) { return one.first == "if-range"; });
  if (request.method != "GET" || !field || conditional) return std::nullopt;
  return ranges_of(*field, bytes);
}

}  // namespace

HttpAnswer refusal(int status, const std::string& why) {
  HttpAnswer answer;
  answer.status = status;
  secure(answer, false);
  answer.fields.emplace_back("Content-Type", "text/plain; charset=utf-8");
  answer.body.push_back({why + "\n", nullptr, 0, 0});
  return answer;
}

ReportAnswers::ReportAnswers(const std::filesystem::path& folder)
    : files_(folder), boundary_(random_boundary()) {}

HttpAnswer ReportAnswers::answer(const HttpRequest& request) const {
  HttpAnswer answer = answer_admitted(request);
  answer.body_is_held_back = request.method == "HEAD";
  answer.ends_connection = !request.stays;
  return answer;
}

/// Says no before anything is looked up.
HttpAnswer ReportAnswers::answer_admitted(const HttpRequest& request) const {
  const std::optional<std::string> host = request.only("host");
  if (!host || std::find(authorities_.begin(), authorities_.end(), *host) == authorities_.end())
    return refusal(403, "This server answers to 127.0.0.1 only.");
  if (request.method != "GET" && request.method != "HEAD") {
    HttpAnswer answer = refusal(405, "This server only shows files.");
    answer.fields.emplace_back("Allow", "GET, HEAD");
    return answer;
  }
  if (request.has_content) return refusal(400, "This server takes no content.");
  try {
    return answer_file(request);
  } catch (const model::ResourceError&) {
    HttpAnswer answer = refusal(503, "This machine has no file descriptor left.");
    answer.fields.emplace_back("Retry-After", "1");
    return answer;
  }
}

HttpAnswer ReportAnswers::answer_file(const HttpRequest& request) const {
  const std::string asked = path_of(request.target);
  // Anything but a path from the root is none of this folder's names.
  const bool rooted = asked.starts_with('/');
  const std::string path = asked == "/" ? "report.html" : asked.substr(rooted ? 1 : 0);
  const std::shared_ptr<const OpenFile> file = rooted ? files_.open(path) : nullptr;
  if (!file) return refusal(404, "There is no such file in this report.");
  const std::uint64_t bytes = file->bytes();
  const auto ranges = asked_ranges(request, bytes);
  if (ranges && ranges->empty()) {
    HttpAnswer answer = refusal(416, "There are no such bytes in this file.");
    answer.fields.emplace_back("Content-Range", "bytes */" + std::to_string(bytes));
    return answer;
  }
  HttpAnswer answer;
  if (ranges) {
    answer = stretches(file, media_type(path), *ranges);
  } else {
    answer.fields.emplace_back("Content-Type", media_type(path));
    answer.body.push_back({{}, file, 0, bytes});
  }
  answer.fields.emplace_back("Accept-Ranges", "bytes");
  secure(answer, path.ends_with(".html"));
  return answer;
}

HttpAnswer ReportAnswers::stretches(const std::shared_ptr<const OpenFile>& file,
                                    const std::string& type,
                                    const std::vector<ByteRange>& ranges) const {
  HttpAnswer answer;
  answer.status = 206;
  if (ranges.size() == 1) {
    answer.fields.emplace_back("Content-Type", type);
    answer.fields.emplace_back("Content-Range", content_range(ranges.front(), file->bytes()));
    answer.body.push_back(stretch(file, ranges.front()));
    return answer;
  }
  answer.fields.emplace_back("Content-Type", "multipart/byteranges; boundary=" + boundary_);
  for (const ByteRange& range : ranges) {
    answer.body.push_back({"\r\n--" + boundary_ + "\r\nContent-Type: " + type +
                               "\r\nContent-Range: " + content_range(range, file->bytes()) +
                               "\r\n\r\n",
                           nullptr, 0, 0});
    answer.body.push_back(stretch(file, range));
  }
  answer.body.push_back({"\r\n--" + boundary_ + "--\r\n", nullptr, 0, 0});
  return answer;
}

}  // namespace limitgauge::app
