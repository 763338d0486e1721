#pragma once

#include <string>
#include <string_view>

namespace limitgauge::reports {

/// `bytes` in base64 (RFC 4648, padded), on one line.
std::string base64(std::string_view bytes);

}  // namespace limitgauge::reports
