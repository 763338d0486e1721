#pragma once

#include <toml++/toml.h>

#include <array>
#include <initializer_list>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "model/base/error.h"
#include "model/geometry/interval.h"
#include "model/geometry/vec3.h"

namespace limitgauge::app {

/// Where `source` stands; a value that came from an override names the override instead of a file.
model::SourcePlace place_of(const toml::source_region& source);

/// A key that its table does not have; says which it has.
class UnknownKey : public model::InputError {
 public:
  UnknownKey(const model::SourcePlace& place, std::string_view key, const std::string& where,
             std::vector<std::string_view> known);
  const std::vector<std::string>& known() const { return known_; }

 private:
  std::vector<std::string> known_;
};

/// A table of a TOML file read by key, with errors that name file, line and column. All its keys
/// must be among the `known` ones; the error names the nearest.
class TomlTable {
 public:
  TomlTable(const toml::table& table, std::string where,
            std::initializer_list<std::string_view> known,
            std::span<const char* const> known_too = {});

  bool has(std::string_view key) const { return table_->contains(key); }
  bool is_table(std::string_view key) const { return (*table_)[key].is_table(); }
  bool is_text(std::string_view key) const { return (*table_)[key].is_string(); }
  const std::string& where() const { return where_; }
  model::SourcePlace place() const { return place_of(table_->source()); }
  /// Place of the value of `key`, or of the table where there is none.
  model::SourcePlace place(std::string_view key) const;

  /// Each throws InputError where the key is missing, of another type, or out of its range.
  std::string text(std::string_view key) const;
  std::string one_of(std::string_view key, std::initializer_list<std::string_view> choices) const;
  double number(std::string_view key) const;
  double positive(std::string_view key) const;
  double not_negative(std::string_view key) const;
  double length_mm(std::string_view key) const;  ///< as model::is_length() has it
  double length_or_zero_mm(std::string_view key) const;
  std::optional<double> length_or_auto_mm(std::string_view key) const;  ///< nothing for "auto"
  double coordinate_mm(std::string_view key) const;  ///< within model::kFarthestMm of zero
  double rate_mm_min(std::string_view key) const;
  double scale(std::string_view key) const;
  double angle_deg(std::string_view key) const;
  /// Ends included; `expected` is what errors say of them.
  double within(std::string_view key, double low, double high, const char* expected) const;
  double share(std::string_view key) const;                                ///< from 0 to 1
  double between(std::string_view key, double above, double below) const;  ///< ends excluded
  int whole(std::string_view key) const;                                   ///< 0 to a billion
  std::pair<double, double> ascending_pair(std::string_view key) const;    ///< low < high
  std::pair<int, int> whole_pair(std::string_view key) const;              ///< ascending
  bool boolean(std::string_view key) const;
  model::Vec3 vec3(std::string_view key) const;
  std::array<model::Vec3, 3> vec3_rows(std::string_view key) const;  ///< three of three numbers
  model::Vec3 position(std::string_view key) const;  ///< within model::kFarthestMm of zero
  /// How far something is moved: by 1 km at most, since it may have lain as far off.
  model::Vec3 shift_mm(std::string_view key) const;
  /// What a figure may be off by: `h` is ±h, `[low, high]` a range; within model::kFarthestMm.
  model::Interval tolerance_mm(std::string_view key) const;
  /// The same for each axis, `[x, y, z]`.
  std::array<model::Interval, 3> tolerances_mm(std::string_view key) const;
  const toml::table& table(std::string_view key) const;
  /// The tables of `[[key]]`.
  std::vector<const toml::table*> tables(std::string_view key) const;

 private:
  const toml::node& node(std::string_view key) const;
  model::Vec3 vec3(std::string_view key, const toml::node& found, const char* expected) const;
  model::Interval tolerance_mm(std::string_view key, const toml::node& found) const;
  [[noreturn]] void refuse(std::string_view key, const std::string& wrong,
                           const std::string& expected) const;

  const toml::table* table_;
  std::string where_;
};

}  // namespace limitgauge::app
