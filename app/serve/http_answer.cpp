#include "app/serve/http_answer.h"

#include <array>
#include <numeric>
#include <string_view>

namespace limitgauge::app {
namespace {

std::string_view phrase_of(int status) {
  constexpr std::array<std::pair<int, std::string_view>, 11> kPhrases = {{
      {200, "OK"},
      {206, "Partial Content"},
      {400, "Bad Request"},
      {403, "Forbidden"},
      {404, "Not Found"},
      {405, "Method Not Allowed"},
      {408, "Request Timeout"},
      {416, "Range Not Satisfiable"},
      {431, "Request Header Fields Too Large"},
      {503, "Service Unavailable"},
      {505, "HTTP Version Not Supported"},
  }};
  for (const auto& [number, phrase] : kPhrases)
    if (number == status) return phrase;
  return "Unknown";
}

std::string head_text(const HttpAnswer& answer) {
  const std::uint64_t bytes =
      std::accumulate(answer.body.begin(), answer.body.end(), std::uint64_t{0},
                      [](std::uint64_t sum, const AnswerPart& part) { return sum + part.size(); });
  std::string head =
      "HTTP/1.1 " + std::to_string(answer.status) + " " + std::string(phrase_of(answer.status));
  for (const auto& [name, value] : answer.fields) head += "\r\n" + name + ": " + value;
  head += "\r\nContent-Length: " + std::to_string(bytes);
  return head + (answer.ends_connection ? "\r\nConnection: close" : "") + "\r\n\r\n";
}

}  // namespace

std::deque<AnswerPart> parts_of(HttpAnswer answer) {
  std::deque<AnswerPart> parts;
  parts.push_back({head_text(answer), nullptr, 0, 0});
  if (answer.body_is_held_back) return parts;
  for (AnswerPart& part : answer.body)
    if (part.size() > 0) parts.push_back(std::move(part));
  return parts;
}

}  // namespace limitgauge::app
