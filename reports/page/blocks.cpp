#include "reports/page/blocks.h"

#include <zlib.h>

#include <bit>
#include <cmath>
#include <vector>

#include "model/base/error.h"
#include "reports/text/text.h"

namespace limitgauge::reports::page {
namespace {

using Words = std::vector<std::uint32_t>;

/// Differences modulo 2^32 to the number `components` before.
Words differences(const Words& words, std::size_t components) {
  Words out = words;
  for (std::size_t i = components; i < words.size(); ++i) out[i] = words[i] - words[i - components];
  return out;
}

/// 0, -1, 1, -2, ... as 0, 1, 2, 3, ...: small numbers of either sign have high bytes of zero.
void zigzag(Words& words) {
  for (std::uint32_t& w : words) w = w << 1 ^ (0U - (w >> 31));
}

std::size_t bits_of(const Words& words) {
  std::size_t bits = 0;
  for (const std::uint32_t w : words) bits += static_cast<std::size_t>(std::bit_width(w));
  return bits;
}

}  // namespace

Json Blob::add_planes(std::span<const std::uint32_t> words, const char* type) {
  const std::size_t at = bytes_.size();
  bytes_.reserve(at + 4 * words.size());
  for (int plane = 0; plane < 4; ++plane)
    for (const std::uint32_t w : words) bytes_ += static_cast<char>(w >> (8 * plane) & 0xff);
  return {{"at", at}, {"count", words.size()}, {"type", type}, {"order", 0}};
}

/// With differences as often as makes the numbers smallest.
Json Blob::add_whole(std::span<const std::uint32_t> words, int components, const char* type) {
  Words best(words.begin(), words.end()), taken = best;
  std::size_t least = bits_of(best);
  int best_order = 0;
  for (int order = 1; order <= 2; ++order) {
    taken = differences(taken, static_cast<std::size_t>(components));
    Words coded = taken;
    zigzag(coded);
    const std::size_t bits = bits_of(coded);
    if (bits >= least) continue;
    least = bits, best_order = order, best = std::move(coded);
  }
  Json block = add_planes(best, type);
  block["order"] = best_order;
  if (components > 1) block["components"] = components;
  return block;
}

Json Blob::add(std::span<const std::uint8_t> values) {
  const std::size_t at = bytes_.size();
  bytes_.append(values.begin(), values.end());
  return {{"at", at}, {"count", values.size()}, {"type", "u8"}, {"order", 0}};
}

Json Blob::add(std::span<const std::uint32_t> values) {
  return add_whole(values, 1, "u32");
}

Json Blob::add(std::span<const std::int32_t> values, int components) {
  const Words words(values.begin(), values.end());
  return add_whole(words, components, "i32");
}

Json Blob::add(std::span<const float> values) {
  Words words;
  words.reserve(values.size());
  for (const float value : values) words.push_back(std::bit_cast<std::uint32_t>(value));
  return add_planes(words, "f32");
}

std::string packed(std::string_view bytes) {
  uLongf size = compressBound(static_cast<uLong>(bytes.size()));
  std::string out(size, '\0');
  if (compress2(reinterpret_cast<Bytef*>(out.data()), &size,
                reinterpret_cast<const Bytef*>(bytes.data()), static_cast<uLong>(bytes.size()),
                Z_DEFAULT_COMPRESSION) != Z_OK)
    throw model::ResourceError("zlib could not compress the page's data");
  out.resize(size);
  return base64(out);
}

float with_bits(float value, int bits) {
  if (!std::isfinite(value) || value == 0) return value;
  int exponent = 0;
  const float mantissa = std::frexp(value, &exponent);
  return std::ldexp(std::nearbyint(std::ldexp(mantissa, bits)), exponent - bits);
}

double grid_step(double extent_mm, double farthest_mm) {
  const auto power = [](double mm, int bits) { return mm > 0 ? std::ilogb(mm) + 1 - bits : -bits; };
  return std::ldexp(1.0, std::max(power(extent_mm, 18), power(farthest_mm, 30)));
}

}  // namespace limitgauge::reports::page
