#include "model/mesh/mesh_reader.h"

#include <filesystem>
#include <fstream>
#include <random>
#include <sstream>

#include "model/base/error.h"
#include "model/mesh/mesh_defect.h"
#include "tests/model/fixture_files.h"
#include "tests/model/mesh_texts.h"
#include "tests/support/catch.h"
#include "tests/support/mesh_shapes.h"
#include "tests/support/temporary_folder.h"

using namespace limitgauge::model;
using namespace limitgauge::model::test;
using limitgauge::tests::block_between;

namespace {

MeshReading read(const std::string& bytes, const std::string& name = "part") {
  std::istringstream in(bytes);
  return read_mesh(in, name);
}

std::string mesh_error_of(const std::string& bytes, const std::string& name = "part") {
  return message_of<InputError>([&] { read(bytes, name); });
}

/// A block whose coordinates single precision holds.
const TriangleMesh kBlock = block_between({-1, 0, 0.5}, {2, 2.25, 8});

struct Format {
  std::string name, bytes;
};

std::vector<Format> all_formats(const TriangleMesh& mesh) {
  return {{"part.stl", binary_stl(mesh)},
          {"part.stl", ascii_stl(mesh)},
          {"part.obj", obj(mesh)},
          {"part.ply", ascii_ply(mesh)},
          {"part.ply", binary_ply(mesh, std::endian::little)},
          {"part.ply", binary_ply(mesh, std::endian::big)}};
}

std::string with(std::string text, const std::string& from, const std::string& to) {
  const std::size_t at = text.find(from);
  REQUIRE(at != std::string::npos);
  return text.replace(at, from.size(), to);
}

}  // namespace

TEST_CASE("one block from all formats", "[unit][mesh]") {
  for (const Format& f : all_formats(kBlock)) {
    CAPTURE(f.name, f.bytes.substr(0, 60));
    const MeshReading reading = read(f.bytes, f.name);
    CHECK(reading.dropped_triangles == 0);
    CHECK(reading.mesh.vertices.size() == 8);
    REQUIRE(reading.mesh.triangles.size() == 12);
    for (std::size_t t = 0; t < 12; ++t)
      for (int k = 0; k < 3; ++k)
        CHECK(reading.mesh.vertices[reading.mesh.triangles[t][k]] ==
              kBlock.vertices[kBlock.triangles[t][k]]);
    CHECK(volume_mm3(reading.mesh) == Approx(3 * 2.25 * 7.5).epsilon(1e-14));
    CHECK(area_mm2(reading.mesh) == Approx(2 * (3 * 2.25 + 2.25 * 7.5 + 7.5 * 3)).epsilon(1e-14));
    CHECK(bounding_box(reading.mesh).low == Vec3{-1, 0, 0.5});
    CHECK(bounding_box(reading.mesh).high == Vec3{2, 2.25, 8});
  }
}

TEST_CASE("the content tells the format", "[unit][mesh]") {
  // All but OBJ say what they are.
  for (const Format& f : all_formats(kBlock))
    if (f.name != "part.obj") CHECK(read(f.bytes, "part").mesh.triangles.size() == 12);
  // A binary STL that begins as an ASCII one does.
  CHECK(read(binary_stl(kBlock, "solid from a well known program"), "p.stl").mesh.vertices.size() ==
        8);
  CHECK(read(obj(kBlock), "P.OBJ").mesh.vertices.size() == 8);
  CHECK(mesh_error_of("") == "part: error: the file is empty; expected a mesh as STL, OBJ or PLY");
  CHECK(mesh_error_of("hello") ==
        "part: error: the file is no mesh of a known kind; expected STL, OBJ or PLY");
}

TEST_CASE("a mesh from the disk", "[unit][mesh]") {
  const limitgauge::tests::TemporaryFolder folder;
  const std::filesystem::path file = folder.path() / "block.stl";
  {
    std::ofstream out(file, std::ios::binary);
    out << binary_stl(kBlock);
  }
  CHECK(read_triangle_mesh(file).triangles.size() == 12);
  std::filesystem::remove(file);
  CHECK(message_of<InputError>([&] { read_triangle_mesh(file); }) ==
        file.string() + ": error: there is no such file");
}

