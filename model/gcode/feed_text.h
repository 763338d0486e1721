#pragma once

#include <string>

namespace limitgauge::model {

/// A feed rate in fixed notation that reads back as the same float.
std::string feed_text(float feed_mm_min);

}  // namespace limitgauge::model
