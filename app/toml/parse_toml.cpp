#include "app/toml/toml_text.h"

#include <algorithm>
#include <bit>
#include <cstdint>
#include <sstream>
#include <string_view>
#include <utility>
#include <vector>

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

toml::table parsed(const std::string& text, const std::string& name_in_errors) {
  try {
    return toml::parse(text, name_in_errors);
  } catch (const toml::parse_error& error) {
    model::SourcePlace place = place_of(error.source());
    place.file = name_in_errors;
    throw model::InputError(place, std::string(error.description()), "TOML");
  }
}

constexpr auto kOtherBases = toml::value_flags::format_as_binary |
                             toml::value_flags::format_as_octal |
                             toml::value_flags::format_as_hexadecimal;

/// A node, and the key that it or the list around it stands at.
struct KeyedNode {
  const toml::node* node;
  std::string_view key;
};

void refuse_other_base(const KeyedNode& at) {
  const auto* whole = at.node->as_integer();
  if (whole == nullptr || (whole->flags() & kOtherBases) == toml::value_flags::none) return;
  throw OtherBase(place_of(at.node->source()),
                  "\"" + std::string(at.key) + "\" is " + shown_value(*at.node),
                  "decimals, as " + std::to_string(whole->get()));
}

/// With a list of what is left, and not by calls within calls: a key of many parts is as deep.
void refuse_other_bases(const toml::table& all) {
  std::vector<KeyedNode> left{{&all, {}}};
  while (!left.empty()) {
    const KeyedNode at = left.back();
    left.pop_back();
    const std::size_t before = left.size();
    if (const toml::table* table = at.node->as_table())
      for (const auto& [name, below] : *table) left.push_back({&below, name.str()});
    else if (const toml::array* list = at.node->as_array())
      for (const toml::node& entry : *list) left.push_back({&entry, at.key});
    else
      refuse_other_base(at);
    std::reverse(left.begin() + static_cast<std::ptrdiff_t>(before), left.end());
  }
}

}  // namespace

toml::table parse_toml(const std::string& text, const std::string& name_in_errors) {
  refuse_deep_keys(text, name_in_errors);
  toml::table table = parsed(text, name_in_errors);
  refuse_other_bases(table);
  return table;
}

namespace {

constexpr std::size_t kLongestShown = 60;

/// Not by toml++'s own writing of lists and tables: to choose their lines it casts the logarithm of
/// a number, which for one below 0.1 is undefined. Stops once there is more than is shown.
void show(std::ostringstream& out, const toml::node& node);

void show_separated(std::ostringstream& out, std::size_t& shown) {
  out << (shown++ == 0 ? " " : ", ");
}

void show_list(std::ostringstream& out, const toml::array& list) {
  std::size_t shown = 0;
  out << '[';
  for (const toml::node& entry : list) {
    if (out.tellp() > static_cast<std::streamoff>(kLongestShown)) return;
    show_separated(out, shown);
    show(out, entry);
  }
  out << (shown > 0 ? " ]" : "]");
}

void show_table(std::ostringstream& out, const toml::table& table) {
  std::size_t shown = 0;
  out << '{';
  for (const auto& [key, value] : table) {
    if (out.tellp() > static_cast<std::streamoff>(kLongestShown)) return;
    show_separated(out, shown);
    out << key.str() << " = ";
    show(out, value);
  }
  out << (shown > 0 ? " }" : "}");
}

void show(std::ostringstream& out, const toml::node& node) {
  if (const toml::table* table = node.as_table()) return show_table(out, *table);
  if (const toml::array* list = node.as_array()) return show_list(out, *list);
  node.visit([&out](const auto& known) {
    if constexpr (toml::is_value<decltype(known)>) out << known;
  });
}

}  // namespace

std::string shown_value(const toml::node& value) {
  std::ostringstream out;
  show(out, value);
  const std::string text = std::move(out).str();
  return text.size() > kLongestShown ? text.substr(0, kLongestShown) + "..." : text;
}

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

const toml::table* entry_named(const toml::array& entries, const std::string& name) {
  for (const toml::node& entry : entries) {
    const toml::table* table = entry.as_table();
    if (table == nullptr) continue;
    for (const char* key : {"name", "id"})
      if ((*table)[key].value<std::string>() == name) return table;
  }
  return nullptr;
}

toml::table* entry_named(toml::array& entries, const std::string& name) {
  return const_cast<toml::table*>(entry_named(std::as_const(entries), name));
}

}  // namespace limitgauge::app
