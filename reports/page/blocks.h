#pragma once

#include <cstdint>
#include <nlohmann/json.hpp>
#include <span>
#include <string>
#include <string_view>

namespace limitgauge::reports::page {

using Json = nlohmann::json;

/// The page's numbers in the making: arrays one after the other, so arranged that they compress
/// well (reports/web/README.md, "block"). Each add function gives back what the page's JSON says of
/// the array.
class Blob {
 public:
  Json add(std::span<const std::uint8_t> values);
  Json add(std::span<const std::uint32_t> values);
  /// With `components` 3 the x, y, z of points in turn.
  Json add(std::span<const std::int32_t> values, int components = 1);
  Json add(std::span<const float> values);
  const std::string& bytes() const { return bytes_; }

 private:
  Json add_planes(std::span<const std::uint32_t> words, const char* type);
  Json add_whole(std::span<const std::uint32_t> words, int components, const char* type);

  std::string bytes_;
};

/// `bytes` as zlib data in base64. Throws model::ResourceError where memory is short.
std::string packed(std::string_view bytes);

/// `value` rounded to so many significant bits (1 to 24): the others are zero and cost nothing.
float with_bits(float value, int bits);

/// A power of two of which 2^18 span `extent_mm`, or more where `farthest_mm` from zero asks for
/// it: coordinates as multiples of it are exact and fit into 31 bits.
double grid_step(double extent_mm, double farthest_mm);

}  // namespace limitgauge::reports::page
