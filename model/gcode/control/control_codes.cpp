#include "model/gcode/control/control_codes.h"

#include <algorithm>
#include <array>
#include <span>

namespace limitgauge::model::gcode {
namespace {

constexpr CodeRule aside(int first, int last, std::string_view letters = "") {
  return {first, last, CodeUse::set_aside, letters, {}, 0};
}
constexpr CodeRule same(int tenths, int other) {
  return {tenths, tenths, CodeUse::same_as, {}, {}, other};
}
constexpr CodeRule frames(int first, int last) {
  return {first, last, CodeUse::work_frame, {}, {}, 0};
}
constexpr CodeRule refused(int first, int last, std::string_view wrong, std::string_view expected) {
  return {first, last, CodeUse::refused, wrong, expected, 0};
}

constexpr std::string_view kLines = "G0 to G3";
constexpr std::string_view kOff = "a program that states its moves as they are";
constexpr std::string_view kTurned = "it turns, scales or mirrors what follows";
constexpr std::string_view kOriented =
    "it is about the tool's axis, and the machine has no rotary axes ([machine] kinematics), or "
    "this control no such code that is carried out";
constexpr std::string_view kProbe = "it ends where a probe touches, which no program states";
constexpr std::string_view kPallet = "it moves a part of the machine that is not known here";
constexpr std::string_view kNotRead = "a code of this control";

/// Cancels and settings of Fanuc's and Haas's that move nothing, and what they have that is not
/// carried out (B-63684EN, "List of G codes"; Haas 96-8210, "G-Codes").
constexpr std::array kIsoG = {
    refused(21, 29, "it interpolates along another curve", kLines),
    aside(50, 50, "P"),      // G05 P10000: high-speed machining
    aside(51, 51, "QRXYZ"),  // G05.1 Q: look-ahead, smoothing of these axes
    refused(52, 59, "it interpolates along another curve", kLines),
    refused(60, 63, "it interpolates along another curve", kLines),
    aside(80, 80, "P"),  // look-ahead
    aside(90, 90),       // exact stop in this block
    refused(120, 120, "pockets by one word are not carried out", kLines),
    refused(121, 121, "it makes Y an angle: polar coordinate interpolation is not carried out",
            kLines),
    refused(130, 130, "pockets by one word are not carried out", kLines),
    aside(131, 131),  // polar interpolation off
    aside(150, 150),  // polar coordinates off
    refused(160, 160, "it makes X and Y a radius and an angle", kOff),
    aside(230, 230),  // stored stroke check off
    aside(250, 260),  // spindle speed watching
    refused(281, 289, "Fanuc and Haas have no such code", "G28"),
    refused(290, 290, "it goes by a point that only the control remembers", kLines),
    refused(301, 309, "it is no code of this control", "G30"),
    refused(310, 310, kProbe, "a program without it"),
    refused(340, 379, "bolt holes and measuring cycles are not carried out", kLines),
    aside(401, 401),  // normal direction control off
    refused(411, 419, "Fanuc has another meaning for it", "G41 with D"),
    refused(421, 429, "Fanuc has another meaning for it", "G42 with D"),
    refused(431, 439, kOriented, "G43 H"),
    refused(470, 470, "engraved text is the control's own", kLines),
    aside(491, 491),
    aside(500, 501, "XYZ"),  // scaling and mirroring off, of these axes
    refused(510, 511, kTurned, kOff),
    refused(591, 599, "it is no code of this control", "G54 to G59, G54.1 P"),
    refused(600, 600, "it approaches from one side by what a parameter says", kLines),
    aside(611, 630),  // automatic corner override, tapping mode
    refused(660, 669, "a macro at every move is not carried out", "G65 where it is to run"),
    aside(670, 670),  // modal macro off
    refused(680, 681, kTurned, kOff),
    refused(682, 682, kOriented, kOff),
    refused(683, 689, kTurned, kOff),
    aside(690, 690),  // rotation off
    aside(691, 691),
    refused(700, 729, "patterns of holes are not carried out", "each hole's X and Y"),
    refused(760, 760, "fine boring moves aside by what a parameter says", "G85, G86 or G89"),
    refused(770, 779, "it is no code of this control", kLines),
    refused(870, 870, "back boring moves aside by what a parameter says", "G85, G86 or G89"),
    refused(901, 901, "it is no code of this control: I, J and K are always relative", "G90"),
    refused(911, 911, "it is no code of this control: I, J and K are always relative", "G91"),
    refused(921, 923, "it is no code of this control", "G92 or G52 with values"),
    aside(1030, 1030, "P"),  // Haas: limit of look-ahead
    aside(1070, 1070),       // Haas: cylindrical mapping off
    aside(1130, 1130),       // Fanuc: polar interpolation off
    same(1540, 541),         // Haas: G154 P
    refused(1500, 1500, "pockets by a subprogram are not carried out", kLines),
    aside(1600, 1600),        // Fanuc: in-feed control off
    aside(1870, 1870, "PE"),  // Haas: smoothness
    refused(2340, 2340, kOriented, "G43 H"),
    refused(2540, 2540, kOriented, "G54"),
    aside(2550, 2550)};  // Haas: dynamic work offset off

/// Fanuc's words about the tool's axis that Haas has others for (96-8210, "G-Codes").
constexpr std::array kHaasG = {
    refused(434, 435, "it is Fanuc's, and Haas has another word for it", "G234 H"),
    refused(531, 531, "it is Fanuc's, and Haas has another word for it", "A, B or C themselves"),
    refused(682, 689, "it is Fanuc's, and Haas has other words for it", "G254"),
    frames(1100, 1290)};  // the older words for G154 P1 to P20 (96-8210, "G110-G129")

constexpr std::array kIsoM = {
    aside(10, 11),       // clamps of rotary axes
    aside(12, 13, "P"),  // Haas: air through the spindle
    aside(14, 16),
    aside(17, 18),  // orientation off
    refused(20, 28, "it is a function of the machine's builder", "a program without it"),
    aside(29, 29, "S"),  // rigid tapping
    aside(31, 31),
    aside(33, 35),  // chip conveyor, coolant spigot
    refused(36, 39, kPallet, "a program without it"),
    aside(40, 45),  // gears
    aside(46, 46),
    refused(47, 47, "it begins the program again without end", "M30"),
    aside(48, 49),  // overrides
    refused(50, 50, kPallet, "a program without it"),
    aside(51, 58),  // Haas: the user's relays
    refused(59, 60, kPallet, "a program without it"),
    aside(61, 68),  // Haas: the user's relays
    refused(70, 72, "it is no code of this control", kNotRead),
    aside(73, 74),  // Haas: tool air blast
    refused(75, 75, kProbe, "a program without it"),
    aside(76, 77),
    refused(78, 79, kProbe, "a program without it"),
    aside(80, 81),       // doors
    aside(83, 84, "P"),  // air gun
    aside(88, 89),       // coolant through the spindle
    refused(96, 96, "it goes by an input that only the machine knows", "IF and GOTO"),
    refused(97, 97, "a call of a subprogram stands at the end of its block", "M97 P L"),
    refused(109, 109, "it asks the operator", "a program without it"),
    aside(104, 105),
    aside(130, 138)};

/// "Using Mach3Mill", 10.7 and 10.8.
constexpr std::array kMach3G = {aside(150, 150),
                                refused(160, 160, "it makes X and Y a radius and an angle", kOff),
                                aside(500, 500),
                                refused(510, 510, kTurned, kOff),
                                refused(680, 680, kTurned, kOff),
                                aside(690, 690),
                                refused(281, 281, "it homes axes on Mach3", "G28"),
                                refused(310, 310, kProbe, "a program without it")};
constexpr std::array kMach3M = {aside(10, 11, "P"),  // an output of its own
                                refused(47, 47, "it begins the program again without end", "M30"),
                                refused(70, 73, "it is no code of this control", kNotRead)};

/// Codes that RS274/NGC has otherwise, and those of Siemens that move nothing.
constexpr std::array kSiemensG = {
    refused(5000, 5000, "where the machine's own frame lies nothing states", "G54 to G57"),
    aside(90, 90),
    aside(600, 600),
    aside(6010, 6030),
    aside(6410, 6450),
    same(700, 200),
    same(710, 210),
    same(7000, 200),
    same(7100, 210),
    same(1530, 530),
    aside(4500, 4500),
    refused(4510, 4510, "corners by the intersection are not carried out", "G450"),
    aside(3400, 3410),
    aside(2900, 2900),
    aside(4600, 4620)};
constexpr std::array kSiemensM = {same(17, 30), aside(40, 45)};

/// Grbl 1.1, "Supported G-Codes".
constexpr std::array kGrblHas = {0,   10,  20,  30,  40,  100, 170, 180, 190, 200, 210, 280, 281,
                                 300, 301, 382, 383, 384, 385, 400, 431, 490, 530, 540, 550, 560,
                                 570, 580, 590, 610, 800, 900, 910, 911, 920, 921, 930, 940};
constexpr std::array kGrblHasM = {0, 1, 2, 3, 4, 5, 7, 8, 9, 30, 56};
constexpr std::array kSiemensHas = {0,   10,  20,  30,  40,  90,  170, 180, 190, 400,
                                    410, 420, 530, 540, 550, 560, 570, 600, 640, 700,
                                    710, 900, 910, 930, 940, 950, 960, 970};
constexpr std::array kSiemensHasM = {0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 17, 19, 30};

constexpr CodeRule kGrblLacks =
    refused(0, 0, "Grbl has no such code", "a code of Grbl 1.1, or another --control");
constexpr CodeRule kSiemensLacks = refused(0, 0, "it is no code of Siemens's that is read here",
                                           "G0 to G4, G17 to G19, G40 to G42, G53 to "
                                           "G57, G70, G71, G90, G91, G93 to G97");

const CodeRule* rule_in(std::span<const CodeRule> rules, int number) {
  const auto found = std::find_if(rules.begin(), rules.end(), [number](const CodeRule& rule) {
    return number >= rule.first && number <= rule.last;
  });
  return found == rules.end() ? nullptr : &*found;
}

const CodeRule* unless_has(std::span<const int> known, int number, const CodeRule& lacks) {
  return std::find(known.begin(), known.end(), number) == known.end() ? &lacks : nullptr;
}

}  // namespace

const CodeRule* g_rule(Control control, int tenths) {
  switch (control) {
    case Control::haas:
      if (const CodeRule* rule = rule_in(kHaasG, tenths)) return rule;
      return rule_in(kIsoG, tenths);
    case Control::fanuc:
      return rule_in(kIsoG, tenths);
    case Control::mach3:
      return rule_in(kMach3G, tenths);
    case Control::grbl:
      return unless_has(kGrblHas, tenths, kGrblLacks);
    case Control::siemens:
      if (const CodeRule* rule = rule_in(kSiemensG, tenths)) return rule;
      return unless_has(kSiemensHas, tenths, kSiemensLacks);
    case Control::linuxcnc:
      break;
  }
  return nullptr;
}

std::optional<RotaryCode> rotary_code(Control control, int tenths) {
  // Fanuc's words, and those that LinuxCNC's remapping configurations took over from it; Haas has
  // others for the same (96-8210: G234, G254, G268).
  const bool has_plane = control == Control::fanuc || control == Control::linuxcnc;
  switch (tenths) {
    case 434:
    case 435:
      return control == Control::fanuc ? std::optional(RotaryCode{GGroup::length_offset, tenths})
                                       : std::nullopt;
    case 531:
      return has_plane ? std::optional(RotaryCode{GGroup::non_modal, tenths}) : std::nullopt;
    case 682:
    case 690:
      return has_plane ? std::optional(RotaryCode{GGroup::working_plane, tenths}) : std::nullopt;
    case 2340:
      return control == Control::haas ? std::optional(RotaryCode{GGroup::length_offset, 434})
                                      : std::nullopt;
    case 2540:
    case 2550:
      return control == Control::haas ? std::optional(RotaryCode{GGroup::dynamic_offset, tenths})
                                      : std::nullopt;
    default:
      return std::nullopt;
  }
}

bool is_kinematics_switch(Control control, int number) {
  return control == Control::linuxcnc && number >= 428 && number <= 430;
}

const CodeRule* m_rule(Control control, int number) {
  switch (control) {
    case Control::fanuc:
    case Control::haas:
      return rule_in(kIsoM, number);
    case Control::mach3:
      return rule_in(kMach3M, number);
    case Control::grbl:
      return unless_has(kGrblHasM, number, kGrblLacks);
    case Control::siemens:
      if (const CodeRule* rule = rule_in(kSiemensM, number)) return rule;
      return unless_has(kSiemensHasM, number, kSiemensLacks);
    case Control::linuxcnc:
      break;
  }
  return nullptr;
}

}  // namespace limitgauge::model::gcode
