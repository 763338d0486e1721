// Meshes as designs: what is read, and what is refused with its place.
#include "model/part/target_mesh.h"

#include "tests/model/mesh_texts.h"
#include "tests/support/catch.h"
#include "tests/support/mesh_shapes.h"
#include "tests/support/messages.h"

namespace limitgauge::model {
namespace {

TriangleSoup soup_of(const TriangleMesh& mesh) {
  TriangleSoup soup;
  soup.file = "part.stl";
  soup.vertices = mesh.vertices;
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) soup.add(mesh.triangles[t], 10 * t + 1);
  return soup;
}

TriangleMesh two_triangles() {
  TriangleMesh mesh;
  mesh.vertices = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};
  mesh.triangles = {{0, 1, 2}, {0, 2, 3}};
  return mesh;
}

std::string refused(const TriangleMesh& mesh) {
  try {
    target_mesh(soup_of(mesh));
  } catch (const InputError& error) {
    return error.place().file + ":" + std::to_string(error.place().line) + ": " + error.what();
  }
  return "";
}

bool has(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

}  // namespace

TEST_CASE("a mesh as a design need not be closed", "[unit]") {
  const TargetMesh open = target_mesh(soup_of(two_triangles()));
  CHECK(is_open(open.cage));
  CHECK(open.cage.face_count() == 2);
  REQUIRE(open.cage.creases.size() == 1);
  CHECK(open.cage.creases.front().vertices == std::array<Index, 2>{0, 2});
  CHECK(open.cage.corners.size() == 4);
  const TargetMesh closed = target_mesh(soup_of(tests::block_between({0, 0, 0}, {1, 2, 3})));
  CHECK_FALSE(is_open(closed.cage));
  CHECK(closed.cage.creases.size() == 18);
}

TEST_CASE("triangles with two corners in one point are counted and left out", "[unit]") {
  TriangleMesh mesh = two_triangles();
  mesh.triangles.push_back({0, 0, 1});
  const TargetMesh read = target_mesh(soup_of(mesh));
  CHECK(read.dropped_triangles == 1);
  CHECK(read.mesh.triangles.size() == 2);
}

TEST_CASE("a mesh that cannot be a design is refused with its triangle and place", "[unit]") {
  TriangleMesh line = two_triangles();
  line.vertices.push_back({2, 0, 0});
  line.triangles.push_back({1, 0, 4});
  CHECK(has(refused(line), "part.stl:21: "));
  CHECK(has(refused(line), "triangle 3: its corners lie on one line"));
  TriangleMesh flipped = two_triangles();
  std::swap(flipped.triangles[1][0], flipped.triangles[1][1]);
  CHECK(has(refused(flipped), "part.stl:11: "));
  CHECK(has(refused(flipped), "triangle 2: it goes round the other way"));
  TriangleMesh three = two_triangles();
  three.vertices.push_back({0, 0, 1});
  three.triangles.push_back({0, 2, 4});
  CHECK(has(refused(three), "more than two triangles"));
  TriangleMesh point = two_triangles();
  point.vertices.insert(point.vertices.end(), {{-1, 0, 0}, {-1, -1, 0}});
  point.triangles.push_back({0, 4, 5});
  CHECK(has(refused(point), "meet in a point only"));
  CHECK(has(refused(tests::inside_out(tests::block_between({0, 0, 0}, {1, 1, 1}))), "inside out"));
  TriangleMesh far = two_triangles();
  far.vertices[3].z = 1e9;
  CHECK(has(refused(far), "triangle 2: a corner lies at"));
  CHECK(has(refused(TriangleMesh{}), "no triangle"));
}

TEST_CASE("of several bodies each has its inside within", "[unit]") {
  const TriangleMesh block = tests::block_between({0, 0, 0}, {4, 4, 4});
  const auto with = [&](const TriangleMesh& other) {
    TriangleMesh both = block;
    tests::append_mesh(both, other);
    return both;
  };
  const TriangleMesh apart = tests::block_between({6, 0, 0}, {8, 2, 2});
  const TriangleMesh within = tests::block_between({1, 1, 1}, {2, 2, 2});
  CHECK(target_mesh(soup_of(with(apart))).mesh.triangles.size() == 24);
  CHECK(has(refused(with(tests::inside_out(apart))), "triangle 13: its body is inside out"));
  CHECK(target_mesh(soup_of(with(tests::inside_out(within)))).mesh.triangles.size() == 24);
  // A sheet has no inside, whatever else is there; what is beside it has one.
  TriangleMesh sheet = two_triangles();
  CHECK(target_mesh(soup_of(tests::inside_out(sheet))).mesh.triangles.size() == 2);
  tests::append_mesh(sheet, tests::inside_out(apart));
  CHECK(has(refused(sheet), "triangle 3: its body is inside out"));
}

TEST_CASE("two triangles back to back are refused", "[unit]") {
  TriangleMesh mesh;
  mesh.vertices = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  mesh.triangles = {{0, 1, 2}, {0, 2, 1}};
  CHECK(refused(mesh).find("lies back on triangle 1") != std::string::npos);
}

TEST_CASE("a triangle without area is told where its file says so, thin ones are read", "[unit]") {
  TriangleMesh thin = two_triangles();
  thin.vertices[3] = {0.5, 0.5 + 1e-7, 0};  // as single precision leaves slivers
  CHECK(target_mesh(soup_of(thin)).mesh.triangles.size() == 2);
}

}  // namespace limitgauge::model
