#include "app/toml/toml_table.h"

#include <cmath>
#include <sstream>

#include "model/base/coordinate_limit.h"
#include "model/base/message_text.h"

namespace limitgauge::app {
namespace {

std::string type_name(const toml::node& node) {
  std::ostringstream out;
  out << node.type();
  return out.str();
}

std::string listed(std::initializer_list<std::string_view> choices) {
  std::string text;
  for (const std::string_view choice : choices) {
    text += (text.empty() ? "\"" : ", \"") + std::string(choice) + "\"";
  }
  return text;
}

std::string shown(double value) {
  std::ostringstream out;
  out << value;
  return out.str();
}

std::optional<double> finite_number(const toml::node& node) {
  const std::optional<double> value = node.is_number() ? node.value<double>() : std::nullopt;
  return value && std::isfinite(*value) ? value : std::nullopt;
}

std::optional<int> whole_number(const toml::node& node) {
  constexpr std::int64_t kLargest = 1'000'000'000;
  const std::optional<std::int64_t> value = node.value_exact<std::int64_t>();
  if (!value || *value < 0 || *value > kLargest) return std::nullopt;
  return static_cast<int>(*value);
}

}  // namespace

model::SourcePlace place_of(const toml::source_region& source) {
  model::SourcePlace place;
  if (source.path) place.file = *source.path;
  // What comes from a command line has no line worth naming.
  if (place.file.rfind("--set ", 0) == 0) return place;
  place.line = static_cast<int>(source.begin.line);
  place.column = static_cast<int>(source.begin.column);
  return place;
}

UnknownKey::UnknownKey(const model::SourcePlace& place, std::string_view key,
                       const std::string& where, std::vector<std::string_view> known)
    : InputError(place, "unknown key \"" + std::string(key) + "\" in " + where,
                 "\"" + model::nearest_word(key, known) + "\" or another known key"),
      known_(known.begin(), known.end()) {}

TomlTable::TomlTable(const toml::table& table, std::string where,
                     std::initializer_list<std::string_view> known,
                     std::span<const char* const> known_too)
    : table_(&table), where_(std::move(where)) {
  std::vector<std::string_view> keys(known);
  keys.insert(keys.end(), known_too.begin(), known_too.end());
  for (const auto& [key, value] : table) {
    if (std::find(keys.begin(), keys.end(), key.str()) != keys.end()) continue;
    const model::SourcePlace stated = place_of(key.source());
    throw UnknownKey(stated.file.empty() ? place_of(value.source()) : stated, key.str(), where_,
                     keys);
  }
}

model::SourcePlace TomlTable::place(std::string_view key) const {
  const toml::node* found = table_->get(key);
  return found == nullptr ? place() : place_of(found->source());
}

void TomlTable::refuse(std::string_view key, const std::string& wrong,
                       const std::string& expected) const {
  throw model::InputError(place(key), "\"" + std::string(key) + "\" in " + where_ + " " + wrong,
                          expected);
}

const toml::node& TomlTable::node(std::string_view key) const {
  const toml::node* found = table_->get(key);
  if (found == nullptr) {
    throw model::InputError(place(), "missing key \"" + std::string(key) + "\" in " + where_,
                            "the key to be stated");
  }
  return *found;
}

std::string TomlTable::text(std::string_view key) const {
  const toml::node& found = node(key);
  if (!found.is_string()) refuse(key, "is of type " + type_name(found), "a text");
  if (found.ref<std::string>().empty()) refuse(key, "is empty", "a text");
  return found.ref<std::string>();
}

std::string TomlTable::one_of(std::string_view key,
                              std::initializer_list<std::string_view> choices) const {
  const std::string value = text(key);
  if (std::find(choices.begin(), choices.end(), value) == choices.end()) {
    refuse(key, "is \"" + value + "\"", "one of " + listed(choices));
  }
  return value;
}

double TomlTable::number(std::string_view key) const {
  const toml::node& found = node(key);
  if (!found.is_number()) refuse(key, "is of type " + type_name(found), "a number");
  const double value = *found.value<double>();
  if (!std::isfinite(value)) refuse(key, "is " + shown(value), "a finite number");
  return value;
}

double TomlTable::positive(std::string_view key) const {
  const double value = number(key);
  if (!(value > 0)) refuse(key, "is " + shown(value), "a number above zero");
  return value;
}

double TomlTable::not_negative(std::string_view key) const {
  const double value = number(key);
  if (!(value >= 0)) refuse(key, "is " + shown(value), "a number that is not negative");
  return value;
}

double TomlTable::share(std::string_view key) const {
  const double value = number(key);
  if (!(value >= 0 && value <= 1)) refuse(key, "is " + shown(value), "a share from 0 to 1");
  return value;
}

double TomlTable::between(std::string_view key, double above, double below) const {
  const double value = number(key);
  if (!(value > above && value < below))
    refuse(key, "is " + shown(value), "a number between " + shown(above) + " and " + shown(below));
  return value;
}

int TomlTable::whole(std::string_view key) const {
  const std::optional<int> value = whole_number(node(key));
  if (!value) refuse(key, "is no whole number from 0 to a billion", "a whole number");
  return *value;
}

std::pair<int, int> TomlTable::whole_pair(std::string_view key) const {
  const toml::array* list = node(key).as_array();
  if (list != nullptr && list->size() == 2) {
    const std::optional<int> low = whole_number(*list->get(0)), high = whole_number(*list->get(1));
    if (low && high && *low <= *high) return {*low, *high};
  }
  refuse(key, "is no pair of ascending whole numbers", "an array as [7, 10]");
}

std::pair<double, double> TomlTable::ascending_pair(std::string_view key) const {
  const toml::array* list = node(key).as_array();
  if (list != nullptr && list->size() == 2) {
    const std::optional<double> low = finite_number(*list->get(0)),
                                high = finite_number(*list->get(1));
    if (low && high && *low < *high) return {*low, *high};
  }
  refuse(key, "is no pair of ascending numbers", "an array as [-200, 200]");
}

bool TomlTable::boolean(std::string_view key) const {
  const toml::node& found = node(key);
  if (!found.is_boolean()) refuse(key, "is of type " + type_name(found), "true or false");
  return *found.value<bool>();
}

model::Vec3 TomlTable::vec3(std::string_view key) const {
  const toml::node& found = node(key);
  const toml::array* list = found.as_array();
  if (list == nullptr) refuse(key, "is of type " + type_name(found), "an array of three numbers");
  if (list->size() != 3) {
    refuse(key, "has " + std::to_string(list->size()) + " entries", "an array of three numbers");
  }
  model::Vec3 value;
  for (int axis = 0; axis < 3; ++axis) {
    const std::optional<double> entry = list->get(axis)->value<double>();
    if (!entry || !std::isfinite(*entry)) {
      refuse(key, "has an entry that is no finite number", "an array of three numbers");
    }
    value[axis] = *entry;
  }
  return value;
}

model::Vec3 TomlTable::position(std::string_view key) const {
  const model::Vec3 value_mm = vec3(key);
  if (!model::is_near(value_mm))
    refuse(key, "has " + model::farthest_words(value_mm), model::kFarthestExpected);
  return value_mm;
}

const toml::table& TomlTable::table(std::string_view key) const {
  const toml::node& found = node(key);
  if (!found.is_table()) refuse(key, "is of type " + type_name(found), "a table");
  return *found.as_table();
}

std::vector<const toml::table*> TomlTable::tables(std::string_view key) const {
  const toml::node& found = node(key);
  const toml::array* list = found.as_array();
  if (list == nullptr || list->empty()) {
    refuse(key, "is of type " + type_name(found),
           "one or more tables [[" + std::string(key) + "]]");
  }
  std::vector<const toml::table*> all;
  for (const toml::node& entry : *list) {
    if (!entry.is_table()) refuse(key, "has an entry that is no table", "tables only");
    all.push_back(entry.as_table());
  }
  return all;
}

std::optional<double> TomlTable::positive_or_auto(std::string_view key) const {
  const toml::node& found = node(key);
  if (!found.is_string()) return positive(key);
  if (found.ref<std::string>() != "auto") {
    refuse(key, "is \"" + found.ref<std::string>() + "\"", "a number above zero or \"auto\"");
  }
  return std::nullopt;
}

}  // namespace limitgauge::app
