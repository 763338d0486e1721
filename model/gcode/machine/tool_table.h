#pragma once

#include <map>
#include <optional>

#include "model/machine/machine_setup.h"

namespace limitgauge::model::gcode {

/// The tools' lengths and the length offset in use. What H asks for is the machine's table, which
/// G10 L1 changes; how long the tools truly are, only the machine states. Where it does not, a
/// tool is taken to be as long as the first offset of its own that the program uses.
class ToolTable {
 public:
  static constexpr std::size_t kMostTools = 1000;  ///< LinuxCNC's

  explicit ToolTable(const MachineSetup& machine);

  /// The number of the tool in the spindle (0: it is empty), or nothing where none is stated.
  std::optional<int> loaded() const { return loaded_; }
  void load(int tool);  ///< M6, M61
  std::optional<double> offset_of(int tool) const;
  std::optional<double> diameter_of(int tool) const;
  /// Of the tool in the spindle; what reach() says, or 0, where it is empty.
  std::optional<double> true_length() const;
  /// Where its tip is taken to be below the spindle: by the true length of the tool in it or, where
  /// that is not known or the spindle is empty, of the last one before whose is.
  std::optional<double> reach() const { return reach_mm_; }
  std::optional<double> length_of(int tool) const;  ///< true, stated or taken from its offset
  bool is_full() const { return tools_.size() >= kMostTools; }
  void set_offset(int tool, double length_mm) { tools_[tool].offset_mm = length_mm; }
  /// Wear adds to a length and to a diameter.
  void set_length_wear(int tool, double wear_mm) { tools_[tool].length_wear_mm = wear_mm; }
  void set_diameter_wear(int tool, double wear_mm) { tools_[tool].diameter_wear_mm = wear_mm; }
  void set_diameter(int tool, double diameter_mm) { tools_[tool].diameter_mm = diameter_mm; }

  /// Whether its entries are those of `other`.
  bool has_entries_of(const ToolTable& other) const;

  void clear_offset();  ///< G49
  /// G43 with the tool's own number, its length not stated: programmed heights are the tip's.
  void use_own_length();
  /// G43, G43.1. Where the tool's length is not stated, it is taken to be this: returns true then.
  bool use_offset(double offset_mm);
  void add_offset(double offset_mm) { in_use_.offset_mm += offset_mm; }  ///< G43.2

  /// Length offset in use less the tool's true length; 0 where neither is stated.
  double shift_mm() const;
  /// Whether the offset in use belongs to another tool while a length is not stated: nobody knows
  /// where the tip is then.
  bool is_uncertain() const;
  /// Whether there is an offset in use, and not one of 0.
  bool has_offset_in_use() const { return in_use_.has_unstated_length || in_use_.offset_mm != 0; }

 private:
  struct Tool {
    std::optional<double> offset_mm, diameter_mm, true_length_mm;
    double length_wear_mm = 0, diameter_wear_mm = 0;
    /// But for what a tool that nothing stated was taken to measure.
    bool is_as(const Tool& other) const {
      return offset_mm == other.offset_mm && diameter_mm == other.diameter_mm &&
             length_wear_mm == other.length_wear_mm && diameter_wear_mm == other.diameter_wear_mm;
    }
  };
  struct InUse {
    bool has_unstated_length = false;  ///< of tool `owner`, beside `offset_mm`
    std::optional<int> owner;
    double offset_mm = 0;
  };
  const Tool* find(int tool) const;

  std::map<int, Tool> tools_;
  std::optional<double> only_diameter_mm_;  ///< of whatever tool is loaded, where all are one
  std::optional<int> loaded_;
  std::optional<double> reach_mm_;
  std::optional<double> unnamed_length_mm_;  ///< of the tool in the spindle where none is named
  InUse in_use_;
  bool any_offset_used_ = false;
};

}  // namespace limitgauge::model::gcode
