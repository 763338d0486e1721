#include "model/part/stock.h"

#include <limits>
#include <stdexcept>

#include "model/base/error.h"
#include "tests/model/fixture_files.h"
#include "tests/support/catch.h"
#include "tests/support/mesh_shapes.h"

using namespace limitgauge::model;
using namespace limitgauge::model::test;

namespace {

std::string stock_error_of(const std::string& text) {
  return message_of<InputError>([&] { parse_stock(text); });
}

}  // namespace

TEST_CASE("a box by its size and lower corner", "[unit][stock]") {
  const Stock stock = parse_stock("box:90,80,30@-45,-40,-20.5");
  const Box3 box = bounding_box(stock);
  CHECK(box.low == Vec3{-45, -40, -20.5});
  CHECK(box.high == Vec3{45, 40, 9.5});
}

TEST_CASE("the bounding box of a round bar", "[unit][stock]") {
  const Box3 box = bounding_box(CylinderStock{{1, 2, 3}, 10, 20});
  CHECK(box.low == Vec3{-4, -3, 3});
  CHECK(box.high == Vec3{6, 7, 23});
}

TEST_CASE("stock texts that are wrong, each with its column", "[unit][stock]") {
  CHECK(stock_error_of("") == "stock:1:1: error: unknown stock ''; expected 'box:LX,LY,LZ@X,Y,Z'");
  CHECK(stock_error_of("bar:1,2,3@0,0,0") ==
        "stock:1:1: error: unknown stock 'bar'; expected 'box:LX,LY,LZ@X,Y,Z'");
  CHECK(stock_error_of("mesh:part.stl") ==
        "stock:1:1: error: unknown stock 'mesh'; expected 'box:LX,LY,LZ@X,Y,Z'");
  CHECK(stock_error_of("box") ==
        "stock:1:4: error: the box has no size; expected ':LX,LY,LZ@X,Y,Z'");
  CHECK(stock_error_of("box:90") == "stock:1:7: error: the box has no size in Y; expected ','");
  CHECK(stock_error_of("box:90,80") == "stock:1:10: error: the box has no size in Z; expected ','");
  CHECK(stock_error_of("box:90,80,30") ==
        "stock:1:13: error: the box has no lower corner; expected '@'");
  CHECK(stock_error_of("box:90,80,30,5@1,2,3") ==
        "stock:1:13: error: the box has no lower corner; expected '@'");
  CHECK(stock_error_of("box:90,0,30@0,0,0") ==
        "stock:1:8: error: size in Y is 0; expected more than 0");
  CHECK(stock_error_of("box:90,8o,30@0,0,0") ==
        "stock:1:8: error: size in Y '8o' is not a number; expected a number of millimetres or "
        "degrees");
  CHECK(stock_error_of("box:90,80,30@0") == "stock:1:15: error: the corner has no Y; expected ','");
  CHECK(stock_error_of("box:90,80,30@0,0") ==
        "stock:1:17: error: the corner has no Z; expected ','");
  CHECK(stock_error_of("box:90,80,30@0,0,0,0") ==
        "stock:1:18: error: corner Z '0,0' is not a number; expected a number of millimetres or "
        "degrees");
  CHECK_THAT(stock_error_of("box:90,80,inf@0,0,0"), ContainsSubstring("stock:1:11: error"));
}

TEST_CASE("stock of no or unbounded size is refused", "[unit][stock]") {
  const double inf = std::numeric_limits<double>::infinity();
  CHECK_NOTHROW(require_valid(BoxStock{{0, 0, 0}, {1, 1, 1}}));
  CHECK_NOTHROW(require_valid(CylinderStock{{0, 0, 0}, 1, 1}));
  CHECK_THROWS_AS(require_valid(BoxStock{{0, 0, 0}, {1, 0, 1}}), std::invalid_argument);
  CHECK_THROWS_AS(require_valid(BoxStock{{0, inf, 0}, {1, 1, 1}}), std::invalid_argument);
  CHECK_THROWS_AS(require_valid(CylinderStock{{0, 0, 0}, -1, 1}), std::invalid_argument);
  // Beyond 10 m nothing is certified.
  CHECK_NOTHROW(require_valid(BoxStock{{-10000, 0, 0}, {20000, 1, 1}}));
  CHECK_THROWS_WITH(require_valid(BoxStock{{-1, 9000, 0}, {1, 1001, 1}}),
                    ContainsSubstring("reaches to y = 10001 mm; expected at most 10000 mm"));
  CHECK_THROWS_AS(require_valid(CylinderStock{{0, 0, 9999}, 1, 2}), std::invalid_argument);
  CHECK_THROWS_AS(require_valid(CylinderStock{{0, 0, 0}, 1, inf}), std::invalid_argument);
  CHECK_THROWS_AS(require_valid(MeshStock{}), std::invalid_argument);
  auto mesh =
      std::make_shared<TriangleMesh>(limitgauge::tests::block_between({0, 0, 0}, {1, 2, 3}));
  CHECK_NOTHROW(require_valid(MeshStock{mesh, "a.stl", 0}));
  CHECK(bounding_box(MeshStock{mesh, "a.stl", 0}).high == Vec3{1, 2, 3});
  CHECK_THROWS_AS(require_valid(MeshStock{mesh, "a.stl", -1}), std::invalid_argument);
  mesh->triangles.pop_back();
  CHECK_THROWS_AS(require_valid(MeshStock{mesh, "a.stl", 0}), std::invalid_argument);
}
