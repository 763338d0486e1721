#pragma once

#include <string>
#include <string_view>

#include "reports/picture/image.h"

namespace limitgauge::reports {

/// The picture as a PNG file. The same picture gives the same bytes.
std::string png_bytes(const Image& image);
/// The picture as a PNG of at most 256 colours, chosen for it: about a third of the size of all its
/// colours, and no difference that is seen in a map or a shaded view. The same picture gives the
/// same bytes.
std::string palette_png(const Image& image);
/// A PNG file read back. Throws std::runtime_error for bytes that are none.
Image read_png(std::string_view bytes);

}  // namespace limitgauge::reports
