#include "reports/text/text.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>

#include "model/text/number_text.h"

namespace limitgauge::reports {
namespace {

std::string_view entity(char c) {
  switch (c) {
    case '&':
      return "&amp;";
    case '<':
      return "&lt;";
    case '>':
      return "&gt;";
    case '"':
      return "&quot;";
    case '\'':
      return "&#39;";
    default:
      return {};
  }
}

}  // namespace

std::string escape_markup(std::string_view text) {
  std::string out;
  for (const char c : clean_text(text)) {
    const std::string_view e = entity(c);
    if (e.empty()) {
      out += c;
    } else {
      out += e;
    }
  }
  return out;
}

std::size_t code_points(std::string_view text) {
  return std::count_if(text.begin(), text.end(),
                       [](char c) { return (static_cast<unsigned char>(c) & 0xC0) != 0x80; });
}

std::string shortened(std::string_view text, std::size_t width) {
  std::string whole = clean_text(text);
  std::replace(whole.begin(), whole.end(), '\n', ' ');
  std::replace(whole.begin(), whole.end(), '\t', ' ');
  if (code_points(whole) <= width) return whole;
  std::size_t end = 0;
  for (std::size_t seen = 0; end < whole.size(); ++end) {
    if ((static_cast<unsigned char>(whole[end]) & 0xC0) != 0x80 && ++seen == width) break;
  }
  return whole.substr(0, end) + "…";
}

std::string three_digits(double value) {
  const double size = std::abs(value);
  if (size != 0 && size < 1e-4) {
    std::array<char, 32> buffer{};
    const auto end = std::to_chars(buffer.data(), buffer.data() + buffer.size(), value,
                                   std::chars_format::scientific, 2)
                         .ptr;
    return {buffer.data(), end};
  }
  return fixed(value, model::significant_decimals(value, 3));
}

std::string grouped(std::uint64_t count) {
  std::string digits = std::to_string(count);
  if (digits.size() < 5) return digits;
  for (std::size_t i = digits.size() - 3; i > 0 && i < digits.size();
       i -= std::min<std::size_t>(3, i))
    digits.insert(i, "\u202F");
  return digits;
}

LengthUnit unit_for(double largest_mm) {
  return std::abs(largest_mm) < 0.1 ? LengthUnit{1000, "µm"} : LengthUnit{1, "mm"};
}

std::string measured_length(double mm) {
  const LengthUnit unit = unit_for(mm);
  return three_digits(mm * unit.per_mm) + " " + unit.symbol;
}

std::string stated_length(double mm) {
  if (mm == 0) return "0 mm";
  const LengthUnit unit = unit_for(mm);
  // A decimal of the job file times 1000 may carry binary dust in its last digit.
  return model::shortest(std::round(mm * unit.per_mm * 1e9) / 1e9) + " " + unit.symbol;
}

std::string duration_text(double seconds) {
  if (seconds < 0.95) return fixed(seconds, seconds < 0.095 ? 2 : 1) + " s";
  if (seconds < 59.95) return fixed(seconds, 1) + " s";
  const auto whole = static_cast<std::uint64_t>(std::llround(seconds));
  const auto two = [](std::uint64_t n) { return std::to_string(100 + n).substr(1); };
  if (whole < 3600) return std::to_string(whole / 60) + " min " + two(whole % 60) + " s";
  return std::to_string(whole / 3600) + " h " + two(whole % 3600 / 60) + " min";
}

std::string clock_text(double seconds) {
  const auto whole = static_cast<std::uint64_t>(std::llround(std::max(seconds, 0.0)));
  const auto two = [](std::uint64_t n) { return std::to_string(100 + n).substr(1); };
  return std::to_string(whole / 3600) + ":" + two(whole % 3600 / 60) + ":" + two(whole % 60);
}

std::string bytes_text(std::size_t bytes) {
  const auto size = static_cast<double>(bytes);
  if (size < 999.5) return std::to_string(bytes) + " bytes";
  if (size < 999.5e3) return three_digits(size / 1e3) + " kB";
  if (size < 999.5e6) return three_digits(size / 1e6) + " MB";
  return three_digits(size / 1e9) + " GB";
}

std::string verdict_text(verifier::Verdict verdict) {
  return verdict == verifier::Verdict::not_run ? "not run" : verifier::name(verdict);
}

std::string percent_text(double share) {
  return model::rounded_text(share * 100, 2, model::Rounding::down) + " %";
}

namespace {

/// What makes a formula of a cell in one spreadsheet or another; the last four are the full-width
/// forms that some take for the others.
constexpr std::array<std::string_view, 8> kFormulaHeads = {"=",  "+",  "-",  "@",
                                                           "＝", "＋", "－", "＠"};

bool may_be_formula(std::string_view text) {
  text.remove_prefix(std::min(text.find_first_not_of(" \t\n"), text.size()));
  return std::any_of(kFormulaHeads.begin(), kFormulaHeads.end(),
                     [&](std::string_view head) { return text.starts_with(head); });
}

}  // namespace

std::string joined(const std::vector<std::string>& parts, std::string_view between) {
  std::string out;
  for (std::size_t k = 0; k < parts.size(); ++k) {
    if (k > 0) out += between;
    out += parts[k];
  }
  return out;
}

std::string csv_text_cell(std::string_view text) {
  const std::string clean = clean_text(text);
  std::string out = may_be_formula(clean) ? "\"'" : "\"";
  for (const char c : clean) out.append(c == '"' ? 2 : 1, c);
  return out + '"';
}

std::string base64(std::string_view bytes) {
  constexpr std::string_view kDigits =
      "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string out;
  out.reserve((bytes.size() + 2) / 3 * 4);
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    const std::size_t n = std::min<std::size_t>(3, bytes.size() - i);
    unsigned word = 0;
    for (std::size_t k = 0; k < 3; ++k)
      word = word << 8 | (k < n ? static_cast<unsigned char>(bytes[i + k]) : 0U);
    for (std::size_t k = 0; k < 4; ++k) out += k <= n ? kDigits[word >> (18 - 6 * k) & 63] : '=';
  }
  return out;
}

}  // namespace limitgauge::reports