TEST_CASE("negative zero and repeated corners", "[unit][mesh]") {
  TriangleMesh mesh = kBlock;
  mesh.triangles.push_back({3, 3, 5});
  const MeshReading reading = read(with(obj(mesh), "v -1 0 0.5", "v -1 -0 0.5"), "p.obj");
  CHECK(reading.dropped_triangles == 1);
  CHECK(reading.mesh.vertices.size() == 8);
  CHECK(reading.mesh.triangles.size() == 12);
}

TEST_CASE("what is wrong with an STL, each with its place", "[unit][mesh]") {
  const std::string binary = binary_stl(kBlock), ascii = ascii_stl(kBlock);
  CHECK(mesh_error_of(binary.substr(0, 50), "p.stl") ==
        "p.stl: error: the file of 50 bytes is cut short; expected an STL file");
  CHECK(mesh_error_of(binary.substr(0, 600), "p.stl") ==
        "p.stl: error: at byte 80: the file states 12 triangles but has 600 bytes; expected 684 "
        "bytes of a binary STL");
  std::string huge = binary;
  huge.replace(80, 4, "\xFF\xFF\xFF\xFF");
  CHECK_THAT(mesh_error_of(huge, "p.stl"),
             ContainsSubstring("states 4294967295 triangles but has 684"));
  std::string nan = binary;
  nan.replace(84 + 50 + 12 + 4, 4, std::string("\0\0\xC0\x7F", 4));
  CHECK(mesh_error_of(nan, "p.stl") ==
        "p.stl: error: at byte 150: triangle 2: a coordinate is not a finite number; expected "
        "millimetres");
  CHECK(mesh_error_of(ascii.substr(0, 100)) ==
        "part: error: the file ends in the middle of a solid; expected 'endloop'");
  CHECK(mesh_error_of(with(ascii, "vertex -1 0 0.5", "vertex -1 0")) ==
        "part:4:14: error: the line ends here; expected a coordinate");
  CHECK(mesh_error_of(ascii.substr(0, ascii.find("endsolid"))) ==
        "part: error: the file ends in the middle of a solid; expected 'facet' or 'endsolid'");
  CHECK(mesh_error_of(with(ascii, "vertex -1 0", "vertex -1 o")) ==
        "part:4:13: error: 'o' stands here; expected a coordinate");
  CHECK(mesh_error_of(with(ascii, "vertex -1", "vertex nan")) ==
        "part:4:10: error: 'nan' stands here; expected a coordinate");
  CHECK(mesh_error_of(with(ascii, "endloop", "vertex 1 2 3")) ==
        "part:7:2: error: 'vertex' stands here; expected 'endloop'");
  CHECK(mesh_error_of("solid\nendsolid\n") ==
        "part: error: the mesh has no triangles; expected a closed mesh");
  CHECK(read(with(ascii, "normal 0 0 0", "normal nan nan nan")).mesh.triangles.size() == 12);
}

TEST_CASE("what is wrong with an OBJ, each with its place", "[unit][mesh]") {
  const std::string good = obj(kBlock);
  const auto wrong = [&](const std::string& from, const std::string& to) {
    return mesh_error_of(with(good, from, to), "p.obj");
  };
  CHECK(wrong("v -1 0 0.5", "v -1 0") ==
        "p.obj:3:1: error: a vertex with 2 values; expected x y z");
  CHECK(wrong("v -1 0", "v -1 inf") ==
        "p.obj:3:6: error: 'inf' is not a finite number; expected a coordinate");
  CHECK(wrong("o part", "cstype bezier") ==
        "p.obj:2:1: error: unknown statement 'cstype'; expected v, f or a comment");
  CHECK(wrong("f 1/1/1", "f 0/1/1") ==
        "p.obj:11:3: error: there is no vertex 0; expected indices from 1, or from -1 backwards");
  CHECK(wrong("f 1/1/1", "f 9/1/1") ==
        "p.obj:11: error: face 1: a corner names a vertex that does not exist; expected one of the "
        "8 vertices");
  CHECK(wrong("f 1/1/1", "f -9") ==
        "p.obj:11:3: error: there is no vertex -9; expected indices from 1, or from -1 backwards");
  CHECK(wrong("f 1/1/1", "f x") ==
        "p.obj:11:3: error: 'x' is no face corner; expected v, v/vt, v//vn or v/vt/vn");
  CHECK(wrong("f 1/1/1 3//1 4", "f 1 2") ==
        "p.obj:11:1: error: a face with 2 corners; expected three or more");
  CHECK(mesh_error_of("v 0 0 0\n", "p.obj") ==
        "p.obj: error: the file has no faces; expected a closed mesh");
}

