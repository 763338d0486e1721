#pragma once

#include <cstddef>

namespace limitgauge::app {

/// What a terminal allows, by the values of the environment variables NO_COLOR and TERM (null where
/// they are not set).
bool may_colour(bool is_terminal, const char* no_color, const char* term);
/// Whether a line may be drawn again in its place.
bool may_redraw(bool is_terminal, const char* term);

/// Columns of the terminal behind a descriptor as it is now; `otherwise` where there is none or it
/// does not say.
std::size_t columns_of(int descriptor, std::size_t otherwise);

}  // namespace limitgauge::app
