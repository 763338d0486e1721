#include "model/part/cage_obj.h"

#include <cmath>
#include <cstdlib>
#include <cstring>
#include <random>
#include <sstream>

#include "model/base/error.h"
#include "tests/model/cage_builders.h"
#include "tests/model/fixture_files.h"
#include "tests/support/cages.h"
#include "tests/support/catch.h"
#include "tests/support/folders.h"
#include "tests/support/messages.h"

using namespace limitgauge::model;
using namespace limitgauge::model::test;

namespace {

Cage cage_of(const std::string& text) {
  std::istringstream in(text);
  return read_cage_obj(in, "text.obj");
}

/// Reads text that may be broken: a cage must then be a good one, an error must name its place.
void check_read_or_refused(const std::string& text) {
  CAPTURE(text);
  try {
    const Cage cage = cage_of(text);
    CHECK(find_defects(cage).empty());
    CHECK(cage.face_count() > 0);
  } catch (const InputError& error) {
    CHECK(error.place().file == "text.obj");
  }
}

const std::string kQuad = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1 2 3 4\n";

void check_same(const Cage& a, const Cage& b) {
  CHECK(a.vertices == b.vertices);
  CHECK(a.face_corners == b.face_corners);
  CHECK(a.face_offsets == b.face_offsets);
  REQUIRE(a.creases.size() == b.creases.size());
  for (std::size_t i = 0; i < a.creases.size(); ++i) {
    CHECK(a.creases[i].vertices == b.creases[i].vertices);
    CHECK(a.creases[i].sharpness == b.creases[i].sharpness);
  }
  REQUIRE(a.corners.size() == b.corners.size());
  for (std::size_t i = 0; i < a.corners.size(); ++i) {
    CHECK(a.corners[i].vertex == b.corners[i].vertex);
    CHECK(a.corners[i].sharpness == b.corners[i].sharpness);
  }
  CHECK(a.holes == b.holes);
  CHECK(a.boundary == b.boundary);
}

}  // namespace

TEST_CASE("one quad with everything that carries nothing", "[unit][obj]") {
  const Cage cage = cage_of(
      "\xEF\xBB\xBF# made by hand\r\nmtllib a.mtl\r\no part\ng top\ns off\nusemtl steel\n"
      "v 0 0 0\nv\t1 0 0 1\nv 1 1 +0 0.5 0.5 0.5 # coloured\nv 0 1 -0e0\n\n"
      "vt 0 0\nvn 0 0 1\nvp 0.5\n  f 1/1 2//1 3/1/1 \\\n   4");
  CHECK(cage.name == "text");
  CHECK(cage.vertices == std::vector<Vec3>{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}});
  CHECK(cage.face_corners == std::vector<Index>{0, 1, 2, 3});
  CHECK(cage.boundary == BoundaryRule::edge_only);
}

TEST_CASE("relative indices count back from where they stand", "[unit][obj]") {
  const Cage cage = cage_of("v 0 0 0\nv 1 0 0\nv 1 1 0\nf -3 -2 -1\nv 0 1 0\nf -2 -1 -4\n");
  CHECK(cage.face_corners == std::vector<Index>{0, 1, 2, 2, 3, 0});
}

TEST_CASE("positive indices may name vertices that follow", "[unit][obj]") {
  CHECK(cage_of("f 1 2 3\nv 0 0 0\nv 1 0 0\nv 0 1 0\n").face_count() == 1);
}

TEST_CASE("tags: creases, chains, corners, holes, boundary rules", "[unit][obj]") {
  const Cage cage =
      cage_of(kQuad +
              "t crease 3/2/0 0 1 2 1.5 12\nt crease 2/1/0 3 0 0\n"
              "t crease 2/1/0 0 3 0\nt corner 2/1/0 0 2 3\nt hole 1/0/0 0\n"
              "t interpolateboundary 1/0/0 1\nt facevaryinginterpolateboundary 1/0/0 3\n");
  REQUIRE(cage.creases.size() == 3);  // one edge was tagged twice alike
  CHECK(cage.creases[0].vertices == std::array<Index, 2>{0, 1});
  CHECK(cage.creases[0].sharpness == 1.5);
  CHECK(cage.creases[1].vertices == std::array<Index, 2>{1, 2});
  CHECK(cage.creases[1].sharpness >= kInfiniteSharpness);
  CHECK(cage.creases[2].sharpness == 0);
  REQUIRE(cage.corners.size() == 2);
  CHECK(cage.corners[1].vertex == 2);
  CHECK(cage.corners[1].sharpness == 3);
  CHECK(cage.holes == std::vector<Index>{0});
  CHECK(cage.boundary == BoundaryRule::edge_and_corner);
  CHECK(cage_of(kQuad + "t interpolateboundary 1/0/0 0\n").boundary == BoundaryRule::none);
  CHECK(cage_of(kQuad + "t interpolateboundary 1/0/0 2\n").boundary == BoundaryRule::edge_only);
}

TEST_CASE("every bad cage gets its one error", "[unit][obj]") {
  const auto files = fixture_files("cages/bad", ".obj");
  REQUIRE(files.size() >= 50);
  for (const std::filesystem::path& path : files) {
    const std::string error = message_of<InputError>([&] { read_cage_obj(path); });
    const std::string expected = text_beside(path, ".error");
    const std::string separator = expected.starts_with("error:") ? ": " : ":";
    CHECK(error + "\n" == path.string() + separator + expected);
  }
}