TEST_CASE("what is wrong with a PLY, each with its place", "[unit][mesh]") {
  const std::string ascii = ascii_ply(kBlock), binary = binary_ply(kBlock, std::endian::little);
  const auto wrong = [&](const std::string& from, const std::string& to) {
    return mesh_error_of(with(ascii, from, to));
  };
  CHECK(mesh_error_of("plx\n", "p.ply") == "p.ply:1:1: error: the file is no PLY; expected 'ply'");
  CHECK(mesh_error_of("ply\nformat ascii 1.0\n") ==
        "part: error: the file ends in its header; expected 'end_header'");
  CHECK(wrong("ascii", "utf8") ==
        "part:2:8: error: unknown format 'utf8'; expected ascii, binary_little_endian or "
        "binary_big_endian");
  CHECK(wrong("1.0", "2.0") == "part:2:14: error: unknown version '2.0'; expected 1.0");
  CHECK(wrong("element vertex 8", "element vertex -8") ==
        "part:4:16: error: '-8' is no number of elements; expected 'element NAME COUNT'");
  CHECK(wrong("double x", "real x") ==
        "part:5:10: error: unknown type 'real'; expected a type such as float, double, uchar or "
        "int");
  CHECK(wrong("list uchar", "list float") ==
        "part:10:15: error: a list's length of type 'float'; expected an integer type");
  CHECK(wrong("double z", "double w") ==
        "part:4:1: error: the element 'vertex' has no z; expected a number of that name");
  CHECK(wrong("element vertex 8", "element vertex 8000000000") ==
        "part:4:1: error: the file is too short for 8000000000 elements 'vertex'; expected a count "
        "that fits the file");
  CHECK(wrong("element face 12", "element face 13") ==
        "part: error: the file ends before all elements that its header states; expected more");
  CHECK(wrong("element face 12", "element face 11") ==
        "part:31:1: error: the file goes on behind the elements that its header states; expected "
        "its end");
  CHECK(wrong("-1 0 0.5", "-1 x 0.5") ==
        "part:12:4: error: 'x' is not a finite number; expected a number");
  CHECK(wrong("3 0 2 3", "3 0 2 8") ==
        "part:20: error: face 1: a corner names a vertex that does not exist; expected one of the "
        "8 vertices");
  CHECK(wrong("3 0 2 3", "3 0 2 -1") ==
        "part:20:7: error: there is no vertex -1; expected a vertex counted from 0");
  CHECK_THAT(wrong("3 0 2 3", "99 0 2 3"), ContainsSubstring("part:20:"));
  CHECK_THAT(mesh_error_of(binary.substr(0, binary.size() - 3)),
             ContainsSubstring("at byte 550: a list of 3; expected a length that fits the file"));
  CHECK_THAT(mesh_error_of(binary + "xyz"),
             ContainsSubstring("the file goes on for 3 bytes that its header does not know"));
  CHECK_THAT(mesh_error_of(with(binary, "element vertex 8", "element vertex 4000000000")),
             ContainsSubstring("too short for 4000000000 elements 'vertex'"));
}

