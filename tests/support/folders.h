#pragma once

#include <filesystem>

namespace limitgauge::tests {

/// The folder fixtures/ of the source tree. Only folders.cpp knows where that is, so that no other
/// object of the tests depends on it.
const std::filesystem::path& fixtures();

}  // namespace limitgauge::tests