TEST_CASE("paths that are no readable file", "[unit][obj]") {
  const std::filesystem::path folder = limitgauge::tests::fixtures();
  CHECK_THROWS_WITH(read_cage_obj(folder), ContainsSubstring("error: this is a directory"));
  CHECK_THROWS_AS(read_cage_obj(folder / "no-such.obj"), InputError);
  CHECK_THROWS_WITH(read_cage_obj(folder / "no-such.obj"),
                    ContainsSubstring("error: there is no such file"));
}

TEST_CASE("cages of any shape are the same after writing and reading", "[property][obj]") {
  std::mt19937_64 random(2);
  for (int round = 0; round < 60; ++round) {
    Cage cage = grid(1 + static_cast<Index>(random() % 5), 1 + static_cast<Index>(random() % 5));
    // Any finite double must survive, so coordinates are random bits.
    for (Vec3& p : cage.vertices) {
      for (const int axis : {0, 1, 2}) {
        const std::uint64_t bits = random();
        double value = 0;
        std::memcpy(&value, &bits, sizeof value);
        p[axis] = std::isnormal(value) ? value : 0.1 * static_cast<double>(bits % 1000);
      }
    }
    cage.creases = {{{0, 1}, static_cast<double>(random() % 1200) / 97}};
    cage.corners = {{static_cast<Index>(cage.vertices.size()) - 1, 1.0 / 3}};
    if (random() % 2 == 0) cage.holes = {0};
    cage.boundary = static_cast<BoundaryRule>(random() % 3);
    std::stringstream text;
    write_cage_obj(cage, text);
    check_same(cage, read_cage_obj(text, "again.obj"));
  }
}

TEST_CASE("text cut off anywhere gives a cage or an InputError, nothing else", "[property][obj]") {
  const std::string whole =
      kQuad + "v 2 0 0\nv 2 1 0\nf -5/1 -2/1/1 -1//1 \\\n -4\nt crease 2/1/0 1 2 3\n";
  for (std::size_t length = 0; length < whole.size(); ++length)
    check_read_or_refused(whole.substr(0, length));
}

TEST_CASE("text with any byte changed gives a cage or an InputError", "[property][obj]") {
  const std::string whole = kQuad + "t crease 2/1/0 1 2 3\nt corner 1/1/0 0 2\nt hole 1/0/0 0\n";
  std::mt19937 random(5);
  for (int round = 0; round < 4000; ++round) {
    std::string text = whole;
    for (int change = 0; change < 3; ++change)
      text[random() % text.size()] = static_cast<char>(random() % 256);
    check_read_or_refused(text);
  }
}

TEST_CASE("every cage of the folder LIMITGAUGE_CAGES is read, or refused where it is broken",
          "[unit][obj]") {
  const char* const folder = std::getenv("LIMITGAUGE_CAGES");
  if (folder == nullptr) return;
  const std::vector<std::string> broken = {"catmark_fan", "catmark_nonman_edges",
                                           "catmark_nonman_verts"};
  int read_cages = 0;
  for (const auto& entry : std::filesystem::directory_iterator(folder)) {
    if (entry.path().extension() != ".obj") continue;
    const std::string name = entry.path().stem().string();
    CAPTURE(name);
    if (std::find(broken.begin(), broken.end(), name) != broken.end()) {
      CHECK_THROWS_AS(read_cage_obj(entry.path()), InputError);
      continue;
    }
    const Cage cage = read_cage_obj(entry.path());
    std::stringstream text;
    write_cage_obj(cage, text);
    check_same(cage, read_cage_obj(text, "again.obj"));
    ++read_cages;
  }
  CHECK(read_cages > 0);
}

TEST_CASE("a cage that may have been cut off", "[unit][obj]") {
  std::ostringstream out;
  write_cage_obj(limitgauge::tests::cube_cage(), out);
  std::string cube = out.str();
  cube.resize(cube.find("t "));  // tags stand behind the faces
  CHECK(cage_of(cube).ends_in_line);
  cube.pop_back();
  const Cage whole = cage_of(cube);
  CHECK(!whole.ends_in_line);
  CHECK(whole.face_count() == 6);
  const auto refusal = [](const std::string& text) {
    return limitgauge::tests::message_of<InputError>([&] { cage_of(text); });
  };
  const std::string cut = cube.substr(0, cube.rfind(' '));
  CHECK_THAT(refusal(cut), ContainsSubstring("text.obj:14:1: error: the file ends in this face"));
  CHECK(refusal(cut + "\n") == "no error");
  // Beside other triangles, in the only hole.
  const std::size_t first = cube.find("f ");
  const std::string face = cube.substr(first, cube.find('\n', first) - first);
  std::istringstream corners(face.substr(2));
  std::string a, b, c, d;
  corners >> a >> b >> c >> d;
  const std::string halves = "f " + a + ' ' + b + ' ' + c + "\nf " + a + ' ' + c + ' ' + d;
  const std::string mixed = std::string(cut).replace(first, face.size(), halves);
  CHECK_THAT(refusal(mixed), ContainsSubstring("the face leaves the only hole of the cage"));
}
