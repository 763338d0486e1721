#include <zlib.h>

#include <bit>
#include <cmath>
#include <random>

#include "reports/page/blocks.h"
#include "reports/text/text.h"
#include "tests/support/catch.h"

using namespace limitgauge::reports;
using namespace limitgauge::reports::page;

namespace {

std::uint32_t word_at(const std::string& bytes, const Json& block, std::size_t i) {
  const std::size_t at = block["at"], count = block["count"];
  std::uint32_t word = 0;
  for (std::size_t plane = 0; plane < 4; ++plane)
    word |= std::uint32_t(static_cast<unsigned char>(bytes.at(at + plane * count + i)))
            << (8 * plane);
  return word;
}

/// The numbers of a block as a reader takes them out.
std::vector<std::uint32_t> read(const std::string& bytes, const Json& block) {
  std::vector<std::uint32_t> out(block["count"].get<std::size_t>());
  const int order = block["order"];
  for (std::size_t i = 0; i < out.size(); ++i) {
    const std::uint32_t word = word_at(bytes, block, i);
    out[i] = order == 0 ? word : word >> 1 ^ (0U - (word & 1));
  }
  const std::size_t components = block.value("components", std::size_t(1));
  for (int round = 0; round < order; ++round)
    for (std::size_t i = components; i < out.size(); ++i) out[i] += out[i - components];
  return out;
}

/// Base64 by the book: six bits a character.
std::string from_base64(const std::string& text) {
  const std::string digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string out;
  std::uint32_t bits = 0;
  int held = 0;
  for (const char c : text) {
    if (c == '=') break;
    bits = bits << 6 | static_cast<std::uint32_t>(digits.find(c));
    if ((held += 6) < 8) continue;
    held -= 8;
    out += static_cast<char>(bits >> held & 0xff);
  }
  return out;
}

}  // namespace

TEST_CASE("whole numbers come back from a block whatever their differences", "[unit][page]") {
  std::mt19937 random(7);
  for (const std::uint32_t most : {1U, 300U, 70'000U, 0xffffffffU}) {
    std::vector<std::uint32_t> values = {0xffffffffU, 0, 1};
    for (int i = 0; i < 500; ++i) values.push_back(static_cast<std::uint32_t>(random()) % most);
    std::vector<std::int32_t> points;
    for (std::size_t i = 0; i < 3 * (values.size() / 3); ++i)
      points.push_back(static_cast<std::int32_t>(values[i]));
    Blob blob;
    const Json a = blob.add(values), b = blob.add(points, 3);
    CHECK(read(blob.bytes(), a) == values);
    CHECK(read(blob.bytes(), b) == std::vector<std::uint32_t>(points.begin(), points.end()));
    CHECK(b["at"] == 4 * values.size());
    CHECK(b["components"] == 3);
    CHECK(b["type"] == "i32");
  }
}

TEST_CASE("differences are taken as often as makes numbers small", "[unit][page]") {
  std::vector<std::uint32_t> constant(100, 1'000'000), line, parabola, noise;
  std::mt19937 random(1);
  for (std::uint32_t i = 0; i < 100; ++i) {
    line.push_back(5000 - 7 * i), parabola.push_back(100 * i * i);
    noise.push_back(static_cast<std::uint32_t>(random()));
  }
  Blob blob;
  CHECK(blob.add(constant)["order"] == 1);
  CHECK(blob.add(line)["order"] == 2);
  CHECK(blob.add(parabola)["order"] == 2);
  CHECK(blob.add(noise)["order"] == 0);
  // 0 and 1 in turn need a bit each other number; their differences one each.
  CHECK(blob.add(std::vector<std::uint32_t>{0, 1, 0, 1, 0, 1})["order"] == 0);
}

TEST_CASE("points differ from the same axis of the point before", "[unit][page]") {
  std::vector<std::int32_t> points;
  for (int i = 0; i < 10; ++i) points.insert(points.end(), {1000 * i, -5, 3 * i});
  Blob blob;
  const Json block = blob.add(points, 3);
  CHECK(block["order"] == 2);
  // Zigzag-coded: (0, -5, 0), the first step (1000, 0, 3) less that, and no change of the step.
  const std::vector<std::uint32_t> coded = {0, 9, 0, 2000, 10, 6};
  for (std::size_t i = 0; i < coded.size(); ++i) CHECK(word_at(blob.bytes(), block, i) == coded[i]);
  for (std::size_t i = 6; i < points.size(); ++i) CHECK(word_at(blob.bytes(), block, i) == 0);
}

TEST_CASE("single precision stands by planes, bytes as they are", "[unit][page]") {
  Blob blob;
  const std::vector<std::uint8_t> flags = {3, 0, 255};
  const std::vector<float> values = {1.5F, -2e-30F, 0.0F};
  CHECK(blob.add(flags)["at"] == 0);
  const Json block = blob.add(values);
  CHECK(block["at"] == 3);
  CHECK(block["type"] == "f32");
  CHECK(static_cast<unsigned char>(blob.bytes()[2]) == 255);
  for (std::size_t i = 0; i < values.size(); ++i)
    CHECK(word_at(blob.bytes(), block, i) == std::bit_cast<std::uint32_t>(values[i]));
}

TEST_CASE("a number keeps so many bits, rounded to nearest", "[unit][page]") {
  CHECK(with_bits(0.0F, 13) == 0.0F);
  CHECK(with_bits(-0.75F, 2) == -0.75F);
  CHECK(with_bits(1.0F + 1.0F / 4096, 13) == 1.0F + 1.0F / 4096);
  CHECK(with_bits(1.0F + 1.0F / 16384, 13) == 1.0F);
  CHECK(with_bits(1.9999999F, 13) == 2.0F);
  std::mt19937 random(3);
  for (int i = 0; i < 1000; ++i) {
    const float value = std::ldexp(float(random()) / 1e9F - 2, int(random() % 60) - 30);
    CHECK(std::abs(with_bits(value, 13) - value) <= std::abs(value) * 0x1p-13F);
    CHECK((std::bit_cast<std::uint32_t>(with_bits(value, 13)) & 0x7ff) == 0);
  }
}

TEST_CASE("coordinates on a grid are exact and fit", "[unit][page]") {
  CHECK(grid_step(128, 64) == 0x1p-10);
  CHECK(grid_step(127.9, 64) == 0x1p-11);
  CHECK(grid_step(0, 0) == 0x1p-18);
  // Far from zero the numbers must fit into 31 bits all the same.
  const double step = grid_step(1e-3, 1e6);
  CHECK(1e6 / step < 0x1p30);
  CHECK(1e6 / step >= 0x1p29);
}

TEST_CASE("what is packed is zlib data in base64", "[unit][page]") {
  for (const std::size_t size : {0, 1, 2, 3, 100'000}) {
    std::string bytes;
    for (std::size_t i = 0; i < size; ++i) bytes += static_cast<char>(i * i);
    const std::string zipped = from_base64(packed(bytes));
    std::string back(size + 1, '\0');
    uLongf length = back.size();
    REQUIRE(uncompress(reinterpret_cast<Bytef*>(back.data()), &length,
                       reinterpret_cast<const Bytef*>(zipped.data()), zipped.size()) == Z_OK);
    back.resize(length);
    CHECK(back == bytes);
  }
  CHECK(base64("Many hands") == "TWFueSBoYW5kcw==");
}
