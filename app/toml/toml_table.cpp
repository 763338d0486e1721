#include "app/toml/toml_table.h"

#include <cmath>
#include <sstream>

#include "app/tolerance.h"
#include "app/toml/toml_text.h"
#include "model/base/coordinate_limit.h"
#include "model/text/message_text.h"

namespace limitgauge::app {
namespace {

/// "of type string: 'wide'".
std::string typed(const toml::node& node) {
  std::ostringstream out;
  out << "of type " << node.type() << ": " << shown_value(node);
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

/// The library's own conversion has nothing for a whole number that a double only comes near to.
std::optional<double> number_of(const toml::node& node) {
  if (const auto* whole = node.as_integer()) return static_cast<double>(whole->get());
  if (const auto* number = node.as_floating_point()) return number->get();
  return std::nullopt;
}

std::optional<double> finite_number(const toml::node& node) {
  const std::optional<double> value = number_of(node);
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
  if (!found.is_string()) refuse(key, "is " + typed(found), "a text");
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
  const std::optional<double> value = number_of(found);
  if (!value) refuse(key, "is " + typed(found), "a number");
  if (!std::isfinite(*value)) refuse(key, "is " + shown(*value), "a finite number");
  return *value;
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

double TomlTable::length_mm(std::string_view key) const {
  const double value_mm = positive(key);
  if (!model::is_length(value_mm))
    refuse(key, "is " + shown(value_mm) + " mm", model::kLengthExpected);
  return value_mm;
}

double TomlTable::length_or_zero_mm(std::string_view key) const {
  return not_negative(key) == 0 ? 0 : length_mm(key);
}

std::optional<double> TomlTable::length_or_auto_mm(std::string_view key) const {
  const toml::node& found = node(key);
  if (!found.is_string()) return length_mm(key);
  if (found.ref<std::string>() != "auto")
    refuse(key, "is \"" + found.ref<std::string>() + "\"", "a number above zero or \"auto\"");
  return std::nullopt;
}

double TomlTable::coordinate_mm(std::string_view key) const {
  const double value_mm = number(key);
  if (!model::is_near(value_mm))
    refuse(key, "is " + shown(value_mm) + " mm", model::kFarthestExpected);
  return value_mm;
}

double TomlTable::within(std::string_view key, double low, double high,
                         const char* expected) const {
  const double value = number(key);
  if (!(value >= low && value <= high)) refuse(key, "is " + shown(value), expected);
  return value;
}

double TomlTable::rate_mm_min(std::string_view key) const {
  positive(key);
  return within(key, kLeastRate_mm_min, kLargestRate_mm_min, kRateExpected);
}

double TomlTable::scale(std::string_view key) const {
  positive(key);
  return within(key, kLeastScale, kLargestScale, kScaleExpected);
}

double TomlTable::angle_deg(std::string_view key) const {
  return within(key, -kLargestAngle_deg, kLargestAngle_deg, kAngleExpected);
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
  if (!value)
    refuse(key, "is no whole number from 0 to a billion: " + shown_value(node(key)),
           "a whole number");
  return *value;
}

std::pair<int, int> TomlTable::whole_pair(std::string_view key) const {
  const toml::array* list = node(key).as_array();
  if (list != nullptr && list->size() == 2) {
    const std::optional<int> low = whole_number(*list->get(0)), high = whole_number(*list->get(1));
    if (low && high && *low <= *high) return {*low, *high};
  }
  refuse(key, "is no pair of ascending whole numbers: " + shown_value(node(key)),
         "an array as [7, 10]");
}

std::pair<double, double> TomlTable::ascending_pair(std::string_view key) const {
  const toml::array* list = node(key).as_array();
  if (list != nullptr && list->size() == 2) {
    const std::optional<double> low = finite_number(*list->get(0)),
                                high = finite_number(*list->get(1));
    if (low && high && *low < *high) return {*low, *high};
  }
  refuse(key, "is no pair of ascending numbers: " + shown_value(node(key)),
         "an array as [-200, 200]");
}

bool TomlTable::boolean(std::string_view key) const {
  const toml::node& found = node(key);
  if (!found.is_boolean()) refuse(key, "is " + typed(found), "true or false");
  return *found.value<bool>();
}

model::Vec3 TomlTable::vec3(std::string_view key) const {
  return vec3(key, node(key), "an array of three numbers");
}

std::array<model::Vec3, 3> TomlTable::vec3_rows(std::string_view key) const {
  constexpr const char* kExpected = "three arrays of three numbers each";
  const toml::node& found = node(key);
  const toml::array* list = found.as_array();
  if (list == nullptr) refuse(key, "is " + typed(found), kExpected);
  if (list->size() != 3) refuse(key, "has " + std::to_string(list->size()) + " entries", kExpected);
  std::array<model::Vec3, 3> rows;
  for (std::size_t row = 0; row < rows.size(); ++row)
    rows[row] = vec3(key, *list->get(row), kExpected);
  return rows;
}

model::Vec3 TomlTable::vec3(std::string_view key, const toml::node& found,
                            const char* expected) const {
  const toml::array* list = found.as_array();
  if (list == nullptr) refuse(key, "is " + typed(found), expected);
  if (list->size() != 3) refuse(key, "has " + std::to_string(list->size()) + " entries", expected);
  model::Vec3 value;
  for (int axis = 0; axis < 3; ++axis) {
    const std::optional<double> entry = finite_number(*list->get(axis));
    if (!entry) {
      refuse(key, "has an entry that is no finite number: " + shown_value(*list->get(axis)),
             expected);
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

model::Vec3 TomlTable::shift_mm(std::string_view key) const {
  const model::Vec3 value_mm = vec3(key);
  for (const int axis : {0, 1, 2})
    if (std::abs(value_mm[axis]) > model::kFarthestCoordinate_mm)
      refuse(key, "moves by " + shown(value_mm[axis]) + " mm", "1000000 mm (1 km) at most");
  return value_mm;
}

model::Interval TomlTable::tolerance_mm(std::string_view key, const toml::node& found) const {
  constexpr const char* kExpected =
      "a number that is not negative (0.005 is ±0.005), or [low, high]";
  if (const auto half = finite_number(found)) {
    if (*half < 0 || !model::is_near(*half)) refuse(key, "has " + shown(*half) + " mm", kExpected);
    return {-*half, *half};
  }
  const toml::array* list = found.as_array();
  if (list != nullptr && list->size() == 2) {
    const auto low = finite_number(*list->get(0)), high = finite_number(*list->get(1));
    if (low && high && *low <= *high && model::is_near(*low) && model::is_near(*high))
      return {*low, *high};
  }
  refuse(key, "has " + shown_value(found), kExpected);
}

model::Interval TomlTable::tolerance_mm(std::string_view key) const {
  return tolerance_mm(key, node(key));
}

std::array<model::Interval, 3> TomlTable::tolerances_mm(std::string_view key) const {
  const toml::array* list = node(key).as_array();
  if (list == nullptr || list->size() != 3)
    refuse(key, "is " + shown_value(node(key)), "an entry for each axis, as [0.005, 0.005, 0.005]");
  std::array<model::Interval, 3> out;
  for (std::size_t axis = 0; axis < 3; ++axis) out[axis] = tolerance_mm(key, *list->get(axis));
  return out;
}

const toml::table& TomlTable::table(std::string_view key) const {
  const toml::node& found = node(key);
  if (!found.is_table()) refuse(key, "is " + typed(found), "a table");
  return *found.as_table();
}

std::vector<const toml::table*> TomlTable::tables(std::string_view key) const {
  const toml::node& found = node(key);
  const toml::array* list = found.as_array();
  if (list == nullptr || list->empty()) {
    refuse(key, "is " + typed(found), "one or more tables [[" + std::string(key) + "]]");
  }
  std::vector<const toml::table*> all;
  for (const toml::node& entry : *list) {
    if (!entry.is_table()) refuse(key, "has an entry that is no table", "tables only");
    all.push_back(entry.as_table());
  }
  return all;
}

}  // namespace limitgauge::app
