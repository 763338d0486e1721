#include "reports/record/json_value.h"

#include <cmath>

#include "model/base/error.h"

namespace limitgauge::reports::record {

JsonValue::JsonValue(const nlohmann::json& tree, std::string shown, std::string path)
    : json_(&tree), shown_(std::move(shown)), path_(std::move(path)) {}

void JsonValue::refuse(const std::string& wrong, const std::string& expected) const {
  const std::string name = path_.empty() ? "the whole" : path_;
  throw model::InputError({shown_, 0, 0}, name + " " + wrong, expected);
}

std::string JsonValue::kind() const {
  switch (json_->type()) {
    case nlohmann::json::value_t::null:
      return "is null";
    case nlohmann::json::value_t::object:
      return "is an object";
    case nlohmann::json::value_t::array:
      return "is a list";
    case nlohmann::json::value_t::string:
      return "is a text";
    case nlohmann::json::value_t::boolean:
      return "is a truth value";
    default:
      return "is a number";
  }
}

std::optional<JsonValue> JsonValue::find(const std::string& key) const {
  if (!json_->is_object()) refuse(kind(), "an object");
  const auto found = json_->find(key);
  if (found == json_->end()) return std::nullopt;
  return JsonValue(*found, shown_, path_.empty() ? key : path_ + "." + key);
}

JsonValue JsonValue::operator[](const std::string& key) const {
  if (std::optional<JsonValue> value = find(key)) return *value;
  refuse("has no key \"" + key + "\"", "a result as limitgauge writes it");
}

std::vector<JsonValue> JsonValue::items() const {
  if (!json_->is_array()) refuse(kind(), "a list");
  std::vector<JsonValue> out;
  out.reserve(json_->size());
  for (std::size_t i = 0; i < json_->size(); ++i)
    out.emplace_back((*json_)[i], shown_, path_ + "[" + std::to_string(i) + "]");
  return out;
}

std::vector<JsonValue> JsonValue::items(const std::string& key) const {
  const std::optional<JsonValue> list = find(key);
  return list ? list->items() : std::vector<JsonValue>{};
}

double JsonValue::number() const {
  if (!json_->is_number()) refuse(kind(), "a number");
  return json_->get<double>();
}

double JsonValue::length() const {
  const double value = number();
  if (value < 0) refuse("is below zero", "zero or more");
  return value;
}

double JsonValue::share() const {
  const double value = number();
  if (value < 0 || value > 1) refuse("is no share", "a number from 0 to 1");
  return value;
}

std::uint64_t JsonValue::count(std::uint64_t largest) const {
  const double value = number();
  if (value < 0 || value > static_cast<double>(largest) || value != std::floor(value))
    refuse("is no count", "a whole number from 0 to " + std::to_string(largest));
  return static_cast<std::uint64_t>(value);
}

bool JsonValue::flag() const {
  if (!json_->is_boolean()) refuse(kind(), "true or false");
  return json_->get<bool>();
}

std::string JsonValue::text() const {
  if (!json_->is_string()) refuse(kind(), "a text");
  return json_->get<std::string>();
}

verifier::Interval JsonValue::interval() const {
  const verifier::Interval out{(*this)["low"].length(), (*this)["high"].length()};
  if (out.low > out.high) refuse("has its low above its high", "an interval");
  return out;
}

model::Vec3 JsonValue::point() const {
  const std::vector<JsonValue> axes = items();
  if (axes.size() != 3) refuse("has not three entries", "x, y and z");
  return {axes[0].number(), axes[1].number(), axes[2].number()};
}

}  // namespace limitgauge::reports::record
