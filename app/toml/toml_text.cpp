#include "app/toml/toml_text.h"

#include "app/toml/toml_table.h"
#include "model/base/error.h"

namespace limitgauge::app {
namespace {

/// Counts the dots of each line with no dot beside them, wherever they stand: at least as many as a
/// dotted key on that line can have, since a key neither spans lines nor has empty parts.
void refuse_deep_keys(const std::string& text, const std::string& name_in_errors) {
  int line = 1, dots = 0;
  std::size_t line_begin = 0;
  const auto is_dot = [&](std::size_t at) { return at < text.size() && text[at] == '.'; };
  for (std::size_t at = 0; at < text.size(); ++at) {
    if (text[at] == '\n') ++line, dots = 0, line_begin = at + 1;
    if (!is_dot(at) || is_dot(at + 1) || (at > 0 && is_dot(at - 1))) continue;
    if (++dots > kMostDots)
      throw model::InputError({name_in_errors, line, static_cast<int>(at - line_begin) + 1},
                              "more than " + std::to_string(kMostDots) + " dots in one line",
                              "keys of fewer parts, or several lines");
  }
}

}  // namespace

toml::table parse_toml(const std::string& text, const std::string& name_in_errors) {
  refuse_deep_keys(text, name_in_errors);
  try {
    return toml::parse(text, name_in_errors);
  } catch (const toml::parse_error& error) {
    model::SourcePlace place = place_of(error.source());
    place.file = name_in_errors;
    throw model::InputError(place, std::string(error.description()), "TOML");
  }
}

}  // namespace limitgauge::app