TEST_CASE("polygons become fans where that is what they are", "[unit][mesh]") {
  // A prism of height 1 over a polygon in the XY plane.
  const auto prism = [](const std::vector<Vec3>& base) {
    const auto n = base.size();
    std::string text;
    for (const double z : {0.0, 1.0})
      for (const Vec3& p : base) text += "v " + numbers({p.x, p.y, p.z + z}) + "\n";
    std::string low = "f", high = "f";
    for (std::size_t k = 0; k < n; ++k) {
      low += " " + std::to_string(n - k), high += " " + std::to_string(n + k + 1);
      const std::size_t next = (k + 1) % n;
      text += "f " + std::to_string(k + 1) + " " + std::to_string(next + 1) + " " +
              std::to_string(n + next + 1) + " " + std::to_string(n + k + 1) + "\n";
    }
    return text + low + "\n" + high + "\n";
  };
  SECTION("convex") {
    const MeshReading r =
        read(prism({{0, 0, 0}, {2, 0, 0}, {3, 1, 0}, {2, 2, 0}, {0, 2, 0}}), "p.obj");
    CHECK(r.mesh.triangles.size() == 5 * 2 + 2 * 3);
    CHECK(volume_mm3(r.mesh) == Approx(5).epsilon(1e-14));
  }
  SECTION("an L is seen whole from its inner corner alone") {
    const MeshReading r =
        read(prism({{0, 0, 0}, {3, 0, 0}, {3, 1, 0}, {1, 1, 0}, {1, 3, 0}, {0, 3, 0}}), "p.obj");
    CHECK(volume_mm3(r.mesh) == Approx(5).epsilon(1e-14));
    CHECK(area_mm2(r.mesh) == Approx(2 * 5 + 12).epsilon(1e-14));
  }
  SECTION("a U has no such corner") {
    CHECK(mesh_error_of(prism({{0, 0, 0},
                               {3, 0, 0},
                               {3, 3, 0},
                               {2, 3, 0},
                               {2, 1, 0},
                               {1, 1, 0},
                               {1, 3, 0},
                               {0, 3, 0}}),
                        "p.obj") ==
          "p.obj:25: error: face 9: a polygon is not convex and cannot be seen whole from one of "
          "its corners; expected triangles, or plane convex polygons");
  }
  SECTION("a bow tie") {
    const std::string expected = "; expected triangles, or plane convex polygons";
    CHECK_THAT(mesh_error_of(prism({{0, 0, 0}, {2, 2, 0}, {2, 0, 0}, {0, 2, 0}}), "p.obj"),
               ContainsSubstring("a polygon crosses itself" + expected));
  }
  SECTION("a corner on a side, wherever the polygon begins") {
    std::vector<Vec3> base{{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {2, 2, 0}, {0, 2, 0}};
    for (int turn = 0; turn < 5; ++turn, std::rotate(base.begin(), base.begin() + 1, base.end())) {
      const MeshReading r = read(prism(base), "p.obj");
      CHECK(volume_mm3(r.mesh) == Approx(4).epsilon(1e-14));
    }
  }
  SECTION("not plane by two micrometres") {
    CHECK_THAT(mesh_error_of(prism({{0, 0, 0}, {2, 0, 0}, {2, 2, 0.006}, {0, 2, 0}}), "p.obj"),
               ContainsSubstring("p.obj:13: error: face 5: the corners of a polygon are more than "
                                 "0.001 mm off a plane"));
  }
  SECTION("as good as plane") {
    CHECK(read(prism({{0, 0, 0}, {2, 0, 0}, {2, 2, 0.001}, {0, 2, 0}}), "p.obj")
              .mesh.triangles.size() == 12);
  }
}

TEST_CASE("broken files are refused or read, never worse", "[property][mesh]") {
  std::mt19937 random(5);
  const std::string bytes_worth("\0\x01\x7F\x80\xFF 0-9.e\n", 13);
  for (const Format& f : all_formats(kBlock)) {
    int refused = 0;
    for (int n = 0; n < 3000; ++n) {
      std::string text = f.bytes;
      for (int flips = 1 + static_cast<int>(random() % 3); flips > 0; --flips)
        text[random() % text.size()] = random() % 2 == 0
                                           ? static_cast<char>(random())
                                           : bytes_worth[random() % bytes_worth.size()];
      if (random() % 4 == 0) text.resize(random() % text.size());
      if (random() % 4 == 0)
        text.insert(random() % (text.size() + 1), text.substr(text.size() / 2));
      try {
        const MeshReading reading = read(text, f.name);
        CHECK_FALSE(find_defect(reading.mesh).has_value());
      } catch (const InputError& error) {
        ++refused;
        CHECK(error.place().file == f.name);
      } catch (const ResourceError&) {
        ++refused;
      }
    }
    CHECK(refused > 1000);
  }
}

TEST_CASE("a million triangles", "[slow][mesh]") {
  // 709 × 708 × 2: about a million. What is measured is that nothing is quadratic.
  const TriangleMesh sphere = limitgauge::tests::sphere_mesh({1, 2, 3}, 40, 709, 708);
  CHECK(read(binary_stl(sphere), "p.stl").mesh.triangles.size() == sphere.triangles.size());
  CHECK(read(binary_ply(sphere, std::endian::little)).mesh.vertices.size() ==
        sphere.vertices.size());
}
