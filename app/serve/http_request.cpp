#include "app/serve/http_request.h"

#include <algorithm>

#include "model/text/characters.h"

namespace limitgauge::app {
namespace {

bool is_token(std::string_view text) {
  constexpr std::string_view kMarks = "!#$%&'*+-.^_`|~";
  return !text.empty() && std::all_of(text.begin(), text.end(), [&](char c) {
    return model::is_digit(c) || model::is_letter(c) || kMarks.find(c) != kMarks.npos;
  });
}

bool is_control(char c) {
  return (static_cast<unsigned char>(c) < ' ' && c != '\t') || c == '\x7f';
}

std::string lower_case(std::string_view text) {
  std::string lower(text);
  for (char& c : lower) c = model::lower(c);
  return lower;
}

/// The next line without its end, which is taken off `rest`; nothing where it does not end in CRLF.
std::optional<std::string_view> take_line(std::string_view& rest) {
  const std::size_t end = rest.find("\r\n");
  if (end == rest.npos) return std::nullopt;
  const std::string_view line = rest.substr(0, end);
  rest.remove_prefix(end + 2);
  if (std::any_of(line.begin(), line.end(), is_control)) return std::nullopt;
  return line;
}

/// 0, or the status that says what is wrong.
int read_first_line(std::string_view line, HttpRequest& request) {
  const std::size_t first = line.find(' '), last = line.rfind(' ');
  if (first == line.npos || last == first) return 400;
  const std::string_view target = line.substr(first + 1, last - first - 1);
  const std::string_view version = line.substr(last + 1);
  if (!is_token(line.substr(0, first)) || target.empty() || target.find(' ') != target.npos)
    return 400;
  if (version != "HTTP/1.1" && version != "HTTP/1.0")
    return version.starts_with("HTTP/") ? 505 : 400;
  request.method = line.substr(0, first);
  request.target = target;
  request.stays = version == "HTTP/1.1";
  return 0;
}

bool read_field(std::string_view line, HttpRequest& request) {
  const std::size_t colon = line.find(':');
  // A blank before the colon or at the line's beginning means different things to different
  // readers.
  if (colon == line.npos || !is_token(line.substr(0, colon))) return false;
  request.fields.emplace_back(lower_case(line.substr(0, colon)),
                              without_blanks_around(line.substr(colon + 1)));
  return true;
}

/// What the fields say of the connection.
void draw_conclusions(HttpRequest& request) {
  for (const auto& [name, value] : request.fields) {
    if (name == "connection" && lower_case(value).find("close") != std::string::npos)
      request.stays = false;
    if (name == "transfer-encoding" || (name == "content-length" && value != "0"))
      request.has_content = true;
  }
  // Where content ends is not looked into: what follows could be taken for another request.
  if (request.has_content) request.stays = false;
}

int value_of_digit(char c) {
  if (model::is_digit(c)) return c - '0';
  const char letter = model::lower(c);
  return letter >= 'a' && letter <= 'f' ? letter - 'a' + 10 : -1;
}

}  // namespace

std::string_view without_blanks_around(std::string_view text) {
  const std::size_t first = text.find_first_not_of(" \t");
  if (first == text.npos) return {};
  return text.substr(first, text.find_last_not_of(" \t") + 1 - first);
}

std::optional<std::string> HttpRequest::only(std::string_view name) const {
  std::optional<std::string> found;
  for (const auto& [of, value] : fields) {
    if (of != name) continue;
    if (found) return std::nullopt;
    found = value;
  }
  return found;
}

std::optional<std::size_t> head_length(std::string_view received) {
  // Empty lines before a request are to be forgiven.
  const std::size_t begin = received.find_first_not_of("\r\n");
  if (begin == received.npos) return std::nullopt;
  for (std::size_t at = received.find('\n', begin); at != received.npos;
       at = received.find('\n', at + 1)) {
    // Lines that end in a bare LF are refused, but not waited for.
    if (received.substr(at + 1).starts_with("\r\n")) return at + 3;
    if (received.substr(at + 1).starts_with('\n')) return at + 2;
  }
  return std::nullopt;
}

std::variant<HttpRequest, RefusedHead> request_of(std::string_view head) {
  head.remove_prefix(std::min(head.find_first_not_of("\r\n"), head.size()));
  HttpRequest request;
  const std::optional<std::string_view> first = take_line(head);
  const int wrong = first ? read_first_line(*first, request) : 400;
  if (wrong == 505) return RefusedHead{505, "This server speaks HTTP/1.1."};
  if (wrong != 0) return RefusedHead{400, "This is no request."};
  while (true) {
    const std::optional<std::string_view> line = take_line(head);
    if (line && line->empty()) break;
    if (!line || !read_field(*line, request))
      return RefusedHead{400, "There is a line in this request that is no field."};
  }
  draw_conclusions(request);
  return request;
}

std::string path_of(std::string_view target) {
  target = target.substr(0, target.find_first_of("?#"));
  std::string path;
  for (std::size_t i = 0; i < target.size(); ++i) {
    const bool coded = target[i] == '%' && i + 2 < target.size();
    const int high = coded ? value_of_digit(target[i + 1]) : -1;
    const int low = coded ? value_of_digit(target[i + 2]) : -1;
    if (high >= 0 && low >= 0) i += 2;
    path += high >= 0 && low >= 0 ? static_cast<char>(high * 16 + low) : target[i];
  }
  return path;
}

}  // namespace limitgauge::app
