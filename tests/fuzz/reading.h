#pragma once

#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <string>

#include "model/base/error.h"

namespace limitgauge::fuzz {

inline std::string text_of(const std::uint8_t* data, std::size_t size) {
  return std::string(reinterpret_cast<const char*>(data), size);
}

/// Runs a reader on an input. To refuse it is an answer; every other exception leaves the target,
/// which libFuzzer takes for a crash.
template <class Read>
int answer(Read&& read) {
  try {
    read();
  } catch (const model::InputError&) {
  } catch (const model::ResourceError&) {
  }
  return 0;
}

/// Makes a finding of a result that breaks what its reader promises.
inline void require(bool holds, const char* promise) {
  if (holds) return;
  std::fprintf(stderr, "broken promise: %s\n", promise);
  std::abort();
}

}  // namespace limitgauge::fuzz
