#include "model/part/stock.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "model/base/coordinate_limit.h"
#include "model/mesh/mesh_defect.h"
#include "model/text/message_text.h"
#include "model/text/number_text.h"
#include "model/text/spec_text.h"

namespace limitgauge::model {
namespace {

void require_finite(const Vec3& point, const char* what) {
  if (!is_finite(point)) throw std::invalid_argument(std::string(what) + " must be finite");
}

void require_size(double size_mm, const char* what) {
  if (!std::isfinite(size_mm) || size_mm <= 0)
    throw std::invalid_argument(std::string(what) + " must be greater than 0");
  if (size_mm < kLeastLengthMm)
    throw std::invalid_argument(std::string(what) + " is " + shortest(size_mm) + " mm; expected " +
                                kLengthExpected);
}

struct Checker {
  void operator()(const BoxStock& box) const {
    require_finite(box.corner_mm, "stock corner");
    for (const int axis : {0, 1, 2}) require_size(box.size_mm[axis], "stock size");
  }
  void operator()(const CylinderStock& bar) const {
    require_finite(bar.base_mm, "stock base");
    require_size(bar.diameter_mm, "stock diameter");
    require_size(bar.height_mm, "stock height");
  }
  void operator()(const MeshStock& stock) const {
    if (stock.mesh == nullptr) throw std::invalid_argument("stock without its mesh");
    if (const auto defect = find_defect(*stock.mesh))
      throw std::invalid_argument("stock mesh: " + defect->wrong);
    if (!std::isfinite(stock.blunt_mm) || stock.blunt_mm < 0)
      throw std::invalid_argument("how far a stock's edges stand out must not be negative");
    if (!std::isfinite(stock.voxel_mm) || stock.voxel_mm < 0)
      throw std::invalid_argument("the voxel of the stock must not be negative");
  }
  void operator()(const LeaningStock& stock) const { std::visit(*this, stock.upright); }
};

struct Bounds {
  Box3 operator()(const BoxStock& box) const {
    return {box.corner_mm, box.corner_mm + box.size_mm};
  }
  Box3 operator()(const CylinderStock& bar) const {
    const double r_mm = bar.diameter_mm / 2;
    return {bar.base_mm - Vec3{r_mm, r_mm, 0}, bar.base_mm + Vec3{r_mm, r_mm, bar.height_mm}};
  }
  Box3 operator()(const MeshStock& stock) const { return bounding_box(*stock.mesh); }
  Box3 operator()(const LeaningStock& stock) const {
    if (const auto* bar = std::get_if<CylinderStock>(&stock.upright))
      return leaning(*bar, stock.pose);
    return stock.pose.box((*this)(std::get<BoxStock>(stock.upright)));
  }

  /// Along a unit axis u a bar of axis a reaches h/2 |u·a| and the rim of its ends r √(1 - (u·a)²).
  static Box3 leaning(const CylinderStock& bar, const Pose& pose) {
    const double r_mm = bar.diameter_mm / 2, half_mm = bar.height_mm / 2;
    const Vec3 axis = pose.direction({0, 0, 1});
    const Vec3 middle = pose.point(bar.base_mm + Vec3{0, 0, half_mm});
    Vec3 half;
    for (const int a : {0, 1, 2})
      half[a] =
          half_mm * std::abs(axis[a]) + r_mm * std::sqrt(std::max(0.0, 1 - axis[a] * axis[a]));
    return {middle - half, middle + half};
  }
};

void read_shape(SpecText& spec) {
  const std::string shape(spec.take_until(":"));
  if (shape != "box") spec.fail_at(0, "unknown stock " + in_quotes(shape), "'box:LX,LY,LZ@X,Y,Z'");
  if (!spec.take(':')) spec.fail_at(spec.position(), "the box has no size", "':LX,LY,LZ@X,Y,Z'");
}

void expect(SpecText& spec, char c, const char* wrong) {
  if (!spec.take(c)) spec.fail_at(spec.position(), wrong, std::string("'") + c + "'");
}

Vec3 read_size(SpecText& spec) {
  Vec3 size_mm;
  size_mm.x = spec.positive(",@", "size in X");
  expect(spec, ',', "the box has no size in Y");
  size_mm.y = spec.positive(",@", "size in Y");
  expect(spec, ',', "the box has no size in Z");
  size_mm.z = spec.positive(",@", "size in Z");
  return size_mm;
}

Vec3 read_corner(SpecText& spec) {
  Vec3 corner_mm;
  corner_mm.x = spec.number(",", "corner X");
  expect(spec, ',', "the corner has no Y");
  corner_mm.y = spec.number(",", "corner Y");
  expect(spec, ',', "the corner has no Z");
  corner_mm.z = spec.number("", "corner Z");
  return corner_mm;
}

struct Turner {
  const Pose& pose;

  Stock operator()(const BoxStock& block) const {
    const Box3 box{block.corner_mm, block.corner_mm + block.size_mm};
    if (!pose.keeps_axes()) return LeaningStock{block, pose};
    const Box3 moved = pose.box(box);
    const Vec3 size = pose.half(block.size_mm);
    return BoxStock{moved.low, size};
  }
  Stock operator()(const CylinderStock& bar) const {
    const Vec3 axis = pose.direction({0, 0, 1});
    if (std::hypot(axis.x, axis.y) != 0) return LeaningStock{bar, pose};
    CylinderStock out = bar;
    out.base_mm = pose.point(axis.z > 0 ? bar.base_mm : bar.base_mm + Vec3{0, 0, bar.height_mm});
    return out;
  }
  Stock operator()(const MeshStock& stock) const {
    MeshStock out = stock;
    out.mesh = std::make_shared<const TriangleMesh>(turned(*stock.mesh, pose));
    return out;
  }
  Stock operator()(const LeaningStock& stock) const {
    return std::visit(Turner{pose * stock.pose}, stock.upright);
  }
};

}  // namespace

Stock turned(const Stock& stock, const Pose& pose) {
  if (pose == Pose{}) return stock;
  return std::visit(Turner{pose}, stock);
}

Stock planned_stock(const Stock& stock) {
  if (std::holds_alternative<BoxStock>(stock) || std::holds_alternative<CylinderStock>(stock))
    return stock;
  const Box3 box = bounding_box(stock);
  return BoxStock{box.low, box.size()};
}

Box3 bounding_box(const Stock& stock) {
  return std::visit(Bounds{}, stock);
}

double blunt_mm(const Stock& stock) {
  const auto* mesh = std::get_if<MeshStock>(&stock);
  return mesh ? mesh->blunt_mm : 0;
}

void require_valid(const Stock& stock) {
  std::visit(Checker{}, stock);
  if (const Box3 box = bounding_box(stock); !is_near(box))
    throw std::invalid_argument("the stock reaches to " + farthest_words(box) + "; expected " +
                                kFarthestExpected);
}

Stock parse_stock(std::string_view text) {
  SpecText spec(text, "stock");
  read_shape(spec);
  BoxStock box;
  box.size_mm = read_size(spec);
  expect(spec, '@', "the box has no lower corner");
  box.corner_mm = read_corner(spec);
  return box;
}

}  // namespace limitgauge::model
