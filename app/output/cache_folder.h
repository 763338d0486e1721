#pragma once

#include <filesystem>

namespace limitgauge::app {

/// Where results are kept between studies: `stated`, or the user's own folder for what can be made
/// again. Makes it. Throws InputError where it cannot be written.
std::filesystem::path cache_folder(const std::filesystem::path& stated);

}  // namespace limitgauge::app
