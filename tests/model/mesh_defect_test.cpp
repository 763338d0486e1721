#include "model/mesh/mesh_defect.h"

#include <limits>

#include "tests/support/catch.h"
#include "tests/support/mesh_shapes.h"

using namespace limitgauge::model;
using namespace limitgauge::tests;

namespace {

std::string wrong(const TriangleMesh& mesh) {
  const auto defect = find_defect(mesh);
  return defect ? defect->wrong : "nothing";
}

const TriangleMesh kCube = block_between({0, 0, 0}, {1, 1, 1});

}  // namespace

TEST_CASE("meshes that bound a solid", "[unit][mesh]") {
  CHECK(wrong(kCube) == "nothing");
  CHECK(wrong(hollow_block(2, 1)) == "nothing");
  CHECK(wrong(sphere_mesh({0, 0, 0}, 5, 12, 17)) == "nothing");
  TriangleMesh two = kCube;
  append_mesh(two, block_between({0.5, 0.5, 0.5}, {3, 3, 3}));
  CHECK(wrong(two) == "nothing");
}

TEST_CASE("a cavity lies in a body, not only in its box", "[unit][mesh]") {
  // An L: a block and a post on it that share a whole face's outline are one solid here, by
  // overlapping. In the notch beside the post there is air.
  TriangleMesh in_notch = block_between({0, 0, 0}, {10, 10, 2});
  append_mesh(in_notch, block_between({0, 0, 0}, {2, 10, 10}));
  TriangleMesh in_body = in_notch;
  append_mesh(in_notch, inside_out(block_between({5, 5, 5}, {7, 7, 7})));
  append_mesh(in_body, inside_out(block_between({5, 5, 0.5}, {7, 7, 1.5})));
  CHECK(wrong(in_body) == "nothing");
  // That box holds it, but no solid does: the ring of a frame about its opening.
  TriangleMesh frame = hollow_block(10, 9);
  CHECK(wrong(frame) == "nothing");
  TriangleMesh in_hollow = frame;
  append_mesh(in_hollow, block_between({-1, -1, -1}, {1, 1, 1}));
  CHECK(wrong(in_hollow) == "nothing");
  const TriangleMesh sphere = sphere_mesh({0, 0, 0}, 5, 12, 17);
  TriangleMesh in_corner = sphere;
  append_mesh(in_corner, inside_out(block_between({4, 4, 4}, {4.5, 4.5, 4.5})));
  CHECK(wrong(in_corner) == "the shell of this triangle is inside out and no cavity of another");
  CHECK(find_defect(in_corner)->triangle == sphere.triangles.size());
  TriangleMesh through = sphere;
  append_mesh(through, inside_out(block_between({-1, -1, 3}, {1, 1, 9})));
  CHECK(wrong(through) == "the shell of this triangle is inside out and no cavity of another");
  TriangleMesh well_inside = sphere;
  append_mesh(well_inside, inside_out(sphere_mesh({1, 0, 0}, 3, 9, 8)));
  CHECK(wrong(well_inside) == "nothing");
  CHECK(wrong(in_notch) == "the shell of this triangle is inside out and no cavity of another");
}

TEST_CASE("cubes that share an edge, which four triangles then have", "[unit][mesh]") {
  // The second cube's low edge along Z is the first one's high edge.
  TriangleMesh two = kCube;
  append_mesh(two, block_between({1, 1, 0}, {2, 2, 1}));
  for (auto& t : two.triangles)
    for (auto& v : t)
      if (v == 8)
        v = 3;
      else if (v == 12)
        v = 7;
  CHECK(wrong(two) == "nothing");
}

TEST_CASE("meshes that bound none, and the first triangle where that shows", "[unit][mesh]") {
  CHECK(wrong({}) == "the mesh has no triangles");
  TriangleMesh mesh = kCube;
  mesh.triangles[4][1] = 8;
  CHECK(wrong(mesh) == "there is no vertex 8");
  CHECK(find_defect(mesh)->triangle == 4);
  mesh = kCube;
  mesh.vertices[7].y = std::numeric_limits<double>::quiet_NaN();
  CHECK(wrong(mesh) == "a coordinate is not a finite number");
  CHECK(find_defect(mesh)->triangle == 2);
  mesh = kCube;
  mesh.vertices[7].y = 2e6;
  CHECK(wrong(mesh) == "the vertex (1, 2e+06, 1) is more than 1 km off");
  mesh = kCube;
  mesh.triangles.pop_back();
  CHECK(wrong(mesh) == "the edge (1, 0, 1) to (1, 1, 1) has one triangle only");
  CHECK(find_defect(mesh)->triangle == 2);
  mesh = kCube;
  std::swap(mesh.triangles[7][0], mesh.triangles[7][1]);
  CHECK(wrong(mesh) == "the edge (0, 1, 0) to (1, 1, 0) is passed the same way by two triangles");
  CHECK(find_defect(mesh)->triangle == 0);
  mesh = kCube;
  mesh.triangles.push_back(mesh.triangles[0]);
  CHECK_THAT(wrong(mesh), ContainsSubstring("has 3 triangles"));
  CHECK(wrong(inside_out(kCube)) == "the mesh is inside out");
  CHECK_FALSE(find_defect(inside_out(kCube))->triangle.has_value());
  mesh = kCube;
  append_mesh(mesh, inside_out(block_between({2, 0, 0}, {3, 1, 1})));
  CHECK(wrong(mesh) == "the shell of this triangle is inside out and no cavity of another");
  CHECK(find_defect(mesh)->triangle == 12);
  mesh = kCube;
  append_mesh(mesh, block_between({2, 0, 0}, {3, 1, 0}));
  CHECK(wrong(mesh) == "the shell of this triangle encloses no volume");
}
