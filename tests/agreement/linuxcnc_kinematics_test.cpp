// Poses against LinuxCNC's own kinematics modules, where they are installed (Debian's
// linuxcnc-uspace), or unpacked into the folder LIMITGAUGE_LINUXCNC_MODULES. The modules are loaded
// as they are; what they ask of the hardware layer (HAL) stands here.
#include <dlfcn.h>

#include <algorithm>
#include <cstdarg>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <deque>
#include <filesystem>
#include <map>
#include <random>
#include <string>

#include "model/part/kinematics.h"
#include "tests/support/catch.h"

namespace limitgauge::agreement {
namespace {

/// The pins that a module has asked for, by name; its parameters are set through them.
struct Pins {
  std::deque<double> values;
  std::deque<std::int32_t> numbers;
  std::map<std::string, double*> by_name;
};

Pins& pins() {
  static Pins all;
  return all;
}

}  // namespace
}  // namespace limitgauge::agreement

extern "C" {
int hal_init(const char*) {
  return 1;
}
int hal_exit(int) {
  return 0;
}
int hal_ready(int) {
  return 0;
}
int hal_set_unready(int) {
  return 0;
}
void* hal_malloc(long size) {
  return std::calloc(1, static_cast<std::size_t>(size));
}
int hal_pin_float_newf(int, double** pin, int, const char* format, ...) {
  char name[200];
  va_list arguments;
  va_start(arguments, format);
  std::vsnprintf(name, sizeof name, format, arguments);
  va_end(arguments);
  auto& pins = limitgauge::agreement::pins();
  *pin = &pins.values.emplace_back(0.0);
  pins.by_name[name] = *pin;
  return 0;
}
int hal_pin_bit_new(const char*, int, void** pin, int) {
  *pin = &limitgauge::agreement::pins().numbers.emplace_back(0);
  return 0;
}
int hal_pin_s32_new(const char*, int, void** pin, int) {
  *pin = &limitgauge::agreement::pins().numbers.emplace_back(0);
  return 0;
}
int hal_pin_s32_newf(int, void** pin, int, const char*, ...) {
  *pin = &limitgauge::agreement::pins().numbers.emplace_back(0);
  return 0;
}
void rtapi_print(const char*, ...) {}
void rtapi_print_msg(int, const char*, ...) {}
int rtapi_snprintf(char* out, unsigned long size, const char* format, ...) {
  va_list arguments;
  va_start(arguments, format);
  const int length = std::vsnprintf(out, size, format, arguments);
  va_end(arguments);
  return length;
}
}

namespace limitgauge::agreement {
namespace {

using model::Kinematics;
using model::MachineKind;
using model::RotaryAngles;
using model::Vec3;

/// LinuxCNC's EmcPose.
struct ModulePose {
  double x, y, z, a, b, c, u, v, w;
};

std::filesystem::path modules_folder() {
  const char* const stated = std::getenv("LIMITGAUGE_LINUXCNC_MODULES");
  return stated != nullptr ? stated : "/usr/lib/linuxcnc/modules";
}

/// One module; it stays loaded.
class Module {
 public:
  explicit Module(const std::string& name, int type) {
    handle_ = ::dlopen((modules_folder() / (name + ".so")).c_str(), RTLD_NOW | RTLD_LOCAL);
    INFO((handle_ != nullptr ? "" : ::dlerror()));
    REQUIRE(handle_ != nullptr);
    pins() = {};
    REQUIRE(function<int()>("rtapi_app_main")() == 0);
    function<int()>("kinematicsType")();
    REQUIRE(function<int(int)>("kinematicsSwitch")(type) == 0);
    by_name_ = pins().by_name;
  }

  double& pin(const std::string& name) const {
    for (const auto& [whole, value] : by_name_)
      if (whole.ends_with("." + name)) return *value;
    FAIL("no pin " << name);
    return *by_name_.begin()->second;
  }
  ModulePose forward(const double* joints) const {
    unsigned long forward_flags = 0, inverse_flags = 0;
    ModulePose pose{};
    using Forward = int(const double*, ModulePose*, const unsigned long*, unsigned long*);
    REQUIRE(function<Forward>("kinematicsForward")(joints, &pose, &forward_flags, &inverse_flags) ==
            0);
    return pose;
  }

 private:
  template <typename Function>
  Function* function(const char* name) const {
    return reinterpret_cast<Function*>(::dlsym(handle_, name));
  }

  void* handle_ = nullptr;
  std::map<std::string, double*> by_name_;
};

constexpr int kPositions = 100'000;
/// On machines of a metre, in double precision.
constexpr double kSamePose_mm = 1e-9;

class Draws {
 public:
  double place() { return place_(random_); }
  double angle() { return angle_(random_); }

