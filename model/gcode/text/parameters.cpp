#include "model/gcode/text/parameters.h"

#include <algorithm>
#include <utility>

namespace limitgauge::model::gcode {
namespace {

struct Range {
  int first, last;
};
constexpr std::array kOwned = {Range{5021, 5029},   // position, machine coordinates
                               Range{5161, 5169},   // G28's point
                               Range{5181, 5189},   // G30's point
                               Range{5210, 5390},   // G92's offset, work offsets
                               Range{5400, 5413},   // the tool
                               Range{5420, 5428}};  // position, work coordinates

/// LinuxCNC's predefined names, sorted.
constexpr auto kOwnedNames = std::to_array<std::string_view>({"_a",
                                                              "_abs_a",
                                                              "_abs_b",
                                                              "_abs_c",
                                                              "_abs_u",
                                                              "_abs_v",
                                                              "_abs_w",
                                                              "_abs_x",
                                                              "_abs_y",
                                                              "_abs_z",
                                                              "_absolute",
                                                              "_adaptive_feed",
                                                              "_b",
                                                              "_c",
                                                              "_call_level",
                                                              "_ccomp",
                                                              "_coord_system",
                                                              "_current_pocket",
                                                              "_current_tool",
                                                              "_feed",
                                                              "_feed_hold",
                                                              "_feed_override",
                                                              "_flood",
                                                              "_ijk_absolute_mode",
                                                              "_imperial",
                                                              "_incremental",
                                                              "_inverse_time",
                                                              "_lathe_diameter_mode",
                                                              "_lathe_radius_mode",
                                                              "_line",
                                                              "_metric",
                                                              "_metric_machine",
                                                              "_mist",
                                                              "_motion_mode",
                                                              "_plane",
                                                              "_remap_level",
                                                              "_retract_old_z",
                                                              "_retract_r_plane",
                                                              "_rpm",
                                                              "_selected_pocket",
                                                              "_selected_tool",
                                                              "_speed_override",
                                                              "_spindle_css_mode",
                                                              "_spindle_cw",
                                                              "_spindle_on",
                                                              "_spindle_rpm_mode",
                                                              "_task",
                                                              "_tool_offset",
                                                              "_u",
                                                              "_units_per_minute",
                                                              "_units_per_rev",
                                                              "_v",
                                                              "_value",
                                                              "_value_returned",
                                                              "_vmajor",
                                                              "_vminor",
                                                              "_w",
                                                              "_x",
                                                              "_y",
                                                              "_z"});

bool is_global(std::string_view name) {
  return name.starts_with('_');
}

}  // namespace

void Parameters::set_system(SystemNumbered numbered, SystemNamed named) {
  system_numbered_ = std::move(numbered);
  system_named_ = std::move(named);
}

std::optional<double> Parameters::numbered(int number) const {
  if (number < 1 || number > kLargest) return std::nullopt;
  const auto index = static_cast<std::size_t>(number);
  if (number <= locals_) return frames_.back().numbered[index];
  const int first_of_system = locals_ == kLargestMacroLocal ? kFirstMacroSystem : kLargestFree + 1;
  if (number >= first_of_system && system_numbered_) {
    if (const std::optional<double> value = system_numbered_(number)) return value;
  }
  return numbered_[index];
}

std::optional<double> Parameters::named(std::string_view name) const {
  const bool global = is_global(name);
  if (global && system_named_) {
    if (const std::optional<double> value = system_named_(name)) return value;
  }
  const auto& known = global ? named_ : frames_.back().named;
  const auto found = known.find(name);
  return found == known.end() ? std::nullopt : std::optional(found->second);
}

bool Parameters::is_settable(int number) {
  if (number < 1 || number > kLargest) return false;
  return std::none_of(kOwned.begin(), kOwned.end(), [number](const Range& range) {
    return number >= range.first && number <= range.last;
  });
}

bool Parameters::is_settable(std::string_view name) {
  return !std::binary_search(kOwnedNames.begin(), kOwnedNames.end(), name) &&
         !name.starts_with("_ini[") && !name.starts_with("_hal[");
}

void Parameters::set(int number, double value) {
  if (number < 1 || number > kLargest) return;
  const auto index = static_cast<std::size_t>(number);
  (number <= locals_ ? frames_.back().numbered[index] : numbered_[index]) = value;
}

void Parameters::clear(int number) {
  if (number < 1 || number > kLargest) return;
  const auto index = static_cast<std::size_t>(number);
  (number <= locals_ ? frames_.back().numbered[index] : numbered_[index]).reset();
}

void Parameters::set(std::string_view name, double value) {
  auto& known = is_global(name) ? named_ : frames_.back().named;
  const auto found = known.find(name);
  if (found == known.end()) {
    known.emplace(name, value);
  } else {
    found->second = value;
  }
}

void Parameters::enter(const std::vector<double>& arguments) {
  Frame& frame = frames_.emplace_back();
  frame.call = ++calls_;
  for (std::size_t i = 1; i <= kLargestLocal; ++i)
    frame.numbered[i] = i <= arguments.size() ? arguments[i - 1] : 0;
}

void Parameters::enter_macro(const MacroArguments& arguments) {
  Frame& frame = frames_.emplace_back();
  frame.call = ++calls_;
  frame.numbered = arguments;
}

void Parameters::enter() {
  Frame frame;
  frame.call = ++calls_;
  frame.numbered = frames_.back().numbered;
  frame.shares_numbers = true;
  frames_.push_back(std::move(frame));
}

void Parameters::leave() {
  if (frames_.size() < 2) return;
  const Frame left = std::move(frames_.back());
  frames_.pop_back();
  if (left.shares_numbers) frames_.back().numbered = left.numbered;
}

}  // namespace limitgauge::model::gcode
