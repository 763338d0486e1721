#include "tests/agreement/linuxcnc/hal.h"

#include <array>
#include <cstdarg>
#include <cstddef>
#include <cstdio>
#include <map>
#include <memory>
#include <stdexcept>
#include <vector>

namespace limitgauge::linuxcnc {
namespace {

/// Modules are C and hold no handle on who loaded them, so there is one of these.
struct Hal {
  std::map<std::string, std::unique_ptr<double>> numbers;
  std::vector<std::unique_ptr<std::max_align_t[]>> memory;
};

Hal& hal() {
  static Hal one;
  return one;
}

std::string formatted(const char* format, va_list values) {
  std::array<char, 256> text{};
  std::vsnprintf(text.data(), text.size(), format, values);
  return text.data();
}

/// Memory that lives as long as the program, all zero.
void* zeroed(std::size_t bytes) {
  auto& memory = hal().memory;
  memory.push_back(std::make_unique<std::max_align_t[]>(bytes / sizeof(std::max_align_t) + 1));
  return memory.back().get();
}

}  // namespace

double& pin(const std::string& name) {
  const auto found = hal().numbers.find(name);
  if (found == hal().numbers.end()) throw std::out_of_range("no module has a pin " + name);
  return *found->second;
}

}  // namespace limitgauge::linuxcnc

using limitgauge::linuxcnc::formatted;
using limitgauge::linuxcnc::hal;
using limitgauge::linuxcnc::zeroed;

// Modules find these in the program that loads them. They return 0 where all is well; components
// have numbers above that. Names and signatures are LinuxCNC's.
extern "C" {

int hal_init(const char* /*name*/) {
  return 1;
}

int hal_ready(int /*component*/) {
  return 0;
}

int hal_set_unready(int /*component*/) {
  return 0;
}

int hal_exit(int /*component*/) {
  return 0;
}

void* hal_malloc(long bytes) {
  return zeroed(static_cast<std::size_t>(bytes));
}

int hal_pin_float_newf(int /*direction*/, double** at, int /*component*/, const char* format, ...) {
  va_list values;
  va_start(values, format);
  auto& number = hal().numbers[formatted(format, values)];
  va_end(values);
  number = std::make_unique<double>(0);
  *at = number.get();
  return 0;
}

// Whole numbers and switches tell which kinematics are on, which nobody here asks.
int hal_pin_bit_new(const char* /*name*/, int /*direction*/, void** at, int /*component*/) {
  *at = zeroed(sizeof(double));
  return 0;
}

int hal_pin_s32_new(const char* /*name*/, int /*direction*/, void** at, int /*component*/) {
  *at = zeroed(sizeof(double));
  return 0;
}

int hal_pin_s32_newf(int /*direction*/, void** at, int /*component*/, const char* /*format*/, ...) {
  *at = zeroed(sizeof(double));
  return 0;
}

void rtapi_print(const char* /*format*/, ...) {}

/// What is told at level 1 is an error.
void rtapi_print_msg(int level, const char* format, ...) {
  if (level > 1) return;
  va_list values;
  va_start(values, format);
  std::vfprintf(stderr, format, values);
  va_end(values);
}

int rtapi_snprintf(char* text, unsigned long size, const char* format, ...) {
  va_list values;
  va_start(values, format);
  const int count = std::vsnprintf(text, size, format, values);
  va_end(values);
  return count;
}
}
