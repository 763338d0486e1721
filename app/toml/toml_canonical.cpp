#include "app/toml/toml_canonical.h"

#include <bit>
#include <cstdint>
#include <sstream>

namespace limitgauge::app {
namespace {

/// Its length first: no text can look like two.
void put(std::string& out, std::string_view text) {
  out += std::to_string(text.size());
  out += ':';
  out += text;
}

void put(std::string& out, const toml::node& node);

void put(std::string& out, const toml::table& table) {
  out += '{';
  for (const auto& [key, value] : table) {
    put(out, key.str());
    put(out, value);
  }
  out += '}';
}

void put(std::string& out, const toml::array& array) {
  out += '[';
  for (const toml::node& value : array) put(out, value);
  out += ']';
}

/// Dates and times: nothing of a job is one, and all of them can be written.
void put_other(std::string& out, const toml::node& node) {
  std::ostringstream text;
  node.visit([&text](const auto& value) {
    if constexpr (toml::is_date<decltype(value)> || toml::is_time<decltype(value)> ||
                  toml::is_date_time<decltype(value)>)
      text << value.get();
  });
  out += 'd';
  put(out, text.str());
}

void put(std::string& out, const toml::node& node) {
  if (const toml::table* table = node.as_table()) return put(out, *table);
  if (const toml::array* array = node.as_array()) return put(out, *array);
  if (const auto* text = node.as_string()) {
    out += 's';
    put(out, text->get());
  } else if (const auto* whole = node.as_integer()) {
    out += 'i' + std::to_string(whole->get()) + ';';
  } else if (const auto* number = node.as_floating_point()) {
    out += 'f' + std::to_string(std::bit_cast<std::uint64_t>(number->get())) + ';';
  } else if (const auto* truth = node.as_boolean()) {
    out += truth->get() ? 'y' : 'n';
  } else {
    put_other(out, node);
  }
}

}  // namespace

std::string canonical(const toml::node& node) {
  std::string out;
  put(out, node);
  return out;
}

}  // namespace limitgauge::app
