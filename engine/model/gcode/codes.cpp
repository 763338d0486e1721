#include "engine/model/gcode/codes.h"

#include <array>
#include <span>

namespace limitgauge::model::gcode {
namespace {

struct GCode {
  int tenths;
  GGroup group;
};
constexpr std::array kGCodes = {GCode{0, GGroup::motion},
                                GCode{10, GGroup::motion},
                                GCode{20, GGroup::motion},
                                GCode{30, GGroup::motion},
                                GCode{40, GGroup::non_modal},
                                GCode{170, GGroup::plane},
                                GCode{180, GGroup::plane},
                                GCode{190, GGroup::plane},
                                GCode{200, GGroup::units},
                                GCode{210, GGroup::units},
                                GCode{400, GGroup::radius_offset},
                                GCode{490, GGroup::length_offset},
                                GCode{540, GGroup::coordinate_system},
                                GCode{610, GGroup::path_control},
                                GCode{611, GGroup::path_control},
                                GCode{640, GGroup::path_control},
                                GCode{800, GGroup::motion},
                                GCode{900, GGroup::distance},
                                GCode{901, GGroup::arc_distance},
                                GCode{910, GGroup::distance},
                                GCode{911, GGroup::arc_distance},
                                GCode{940, GGroup::feed_mode}};

constexpr int kGCodeCount = 1000;
constexpr auto kNoGroup = static_cast<std::uint8_t>(GGroup::count);

/// Groups by code, since every word of a long program asks.
constexpr std::array<std::uint8_t, kGCodeCount> g_groups() {
  std::array<std::uint8_t, kGCodeCount> groups{};
  groups.fill(kNoGroup);
  for (const GCode& code : kGCodes) groups[code.tenths] = static_cast<std::uint8_t>(code.group);
  return groups;
}
constexpr std::array<std::uint8_t, kGCodeCount> kGGroups = g_groups();

struct Refused {
  int first, last;
  std::string_view meaning;
};
constexpr std::array kRefusedG = {Refused{50, 53, "splines"},
                                  Refused{60, 63, "splines"},
                                  Refused{70, 80, "lathe diameter mode"},
                                  Refused{100, 100, "setting offsets"},
                                  Refused{171, 171, "planes of U, V, W"},
                                  Refused{181, 181, "planes of U, V, W"},
                                  Refused{191, 191, "planes of U, V, W"},
                                  Refused{280, 281, "return to a stored position"},
                                  Refused{300, 301, "return to a stored position"},
                                  Refused{330, 331, "spindle-synchronised motion"},
                                  Refused{380, 385, "probing"},
                                  Refused{410, 421, "cutter radius compensation"},
                                  Refused{430, 432, "tool length offset"},
                                  Refused{520, 520, "local coordinate system"},
                                  Refused{530, 530, "motion in machine coordinates"},
                                  Refused{550, 593, "work offsets other than G54"},
                                  Refused{700, 722, "lathe cycles"},
                                  Refused{730, 760, "canned cycles"},
                                  Refused{810, 890, "canned cycles"},
                                  Refused{920, 923, "axis offsets"},
                                  Refused{930, 930, "inverse time feed"},
                                  Refused{950, 950, "feed per revolution"},
                                  Refused{960, 970, "spindle speed modes"},
                                  Refused{980, 990, "return levels of canned cycles"}};
constexpr std::array kRefusedM = {Refused{19, 19, "spindle orientation"},
                                  Refused{48, 53, "override switches"},
                                  Refused{60, 60, "pallet change"},
                                  Refused{61, 61, "setting the tool number"},
                                  Refused{62, 68, "digital and analog input and output"},
                                  Refused{70, 73, "saving modal state"},
                                  Refused{98, 99, "subprograms"},
                                  Refused{100, 199, "user-defined commands"}};

std::string_view meaning_in(std::span<const Refused> table, int number) {
  for (const Refused& entry : table) {
    if (number >= entry.first && number <= entry.last) return entry.meaning;
  }
  return {};
}

}  // namespace

std::optional<GGroup> g_group(int tenths) {
  if (tenths < 0 || tenths >= kGCodeCount || kGGroups[tenths] == kNoGroup) return std::nullopt;
  return static_cast<GGroup>(kGGroups[tenths]);
}

std::optional<MGroup> m_group(int number) {
  if (number == 30 || (number >= 0 && number <= 2)) return MGroup::stopping;
  if (number >= 3 && number <= 5) return MGroup::spindle;
  if (number == 6) return MGroup::tool_change;
  if (number >= 7 && number <= 9) return MGroup::coolant;
  return std::nullopt;
}

std::string_view refused_g_meaning(int tenths) {
  return meaning_in(kRefusedG, tenths);
}
std::string_view refused_m_meaning(int number) {
  return meaning_in(kRefusedM, number);
}

}  // namespace limitgauge::model::gcode
