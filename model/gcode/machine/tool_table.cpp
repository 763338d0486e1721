#include "model/gcode/machine/tool_table.h"

#include <algorithm>

namespace limitgauge::model::gcode {

ToolTable::ToolTable(const MachineSetup& machine) : loaded_(machine.loaded_tool) {
  for (const ToolEntry& entry : machine.tools)
    tools_[entry.number] = {entry.length_mm, entry.diameter_mm, entry.length_mm, 0, 0};
  if (!loaded_ && machine.tools.size() == 1) loaded_ = machine.tools.front().number;
  if (loaded_) load(*loaded_);
  if (machine.tools.empty() && machine.only_tool)
    only_diameter_mm_ = machine.only_tool->diameter_mm;
}

const ToolTable::Tool* ToolTable::find(int tool) const {
  const auto found = tools_.find(tool);
  return found == tools_.end() ? nullptr : &found->second;
}

void ToolTable::load(int tool) {
  loaded_ = tool;
  if (tool == 0) return;
  if (const auto known = length_of(tool)) reach_mm_ = known;
}

std::optional<double> ToolTable::offset_of(int tool) const {
  const Tool* const entry = find(tool);
  if (!entry || !entry->offset_mm) return std::nullopt;
  return *entry->offset_mm + entry->length_wear_mm;
}

std::optional<double> ToolTable::diameter_of(int tool) const {
  const Tool* const entry = find(tool);
  if (entry && entry->diameter_mm) return *entry->diameter_mm + entry->diameter_wear_mm;
  return loaded_.value_or(tool) == tool ? only_diameter_mm_ : std::nullopt;
}

std::optional<double> ToolTable::true_length() const {
  if (!loaded_) return unnamed_length_mm_;
  return *loaded_ == 0 ? reach_mm_.value_or(0) : length_of(*loaded_);
}

std::optional<double> ToolTable::length_of(int tool) const {
  const Tool* const entry = find(tool);
  return entry ? entry->true_length_mm : std::nullopt;
}

bool ToolTable::has_entries_of(const ToolTable& other) const {
  return std::all_of(tools_.begin(), tools_.end(), [&](const auto& entry) {
    const Tool* const tool = other.find(entry.first);
    return entry.second.is_as(tool ? *tool : Tool{});
  });
}

void ToolTable::clear_offset() {
  in_use_ = {};
}

void ToolTable::use_own_length() {
  in_use_ = {true, loaded_, 0};
  any_offset_used_ = true;
}

bool ToolTable::use_offset(double offset_mm) {
  in_use_ = {false, loaded_, offset_mm};
  any_offset_used_ = true;
  if (true_length()) return false;
  if (loaded_) {
    tools_[*loaded_].true_length_mm = offset_mm;
  } else {
    unnamed_length_mm_ = offset_mm;
  }
  reach_mm_ = offset_mm;
  return true;
}

double ToolTable::shift_mm() const {
  if (is_uncertain()) return 0;
  const std::optional<double> length_mm = true_length();
  return in_use_.offset_mm - (in_use_.has_unstated_length ? 0 : length_mm.value_or(0));
}

bool ToolTable::is_uncertain() const {
  if (in_use_.has_unstated_length) return in_use_.owner != loaded_;
  return any_offset_used_ && !true_length();
}

}  // namespace limitgauge::model::gcode
