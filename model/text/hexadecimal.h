#pragma once

#include <span>
#include <string>
#include <string_view>

namespace limitgauge::model {

inline constexpr std::string_view kLowerHexDigits = "0123456789abcdef";
inline constexpr std::string_view kUpperHexDigits = "0123456789ABCDEF";

/// A byte as two hexadecimal digits.
std::string hexadecimal(unsigned char byte, std::string_view digits = kLowerHexDigits);
/// Bytes as pairs of lower-case hexadecimal digits.
std::string hexadecimal(std::span<const unsigned char> bytes);

/// A path as it stands in a URI: letters, digits and `-._~/` as they are, every other byte as `%`
/// and two upper-case digits (RFC 3986, section 2.1).
std::string percent_encoded(std::string_view path);

}  // namespace limitgauge::model
