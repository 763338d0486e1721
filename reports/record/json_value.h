#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <nlohmann/json.hpp>

#include "model/geometry/vec3.h"
#include "verifier/gate/deviation.h"

namespace limitgauge::reports::record {

/// `text` as a tree. Throws model::InputError with the line and column of what is no JSON, of a
/// number that is too large for a double, and for nesting so deep that no result has it.
nlohmann::json parse_json(const std::string& text, const std::string& shown);

/// A value in a tree with the path to it. Asking for what it is not throws model::InputError with
/// that path: "stages[1].deviation.gouge_mm.low is a text; expected a number".
class JsonValue {
 public:
  /// `tree` must outlive it; `shown` names the file.
  JsonValue(const nlohmann::json& tree, std::string shown, std::string path = {});

  JsonValue operator[](const std::string& key) const;           ///< must be there
  std::optional<JsonValue> find(const std::string& key) const;  ///< may be absent
  std::vector<JsonValue> items() const;                         ///< of a list
  std::vector<JsonValue> items(const std::string& key) const;   ///< none where it is absent

  /// Of an object: names and values, in the order of the names.
  std::vector<std::pair<std::string, JsonValue>> members() const;
  bool is_null() const;

  double number() const;
  double length() const;  ///< zero or more
  double share() const;   ///< 0 to 1
  std::uint64_t count(std::uint64_t largest = std::uint64_t{1} << 53) const;
  bool flag() const;
  std::string text() const;
  std::string json() const;  ///< whatever it is, on one line, its names in alphabetical order
  verifier::Interval interval() const;  ///< of an object with low and high
  verifier::Interval range() const;     ///< of a list of two, which may lie below zero
  model::Vec3 point() const;            ///< of a list of three

  [[noreturn]] void refuse(const std::string& wrong, const std::string& expected) const;

 private:
  std::string kind() const;

  const nlohmann::json* json_;
  std::string shown_, path_;
};

}  // namespace limitgauge::reports::record
