#include "reports/record/json_value.h"

#include <algorithm>
#include <cmath>
#include <string_view>
#include <vector>

#include "model/base/error.h"

namespace limitgauge::reports::record {
namespace {

using Json = nlohmann::json;

/// A result needs 8; what reads trees calls itself, and must not do so without end.
constexpr std::size_t kDeepest = 64;
/// A tree takes some ten times its text.
constexpr std::size_t kLargest_bytes = std::size_t{256} << 20;

/// The place of the last of `read` bytes.
model::SourcePlace place_at(std::string_view text, std::size_t read, const std::string& shown) {
  const std::string_view before = text.substr(0, std::min(read > 0 ? read - 1 : 0, text.size()));
  const auto line = std::count(before.begin(), before.end(), '\n') + 1;
  const std::size_t last = before.rfind('\n');
  const std::size_t begin = last == std::string_view::npos ? 0 : last + 1;
  return {shown, static_cast<int>(line), static_cast<int>(before.size() - begin + 1)};
}

/// "syntax error while parsing value - invalid literal": the library's words without the place, and
/// without what was read, which may be as long as the file.
std::string in_short(std::string_view what) {
  what = what.substr(0, std::min(what.find("; last read"), what.find("; expected")));
  if (const std::size_t name = what.find("] "); name != std::string_view::npos)
    what.remove_prefix(name + 2);
  if (const std::size_t place = what.find(": "); what.starts_with("parse error"))
    what.remove_prefix(place == std::string_view::npos ? 0 : place + 2);
  constexpr std::size_t kLongest = 200;
  return std::string(what.substr(0, kLongest));
}

/// Builds the tree while the library reads: unlike its own builder it knows where a number stands
/// that is too large, and how deep it is.
class TreeBuilder {
 public:
  TreeBuilder(const std::string& text, const std::string& shown) : text_(text), shown_(shown) {}
  Json take() { return std::move(root_); }

  bool null() { return put(nullptr); }
  bool boolean(bool value) { return put(value); }
  bool number_integer(Json::number_integer_t value) { return put(value); }
  bool number_unsigned(Json::number_unsigned_t value) { return put(value); }
  bool number_float(Json::number_float_t value, const std::string&) { return put(value); }
  bool string(std::string& value) { return put(std::move(value)); }
  bool binary(Json::binary_t& value) { return put(std::move(value)); }
  bool start_object(std::size_t) { return open(Json::object()); }
  bool start_array(std::size_t) { return open(Json::array()); }
  bool end_object() { return close(); }
  bool end_array() { return close(); }
  bool key(std::string& name) {
    key_ = std::move(name);
    return true;
  }
  bool parse_error(std::size_t read, const std::string&, const Json::exception& error) {
    // The library's words for nothing at all differ from release to release.
    const std::string wrong = text_.empty() ? "nothing is there" : in_short(error.what());
    throw model::InputError(place_at(text_, read, shown_), "broken JSON: " + wrong,
                            "result.json as limitgauge writes it");
  }

 private:
  Json* insert(Json value) {
    if (open_.empty()) return &(root_ = std::move(value));
    Json& parent = *open_.back();
    if (parent.is_object()) return &(parent[key_] = std::move(value));
    parent.push_back(std::move(value));
    return &parent.back();
  }
  bool put(Json value) {
    insert(std::move(value));
    return true;
  }
  bool open(Json value) {
    if (open_.size() == kDeepest) {
      throw model::InputError({shown_, 0, 0},
                              "nested more than " + std::to_string(kDeepest) + " levels deep",
                              "result.json as limitgauge writes it");
    }
    open_.push_back(insert(std::move(value)));
    return true;
  }
  bool close() {
    open_.pop_back();
    return true;
  }

  const std::string& text_;
  const std::string& shown_;
  Json root_;
  std::vector<Json*> open_;  ///< those above what is read next; none of them moves meanwhile
  std::string key_;
};

}  // namespace

nlohmann::json parse_json(const std::string& text, const std::string& shown) {
  if (text.size() > kLargest_bytes) {
    throw model::InputError({shown, 0, 0}, "larger than 256 MiB",
                            "result.json as limitgauge writes it");
  }
  TreeBuilder builder(text, shown);
  Json::sax_parse(text, &builder);
  return builder.take();
}

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

std::vector<std::pair<std::string, JsonValue>> JsonValue::members() const {
  if (!json_->is_object()) refuse(kind(), "an object");
  std::vector<std::pair<std::string, JsonValue>> out;
  for (const auto& [key, value] : json_->items())
    out.emplace_back(key, JsonValue(value, shown_, path_.empty() ? key : path_ + "." + key));
  return out;
}

bool JsonValue::is_null() const {
  return json_->is_null();
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

std::string JsonValue::json() const {
  return json_->dump();
}

verifier::Interval JsonValue::interval() const {
  const verifier::Interval out{(*this)["low"].length(), (*this)["high"].length()};
  if (out.low > out.high) refuse("has its low above its high", "an interval");
  return out;
}

verifier::Interval JsonValue::range() const {
  const std::vector<JsonValue> ends = items();
  if (ends.size() != 2) refuse("has not two entries", "lower and upper end");
  const verifier::Interval out{ends[0].number(), ends[1].number()};
  if (out.low > out.high) refuse("has its lower end above its upper", "a range");
  return out;
}

model::Vec3 JsonValue::point() const {
  const std::vector<JsonValue> axes = items();
  if (axes.size() != 3) refuse("has not three entries", "x, y and z");
  return {axes[0].number(), axes[1].number(), axes[2].number()};
}

}  // namespace limitgauge::reports::record
