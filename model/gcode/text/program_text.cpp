#include "model/gcode/text/program_text.h"

#include <algorithm>
#include <array>
#include <fstream>
#include <optional>

#include "model/base/error.h"
#include "model/base/text_file.h"
#include "model/text/characters.h"

namespace limitgauge::model {
namespace {

/// No line of a program is as long; what is longer is no text, and must not fill the memory.
constexpr std::size_t kMostLoadedLine = 1'000'000;

enum class Encoding { bytes, utf16_little, utf16_big };

/// Two bytes a character, one of them 0: with a mark, or where the first characters all are so.
Encoding encoding_of(std::string_view bytes) {
  if (bytes.starts_with("\xFF\xFE")) return Encoding::utf16_little;
  if (bytes.starts_with("\xFE\xFF")) return Encoding::utf16_big;
  constexpr std::size_t kEnough = 4, kMost = 64;
  if (bytes.size() < kEnough) return Encoding::bytes;
  const std::size_t count = std::min(bytes.size(), kMost) / 2;
  const auto all_zero = [&](std::size_t first) {
    for (std::size_t i = 0; i < count; ++i) {
      if (bytes[2 * i + first] != '\0' || bytes[2 * i + 1 - first] == '\0') return false;
    }
    return true;
  };
  if (all_zero(1)) return Encoding::utf16_little;
  return all_zero(0) ? Encoding::utf16_big : Encoding::bytes;
}

void add_utf8(std::string& text, std::uint32_t c) {
  if (c < 0x80) {
    text += static_cast<char>(c);
  } else if (c < 0x800) {
    text += static_cast<char>(0xC0U | c >> 6U);
    text += static_cast<char>(0x80U | (c & 0x3FU));
  } else {
    text += static_cast<char>(0xE0U | c >> 12U);
    text += static_cast<char>(0x80U | (c >> 6U & 0x3FU));
    text += static_cast<char>(0x80U | (c & 0x3FU));
  }
}

std::string from_utf16(std::string_view bytes, bool little, const std::string& name) {
  if (bytes.size() % 2 != 0)
    throw InputError({name}, "UTF-16 of an odd number of bytes: it may have been cut off",
                     "the whole file");
  std::string text;
  text.reserve(bytes.size() / 2);
  for (std::size_t i = 0; i < bytes.size(); i += 2) {
    const std::uint32_t low = static_cast<unsigned char>(bytes[little ? i : i + 1]);
    const std::uint32_t high = static_cast<unsigned char>(bytes[little ? i + 1 : i]);
    const std::uint32_t c = high << 8U | low;
    if (i > 0 || c != 0xFEFF) add_utf8(text, c);
  }
  return text;
}

/// Whether carriage returns alone end lines.
bool has_bare_returns(std::string_view text) {
  for (std::size_t at = text.find('\r'); at != std::string_view::npos;
       at = text.find('\r', at + 1)) {
    if (at + 1 < text.size() && text[at + 1] != '\n' && text[at + 1] != '\r')
      return text.find('\n') == std::string_view::npos;
  }
  return false;
}

[[noreturn]] void refuse_line(const std::filesystem::path& path, std::size_t line) {
  throw InputError({path.string(), static_cast<int>(line), static_cast<int>(kMostLoadedLine) + 1},
                   "a line of more than 1000000 bytes", "a program as text, in lines");
}

/// The file in one piece, given up where a line does not end.
std::string load(std::ifstream& in, const std::filesystem::path& path) {
  std::string text;
  std::array<char, 1 << 16> block{};
  std::size_t line = 1, line_begin = 0;
  while (in) {
    in.read(block.data(), static_cast<std::streamsize>(block.size()));
    const std::string_view read(block.data(), static_cast<std::size_t>(in.gcount()));
    const std::size_t last = read.find_last_of("\r\n");
    if (last != std::string_view::npos) {
      line += static_cast<std::size_t>(std::count(read.begin(), read.end(), '\n'));
      line_begin = text.size() + last + 1;
    }
    text += read;
    if (text.size() - line_begin > kMostLoadedLine) refuse_line(path, line);
  }
  if (in.bad()) throw InputError({path.string()}, "the file cannot be read to its end");
  return text;
}

}  // namespace

std::string as_program_text(std::string_view bytes, const std::string& name) {
  std::string text;
  const Encoding encoding = encoding_of(bytes);
  if (encoding != Encoding::bytes)
    text = from_utf16(bytes, encoding == Encoding::utf16_little, name);
  if (!has_bare_returns(text.empty() ? bytes : text)) return text;
  if (text.empty()) text = bytes;
  std::replace(text.begin(), text.end(), '\r', '\n');
  return text;
}

std::string read_program_text(const std::filesystem::path& path) {
  std::string bytes;
  if (is_file(path)) {
    std::ifstream in(path, std::ios::binary);
    if (!in) throw InputError({path.string()}, "the file cannot be opened for reading");
    bytes = load(in, path);
  } else {
    bytes = read_text_file(path);
  }
  std::string text = as_program_text(bytes, path.string());
  if (text.empty()) text = std::move(bytes);
  if (text.find_first_not_of(" \t\r\n") == std::string::npos)
    throw InputError({path.string()}, "the file is empty", "a program as G-code or CL data");
  return text;
}

namespace gcode {
namespace {

/// Bytes of a dash or minus sign that begins at `at`; 0: there is none.
std::size_t dash_bytes(std::string_view text, std::size_t at) {
  const auto byte = [&](std::size_t i) {
    return at + i < text.size() ? static_cast<unsigned char>(text[at + i]) : 0U;
  };
  if (byte(0) == 0xE2 && byte(1) == 0x80 && byte(2) >= 0x90 && byte(2) <= 0x95) return 3;
  if (byte(0) == 0xE2 && byte(1) == 0x88 && byte(2) == 0x92) return 3;
  const bool alone = at == 0 || static_cast<unsigned char>(text[at - 1]) < 0x80;
  return alone && (byte(0) == 0x96 || byte(0) == 0x97) && byte(1) < 0x80 ? 1 : 0;
}

/// U+00A0 and U+2000 to U+200A.
std::size_t space_bytes(std::string_view text, std::size_t at) {
  const auto byte = [&](std::size_t i) {
    return at + i < text.size() ? static_cast<unsigned char>(text[at + i]) : 0U;
  };
  if (byte(0) == 0xC2 && byte(1) == 0xA0) return 2;
  return byte(0) == 0xE2 && byte(1) == 0x80 && byte(2) >= 0x80 && byte(2) <= 0x8A ? 3 : 0;
}

bool begins_number(std::string_view text, std::size_t at) {
  while (at < text.size() && text[at] == ' ') ++at;
  return at < text.size() &&
         (is_digit(text[at]) || text[at] == '.' || text[at] == '#' || text[at] == '[');
}

/// Mends one line of `text`, from `begin` to `end`.
void mend_line(std::string& text, std::size_t begin, std::size_t end, std::uint32_t line,
               std::vector<MendedCharacter>& found) {
  constexpr std::size_t kMostFound = 1000;
  const auto mend = [&](std::size_t at, std::size_t bytes, char by) {
    std::fill_n(text.begin() + static_cast<std::ptrdiff_t>(at), bytes, ' ');
    text[at] = by;
    if (found.size() < kMostFound)
      found.push_back({line, by == '-' ? "a dash that is not ASCII's is read as '-'"
                                       : "a space that is not ASCII's is read as one"});
  };
  bool in_comment = false;
  for (std::size_t at = begin; at < end; ++at) {
    if (text[at] == ';' && !in_comment) return;
    if (text[at] == '(') in_comment = true;
    if (text[at] == ')') in_comment = false;
    if (in_comment || static_cast<unsigned char>(text[at]) < 0x80) continue;
    const std::size_t dash = dash_bytes(text, at), space = space_bytes(text, at);
    if (dash > 0 && begins_number(text, at + dash)) mend(at, dash, '-');
    if (space > 0) mend(at, space, ' ');
  }
}

bool is_high(char c) {
  return static_cast<unsigned char>(c) >= 0x80;
}

/// Many bytes at once: nearly every program is ASCII to its end.
bool holds_high(std::string_view text) {
  constexpr std::size_t kAtOnce = 4096;
  for (; !text.empty(); text.remove_prefix(std::min(kAtOnce, text.size()))) {
    unsigned char all = 0;
    for (const char c : text.substr(0, kAtOnce)) all |= static_cast<unsigned char>(c);
    if (all >= 0x80) return true;
  }
  return false;
}

/// The first words of the program that are no comment, in upper case; at most a line.
std::string first_line(std::string_view text, std::uint32_t& line) {
  for (line = 1; !text.empty(); ++line) {
    const std::size_t end = std::min(text.find('\n'), text.size());
    std::string words;
    for (const char c : text.substr(0, std::min<std::size_t>(end, 200)))
      if (!is_blank(c) || !words.empty()) words += upper(c);
    if (!words.empty() && words.front() != '%' && words.front() != ';') return words;
    text.remove_prefix(std::min(end + 1, text.size()));
  }
  return {};
}

}  // namespace

std::string mended(std::string_view text, std::vector<MendedCharacter>& found) {
  if (!holds_high(text)) return {};
  std::uint32_t line = 1;
  std::string copy(text);
  for (std::size_t begin = 0; begin < copy.size(); ++line) {
    const std::size_t end = std::min(copy.find('\n', begin), copy.size());
    const auto from = copy.begin() + static_cast<std::ptrdiff_t>(begin);
    if (std::any_of(from, copy.begin() + static_cast<std::ptrdiff_t>(end), is_high))
      mend_line(copy, begin, end, line, found);
    begin = end + 1;
  }
  return found.empty() ? std::string() : copy;
}

void check_language(std::string_view text, const std::string& name) {
  std::uint32_t line = 0;
  std::string words = first_line(text, line);
  std::size_t at = 0;
  while (at < words.size() && (is_digit(words[at]) || is_blank(words[at]))) ++at;
  words.erase(0, at);
  if (words.starts_with("BEGIN PGM"))
    throw InputError({name, static_cast<int>(line), static_cast<int>(at) + 1},
                     "this is a program in Heidenhain's conversational language",
                     "the post processor's output in G-code (DIN/ISO)");
}

}  // namespace gcode
}  // namespace limitgauge::model
