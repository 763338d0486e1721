#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <variant>

#include "engine/model/vec3.h"

namespace limitgauge::model {

/// Raw stock: an axis-aligned block.
struct BoxStock {
  Vec3 corner_mm;  ///< lower corner
  Vec3 size_mm;
};
/// Raw stock: an upright round bar, axis along +Z.
struct CylinderStock {
  Vec3 base_mm;  ///< centre of the lower face
  double diameter_mm = 0;
  double height_mm = 0;
};

using Stock = std::variant<BoxStock, CylinderStock>;

Box3 bounding_box(const Stock& stock);
/// Throws std::invalid_argument for a zero, negative or non-finite size.
void require_valid(const Stock& stock);
/// `box:LX,LY,LZ@X,Y,Z`: size @ lower corner. Throws InputError with the column in `text`.
Stock parse_stock(std::string_view text);

}  // namespace limitgauge::model