 private:
  std::mt19937_64 random_{17};
  std::uniform_real_distribution<> place_{-400, 400}, angle_{-200, 200};
};

/// `joints` makes a position of the module's joints of what is drawn, and gives the same to
/// `stand`. The module counts tips without the tool's length, which it takes off by itself.
template <typename MachineOf>
void compare(const Module& module, std::size_t first, std::size_t second,
             const MachineOf& machine_of) {
  Draws draws;
  double worst_mm = 0;
  for (int n = 0; n < kPositions; ++n) {
    double length_mm = 0;
    // Parameters change every thousand positions.
    constexpr int kOfOneMachine = 1000;
    static Kinematics machine;
    static double length_of_machine_mm = 0;
    if (n % kOfOneMachine == 0) machine = machine_of(module, draws, length_of_machine_mm);
    length_mm = length_of_machine_mm;
    double joints[16] = {draws.place(), draws.place(), draws.place(), draws.angle(), draws.angle()};
    RotaryAngles angles{};
    angles[first] = joints[3], angles[second] = joints[4];
    const ModulePose pose = module.forward(joints);
    const auto stand = machine.stand({joints[0], joints[1], joints[2]}, angles, length_mm);
    const double off_mm = distance(stand.tip_mm, Vec3{pose.x, pose.y, pose.z - length_mm});
    CAPTURE(n, off_mm, joints[0], joints[3], joints[4], pose.x, pose.y, pose.z);
    REQUIRE(off_mm < kSamePose_mm);  // no number fails as well
    worst_mm = std::max(worst_mm, off_mm);
  }
  INFO("worst " << worst_mm << " mm");
  // Two evaluations in floating point: to agree to the bit they would have to be one.
  CHECK(worst_mm > 0);
}

Vec3 rotary_point(const Module& module, Draws& draws) {
  module.pin("x-rot-point") = draws.place();
  module.pin("y-rot-point") = draws.place();
  module.pin("z-rot-point") = draws.place();
  return {module.pin("x-rot-point"), module.pin("y-rot-point"), module.pin("z-rot-point")};
}

bool installed(const char* module) {
  return std::filesystem::exists(modules_folder() / (std::string(module) + ".so"));
}

}  // namespace

TEST_CASE("poses are those of LinuxCNC's trunnions", "[property]") {
  if (!installed("xyzac-trt-kins")) {
    WARN("skipped: LinuxCNC's kinematics modules are not installed");
    return;
  }
  compare(Module("xyzac-trt-kins", 0), 0, 2,
          [](const Module& module, Draws& draws, double& length) {
            const Vec3 p = rotary_point(module, draws);
            const double y = module.pin("y-offset") = draws.place();
            const double z = module.pin("z-offset") = draws.place();
            length = module.pin("tool-offset") = std::abs(draws.place());
            return Kinematics{MachineKind::table_table,
                              {{'A', {1, 0, 0}, {0, p.y + y, p.z + z}}, {'C', {0, 0, 1}, p}}};
          });
  compare(Module("xyzbc-trt-kins", 0), 1, 2,
          [](const Module& module, Draws& draws, double& length) {
            const Vec3 p = rotary_point(module, draws);
            const double x = module.pin("x-offset") = draws.place();
            const double z = module.pin("z-offset") = draws.place();
            length = module.pin("tool-offset") = std::abs(draws.place());
            return Kinematics{MachineKind::table_table,
                              {{'B', {0, 1, 0}, {p.x + x, 0, p.z + z}}, {'C', {0, 0, 1}, p}}};
          });
}

TEST_CASE("poses are those of LinuxCNC's dual rotary table", "[property]") {
  if (!installed("xyzab_tdr_kins")) {
    WARN("skipped: LinuxCNC's kinematics modules are not installed");
    return;
  }
  compare(Module("xyzab_tdr_kins", 1), 0, 1,
          [](const Module& module, Draws& draws, double& length) {
            const Vec3 p = rotary_point(module, draws);
            const double z = module.pin("z-offset") = draws.place();
            length = module.pin("tool-offset-z") = std::abs(draws.place());
            return Kinematics{MachineKind::table_table,
                              {{'B', {0, -1, 0}, p}, {'A', {-1, 0, 0}, {0, p.y, p.z + z}}}};
          });
}

TEST_CASE("poses are those of LinuxCNC's swivelling head", "[property]") {
  if (!installed("5axiskins")) {
    WARN("skipped: LinuxCNC's kinematics modules are not installed");
    return;
  }
  // The pivot's length there is that from the axis to the tip.
  compare(Module("5axiskins", 0), 1, 2, [](const Module& module, Draws& draws, double& length) {
    const double pivot = std::abs(draws.place());
    length = std::abs(draws.place());
    module.pin("pivot-length") = pivot + length;
    return Kinematics{MachineKind::head_head,
                      {{'C', {0, 0, 1}, {}}, {'B', {0, -1, 0}, {0, 0, pivot}}}};
  });
}

}  // namespace limitgauge::agreement
