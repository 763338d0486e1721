#include "reports/sarif/fingerprint.h"

#include <array>
#include <cctype>
#include <cmath>
#include <cstdint>

#include "model/text/characters.h"
#include "model/text/hexadecimal.h"

namespace limitgauge::reports::sarif {
namespace {

constexpr double kCell_mm = 2, kOffset = 0.381966;

std::string cell(double coordinate_mm) {
  return std::to_string(std::llround(std::floor(coordinate_mm / kCell_mm + kOffset)));
}

std::string identity(const char* form, const ListedFinding& f, std::string_view stage) {
  std::string text = std::string(form) + "\n" + f.kind + "\n";
  text.append(stage).append("\n" + f.body + "\n");
  return text + (f.process ? f.process->against : std::string()) + "\n";
}

/// Without what stands in parentheses, and what follows a semicolon.
std::string without_comments(std::string_view line) {
  std::string out;
  bool inside = false;
  for (const char c : line) {
    if (!inside && c == ';') break;
    if (c == '(') inside = true;
    if (!inside) out += c;
    if (c == ')') inside = false;
  }
  return out;
}

}  // namespace

std::string hash_text(std::string_view text) {
  std::uint64_t hash = 0xcbf29ce484222325;
  for (const char c : text) hash = (hash ^ static_cast<unsigned char>(c)) * 0x100000001b3;
  std::string digits;
  for (int shift = 56; shift >= 0; shift -= 8)
    digits += model::hexadecimal(static_cast<unsigned char>(hash >> shift));
  return digits;
}

std::string normalised_line(std::string_view line) {
  std::string out;
  for (const char c : without_comments(line))
    if (!std::isspace(static_cast<unsigned char>(c)))
      out += static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
  if (!out.starts_with('N')) return out;
  std::size_t end = 1;
  while (end < out.size() && model::is_digit(out[end])) ++end;
  return end > 1 ? out.substr(end) : out;
}

std::string place_fingerprint(const ListedFinding& f, std::string_view stage) {
  return hash_text(identity("place/1", f, stage) + cell(f.about.x) + "," + cell(f.about.y) + "," +
                   cell(f.about.z) + "\n");
}

std::string line_fingerprint(const ListedFinding& f, std::string_view stage,
                             std::string_view program_line) {
  return hash_text(identity("line/1", f, stage) + normalised_line(program_line) + "\n");
}

}  // namespace limitgauge::reports::sarif
