#pragma once

// What inner loops share that are to be vectorised.
// LIMITGAUGE_WIDE: the same loops for wider registers, chosen at load time. No fused operations in
// any: the results are the same to the last bit.
// LIMITGAUGE_EACH: before a loop whose steps do not depend on each other.
#if defined(__GNUC__) && !defined(__clang__)
#define LIMITGAUGE_EACH _Pragma("GCC ivdep")
#else
#define LIMITGAUGE_EACH
#endif
#if defined(__GNUC__) && !defined(__clang__) && defined(__x86_64__) && defined(__linux__) && \
    !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)
#define LIMITGAUGE_WIDE __attribute__((target_clones("default", "avx2", "arch=x86-64-v4")))
#else
#define LIMITGAUGE_WIDE
#endif

namespace limitgauge::simulator {

/// `t` within [0, 1], by two choices that a register makes for all its numbers.
inline double unit_clamp(double t) {
  t = t > 0 ? t : 0.0;
  return t < 1 ? t : 1.0;
}

}  // namespace limitgauge::simulator
