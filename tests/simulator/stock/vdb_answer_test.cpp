#include "simulator/grid/vdb_answer.h"

#include <cstring>
#include <limits>

#include "model/base/error.h"
#include "tests/support/catch.h"
#include "tests/support/messages.h"

using namespace limitgauge;
using namespace limitgauge::simulator;

namespace {

VdbStock tetrahedron() {
  return {
      {{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}}, {{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}}},
      0.25,
      0.5};
}

std::string words_of(const std::string& answer) {
  return tests::message_of<model::InputError>([&] { read_vdb_answer(answer, "a.vdb"); });
}

std::string with_number(std::string bytes, std::size_t at, std::uint64_t number) {
  std::memcpy(bytes.data() + at, &number, sizeof number);
  return bytes;
}

const std::string kNoSense = "a.vdb: error: OpenVDB makes no sense of the file: it is damaged";

}  // namespace

TEST_CASE("a stock comes through an answer as it was", "[unit][vdb]") {
  const VdbStock stock = tetrahedron();
  const VdbStock back = read_vdb_answer(vdb_answer(stock), "a.vdb");
  CHECK(back.voxel_mm == stock.voxel_mm);
  CHECK(back.blunt_mm == stock.blunt_mm);
  CHECK(back.mesh.vertices == stock.mesh.vertices);
  CHECK(back.mesh.triangles == stock.mesh.triangles);
}

TEST_CASE("why there is no stock comes through an answer, and nothing else", "[unit][vdb]") {
  CHECK(words_of(vdb_refusal("why not")) == "a.vdb: error: why not");
  CHECK(words_of(vdb_refusal("\x1b[2J\n\xff")) == "a.vdb: error: ?[2J??");
  CHECK(words_of(vdb_refusal(std::string(100000, 'x'))).size() < 500);
  CHECK(tests::message_of<model::ResourceError>([] {
          read_vdb_answer(vdb_shortage("too much"), "a.vdb");
        }) == "a.vdb: error: too much");
}

TEST_CASE("an answer that says more than it holds is refused", "[unit][vdb]") {
  const std::string whole = vdb_answer(tetrahedron());
  for (std::size_t size = 0; size < whole.size(); ++size)
    CHECK_THAT(words_of(whole.substr(0, size)), ContainsSubstring(kNoSense));
  CHECK_THAT(words_of(whole + "x"), ContainsSubstring(kNoSense));
  for (const std::uint64_t count : {UINT64_MAX, UINT64_MAX / 24 + 1, std::uint64_t{1} << 61})
    for (const std::size_t at : {9, 17})
      CHECK_THAT(words_of(with_number(whole, at, count)), ContainsSubstring(kNoSense));
}

TEST_CASE("an answer that bounds no solid is refused", "[unit][vdb]") {
  VdbStock stock = tetrahedron();
  stock.mesh.triangles[2][1] = 4;
  CHECK_THAT(words_of(vdb_answer(stock)), ContainsSubstring("bounds no solid"));
  stock = tetrahedron();
  stock.mesh.vertices[1].x = std::numeric_limits<double>::quiet_NaN();
  CHECK_THAT(words_of(vdb_answer(stock)), ContainsSubstring("bounds no solid"));
  for (const double voxel : {0.0, -1.0, std::nan(""), HUGE_VAL}) {
    stock.voxel_mm = voxel;
    CHECK_THAT(words_of(vdb_answer(stock)), ContainsSubstring(kNoSense));
  }
  for (const double blunt : {0.0, -1.0, std::nan(""), HUGE_VAL}) {
    stock = tetrahedron();
    stock.blunt_mm = blunt;
    CHECK_THAT(words_of(vdb_answer(stock)), ContainsSubstring(kNoSense));
  }
}
