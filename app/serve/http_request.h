#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

namespace limitgauge::app {

/// The head of one request, as RFC 9112 has it.
struct HttpRequest {
  std::string method, target;
  /// Names in lower case, in the order they came in.
  std::vector<std::pair<std::string, std::string>> fields;
  bool stays = false;        ///< the client may ask again on this connection
  bool has_content = false;  ///< bytes of it follow the head

  /// The value of a field that stands there once; nothing for none or several.
  std::optional<std::string> only(std::string_view name) const;
};

/// Why a head is no request that can be answered.
struct RefusedHead {
  int status = 400;
  std::string why;
};

/// Longest head that is read, bytes. A browser's are a kilobyte.
constexpr std::size_t kLongestHead = std::size_t{1} << 14;

/// How long the head at the beginning of `received` is, with the empty line that ends it and those
/// before it; nothing where that has not come yet.
std::optional<std::size_t> head_length(std::string_view received);

/// Reads a head that head_length() has measured.
std::variant<HttpRequest, RefusedHead> request_of(std::string_view head);

/// The path of a request's target: no query, %41 as A. What is not well written stays as it is.
std::string path_of(std::string_view target);

/// Without the spaces and tabs around a field's value, or around one of those in a list.
std::string_view without_blanks_around(std::string_view text);

}  // namespace limitgauge::app
