#include "tests/agreement/linuxcnc/kinematics_module.h"

#include <dlfcn.h>

#include <stdexcept>
#include <string>

namespace limitgauge::linuxcnc {
namespace {

/// Flags go both ways and say which of several solutions is meant; these machines have one.
using Flags = unsigned long;

[[noreturn]] void fail(const std::string& what) {
  throw std::runtime_error(what);
}

template <class Function>
Function* symbol(void* library, const char* name) {
  void* address = dlsym(library, name);
  if (address == nullptr) fail(dlerror());
  return reinterpret_cast<Function*>(address);
}

}  // namespace

KinematicsModule::KinematicsModule(const std::filesystem::path& file)
    : library_(dlopen(file.c_str(), RTLD_NOW | RTLD_LOCAL)) {
  if (library_ == nullptr) fail(dlerror());
  if (symbol<int()>(library_, "rtapi_app_main")() != 0) fail("the module does not start");
  // Some ask for their pins only when they are asked this.
  symbol<int()>(library_, "kinematicsType")();
}

void KinematicsModule::switch_to(int type) {
  if (symbol<int(int)>(library_, "kinematicsSwitch")(type) != 0) fail("no kinematics of this type");
}

model::Vec3 KinematicsModule::forward(const Joints& joints) const {
  EmcPose pose{};
  Flags into = 0, out = 0;
  const auto compute =
      symbol<int(const double*, EmcPose*, const Flags*, Flags*)>(library_, "kinematicsForward");
  if (compute(joints.data(), &pose, &into, &out) != 0) fail("no place for these joints");
  return {pose.x, pose.y, pose.z};
}

Joints KinematicsModule::inverse(const EmcPose& pose) const {
  Joints joints{};
  Flags into = 0, out = 0;
  const auto compute =
      symbol<int(const EmcPose*, double*, const Flags*, Flags*)>(library_, "kinematicsInverse");
  if (compute(&pose, joints.data(), &into, &out) != 0) fail("no joints for this place");
  return joints;
}

}  // namespace limitgauge::linuxcnc
