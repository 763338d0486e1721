#include "model/gcode/text/codes.h"

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
                                GCode{100, GGroup::non_modal},
                                GCode{170, GGroup::plane},
                                GCode{180, GGroup::plane},
                                GCode{190, GGroup::plane},
                                GCode{200, GGroup::units},
                                GCode{210, GGroup::units},
                                GCode{280, GGroup::non_modal},
                                GCode{281, GGroup::non_modal},
                                GCode{300, GGroup::non_modal},
                                GCode{301, GGroup::non_modal},
                                GCode{400, GGroup::radius_offset},
                                GCode{410, GGroup::radius_offset},
                                GCode{411, GGroup::radius_offset},
                                GCode{420, GGroup::radius_offset},
                                GCode{421, GGroup::radius_offset},
                                GCode{430, GGroup::length_offset},
                                GCode{431, GGroup::length_offset},
                                GCode{432, GGroup::length_offset},
                                GCode{490, GGroup::length_offset},
                                GCode{520, GGroup::non_modal},
                                GCode{530, GGroup::non_modal},
                                GCode{540, GGroup::coordinate_system},
                                GCode{541, GGroup::coordinate_system},
                                GCode{550, GGroup::coordinate_system},
                                GCode{560, GGroup::coordinate_system},
                                GCode{570, GGroup::coordinate_system},
                                GCode{580, GGroup::coordinate_system},
                                GCode{590, GGroup::coordinate_system},
                                GCode{591, GGroup::coordinate_system},
                                GCode{592, GGroup::coordinate_system},
                                GCode{593, GGroup::coordinate_system},
                                GCode{610, GGroup::path_control},
                                GCode{611, GGroup::path_control},
                                GCode{640, GGroup::path_control},
                                GCode{730, GGroup::motion},
                                GCode{740, GGroup::motion},
                                GCode{800, GGroup::motion},
                                GCode{810, GGroup::motion},
                                GCode{820, GGroup::motion},
                                GCode{830, GGroup::motion},
                                GCode{840, GGroup::motion},
                                GCode{850, GGroup::motion},
                                GCode{860, GGroup::motion},
                                GCode{870, GGroup::motion},
                                GCode{880, GGroup::motion},
                                GCode{890, GGroup::motion},
                                GCode{900, GGroup::distance},
                                GCode{901, GGroup::arc_distance},
                                GCode{910, GGroup::distance},
                                GCode{911, GGroup::arc_distance},
                                GCode{920, GGroup::non_modal},
                                GCode{921, GGroup::axis_offset},
                                GCode{922, GGroup::axis_offset},
                                GCode{923, GGroup::axis_offset},
                                GCode{930, GGroup::feed_mode},
                                GCode{940, GGroup::feed_mode},
                                GCode{950, GGroup::feed_mode},
                                GCode{960, GGroup::spindle_mode},
                                GCode{970, GGroup::spindle_mode},
                                GCode{980, GGroup::return_level},
                                GCode{990, GGroup::return_level}};

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
  Refusal refusal;
};
constexpr std::string_view kWithout = "a program without it";
constexpr std::string_view kMill = "a program for a mill";
constexpr std::string_view kLines = "G1, G2 or G3";
constexpr std::string_view kFile = "a program that needs no file or device of the machine";
constexpr std::string_view kPocket = "pockets by one word are another control's cycle";
/// Other controls interpolate in polar coordinates by it, and some builds of LinuxCNC's choose
/// among kinematics; its own switch them by remapped M codes ("Switchable Kinematics").
constexpr std::string_view kSwitch =
    "LinuxCNC has no such code; machines whose kinematics are switched have M428 and M429 for it";
constexpr std::array kRefusedG = {
    Refused{50, 53, {"a spline's points depend on the control's own chords", kLines}},
    Refused{60, 63, {"a spline's points depend on the control's own chords", kLines}},
    Refused{70, 80, {"diameters and radii are a lathe's", kMill}},
    Refused{120, 120, {kPocket, kLines}},
    Refused{121, 121, {kSwitch, "M428 or M429"}},
    Refused{130, 130, {kPocket, kLines}},
    Refused{131, 131, {kSwitch, "M428 or M429"}},
    Refused{171, 171, {"its plane is that of the axes U, V and W", "G17, G18 or G19"}},
    Refused{181, 181, {"its plane is that of the axes U, V and W", "G17, G18 or G19"}},
    Refused{191, 191, {"its plane is that of the axes U, V and W", "G17, G18 or G19"}},
    Refused{330, 331, {"it follows the turning spindle, whose pace nothing states", kLines}},
    Refused{382, 385, {"it ends where a probe touches, which no program states", kWithout}},
    Refused{700, 722, {"turning cycles are a lathe's", kMill}},
    Refused{760, 760, {"it follows the turning spindle, whose pace nothing states", kLines}}};
constexpr std::array kRefusedM = {
    Refused{98, 98, {"a call of a subprogram stands alone in its block", "M98 P L"}},
    Refused{99, 99, {"the end of a subprogram stands alone in its block", "M99"}},
    Refused{100, 199, {"it is a command of the machine's owner, which may do anything", kFile}}};

const Refusal* refusal_in(std::span<const Refused> table, int number) {
  for (const Refused& entry : table) {
    if (number >= entry.first && number <= entry.last) return &entry.refusal;
  }
  return nullptr;
}

Refusal refusal_or_none(const Refusal* refusal) {
  return refusal ? *refusal : Refusal{};
}

}  // namespace

std::optional<GGroup> g_group(int tenths) {
  if (tenths < 0 || tenths >= kGCodeCount || kGGroups[tenths] == kNoGroup) return std::nullopt;
  return static_cast<GGroup>(kGGroups[tenths]);
}

std::optional<MGroup> m_group(int number) {
  const auto within = [number](int first, int last) { return number >= first && number <= last; };
  if (within(0, 2) || number == 30 || number == 60) return MGroup::stopping;
  if (within(3, 5) || number == 19) return MGroup::spindle;
  if (number == 6 || number == 61) return MGroup::tool_change;
  if (within(7, 9)) return MGroup::coolant;
  if (within(48, 53)) return MGroup::overrides;
  if (within(62, 68)) return MGroup::input_output;
  if (within(70, 73)) return MGroup::saved_state;
  return std::nullopt;
}

Refusal g_refusal(int tenths) {
  return refusal_or_none(refusal_in(kRefusedG, tenths));
}
Refusal m_refusal(int number) {
  return refusal_or_none(refusal_in(kRefusedM, number));
}

}  // namespace limitgauge::model::gcode
