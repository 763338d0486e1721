#include "tests/agreement/linuxcnc/known_modules.h"

#include <string>

#include "tests/agreement/linuxcnc/hal.h"

namespace limitgauge::linuxcnc {
namespace {

using model::MachineKind;
using model::Vec3;

double drawn(std::mt19937_64& random, double low, double high) {
  return std::uniform_real_distribution<>(low, high)(random);
}

double set(const std::string& name, double value) {
  return pin(name) = value;
}

/// Where the rotary axes meet but for their offset; the carried axis goes through it.
Vec3 set_centre(const std::string& module, std::mt19937_64& random) {
  return {set(module + ".x-rot-point", drawn(random, -400, 400)),
          set(module + ".y-rot-point", drawn(random, -400, 400)),
          set(module + ".z-rot-point", drawn(random, -400, 400))};
}

/// A tilts the table C by a right-handed turn of the workpiece, and runs beside C's centre by the
/// offsets in Y and Z.
Case draw_xyzac(std::mt19937_64& random) {
  const std::string module = "xyzac-trt-kins";
  const Vec3 centre = set_centre(module, random);
  const Vec3 beside{0, set(module + ".y-offset", drawn(random, -80, 80)),
                    set(module + ".z-offset", drawn(random, -80, 80))};
  return {{MachineKind::table_table, {{'A', {1, 0, 0}, centre + beside}, {'C', {0, 0, 1}, centre}}},
          set(module + ".tool-offset", drawn(random, 0, 200))};
}

/// As before, with B and an offset in X.
Case draw_xyzbc(std::mt19937_64& random) {
  const std::string module = "xyzbc-trt-kins";
  const Vec3 centre = set_centre(module, random);
  const Vec3 beside{set(module + ".x-offset", drawn(random, -80, 80)), 0,
                    set(module + ".z-offset", drawn(random, -80, 80))};
  return {{MachineKind::table_table, {{'B', {0, 1, 0}, centre + beside}, {'C', {0, 0, 1}, centre}}},
          set(module + ".tool-offset", drawn(random, 0, 200))};
}

/// B carries A, both as on paper: the tool turns right-handed as seen from the workpiece, the
/// workpiece left-handed. A lies above B by the offset in Z; that in X changes nothing.
Case draw_xyzab(std::mt19937_64& random) {
  const std::string module = "xyzab_tdr_kins";
  const Vec3 centre = set_centre(module, random);
  set(module + ".x-offset", drawn(random, -80, 80));
  const Vec3 above{0, 0, set(module + ".z-offset", drawn(random, -80, 80))};
  return {
      {MachineKind::table_table, {{'B', {0, -1, 0}, centre}, {'A', {-1, 0, 0}, centre + above}}},
      set(module + ".tool-offset-z", drawn(random, 0, 200))};
}

/// C carries B; both run through the pivot, straight above the tool. B tilts the tool to -X as it
/// grows, a left-handed turn. The pin counts the pivot's height from the tip.
Case draw_5axis(std::mt19937_64& random) {
  const Vec3 pivot{0, 0, drawn(random, 0, 400)};
  const double tool_length_mm = drawn(random, 0, 200);
  set("5axiskins.pivot-length", pivot.z + tool_length_mm);
  return {{MachineKind::head_head, {{'C', {0, 0, 1}, pivot}, {'B', {0, -1, 0}, pivot}}},
          tool_length_mm};
}

}  // namespace

const std::vector<KnownModule>& known_modules() {
  static const std::vector<KnownModule> modules{{"xyzac-trt-kins", 0, "AC", draw_xyzac},
                                                {"xyzbc-trt-kins", 0, "BC", draw_xyzbc},
                                                {"xyzab_tdr_kins", 1, "AB", draw_xyzab},
                                                {"5axiskins", 0, "BCW", draw_5axis}};
  return modules;
}

}  // namespace limitgauge::linuxcnc
