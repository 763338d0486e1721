#include "app/study/study_setting.h"

#include <cmath>

#include "app/toml/toml_table.h"
#include "model/base/number_text.h"

namespace limitgauge::app {
namespace {

/// As a basic string of one line.
std::string toml_quoted(std::string_view text) {
  constexpr const char* kDigits = "0123456789ABCDEF";
  std::string out = "\"";
  for (const char c : text) {
    const auto byte = static_cast<unsigned char>(c);
    if (c == '"' || c == '\\') {
      out += std::string("\\") + c;
    } else if (byte < 0x20 || byte == 0x7F) {
      out += std::string("\\u00") + kDigits[byte >> 4] + kDigits[byte & 15];
    } else {
      out += c;
    }
  }
  return out + "\"";
}

[[noreturn]] void refuse_value(const toml::node& value, const std::string& what,
                               const std::string& wrong) {
  throw model::InputError(place_of(value.source()), what + " " + wrong,
                          "finite numbers, texts, true, false, lists or inline tables of them");
}

std::string text_of(const toml::node& value, const std::string& what);

std::string list_text(const toml::array& list, const std::string& what) {
  std::string text;
  for (const toml::node& entry : list) text += (text.empty() ? "" : ", ") + text_of(entry, what);
  return "[" + text + "]";
}

std::string table_text(const toml::table& table, const std::string& what) {
  std::string text;
  for (const auto& [key, value] : table)
    text += (text.empty() ? " " : ", ") + toml_quoted(key.str()) + " = " + text_of(value, what);
  return "{" + text + " }";
}

std::string text_of(const toml::node& value, const std::string& what) {
  if (const auto* whole = value.as_integer()) return std::to_string(whole->get());
  if (const auto* number = value.as_floating_point()) {
    if (!std::isfinite(number->get())) refuse_value(value, what, "has a number that is not finite");
    return model::shortest(number->get());
  }
  if (const auto* yes = value.as_boolean()) return yes->get() ? "true" : "false";
  if (const auto* text = value.as_string()) return toml_quoted(text->get());
  if (const toml::array* list = value.as_array()) return list_text(*list, what);
  if (const toml::table* table = value.as_table()) return table_text(*table, what);
  refuse_value(value, what, "has a date or time");
}

}  // namespace

study::Setting setting_of(const toml::node& value, const std::string& what) {
  study::Setting setting{text_of(value, what), std::nullopt};
  if (value.is_number()) setting.number = value.value<double>();
  return setting;
}

}  // namespace limitgauge::app
