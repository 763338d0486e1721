#include "model/mesh/mesh_stl.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "model/base/byte_reader.h"
#include "model/base/error.h"
#include "model/mesh/obj_lexer.h"
#include "model/text/message_text.h"
#include "model/text/number_text.h"

namespace limitgauge::model {
namespace {

constexpr std::size_t kHeaderBytes = 84, kTriangleBytes = 50, kNormalBytes = 12;

std::uint32_t stated_count(std::string_view bytes) {
  return number_in<std::uint32_t>(bytes.substr(80), std::endian::little);
}

Vec3 binary_point(std::string_view bytes, std::size_t at, const std::string& name) {
  Vec3 p;
  for (int a = 0; a < 3; ++a) {
    p[a] =
        number_in<float>(bytes.substr(at + 4 * static_cast<std::size_t>(a)), std::endian::little);
    if (!std::isfinite(p[a]))
      fail_at_byte(name, at + 4 * static_cast<std::size_t>(a),
                   "triangle " + std::to_string((at - kHeaderBytes) / kTriangleBytes + 1) +
                       ": a coordinate is not a finite number",
                   "millimetres");
  }
  return p;
}

/// Keywords are in lower case here.
bool is_word(std::string_view text, std::string_view keyword) {
  return std::ranges::equal(text, keyword, [](char a, char b) {
    return (a >= 'A' && a <= 'Z' ? static_cast<char>(a - 'A' + 'a') : a) == b;
  });
}

class AsciiReader {
 public:
  AsciiReader(std::string_view text, const std::string& name) : lexer_(text, name) {
    soup_.file = name;
  }

  TriangleSoup read() {
    while (lexer_.next_statement()) solid();
    return std::move(soup_);
  }

 private:
  void solid() {
    expect(lexer_.word(), "solid");
    lexer_.skip_statement();  // its name
    for (;;) {
      const ObjWord word = next_line("'facet' or 'endsolid'");
      if (is_word(word.text, "endsolid")) return lexer_.skip_statement();
      expect(word, "facet");
      facet(word.line);
    }
  }

  void facet(std::uint32_t line) {
    expect(lexer_.word(), "normal");
    for (int k = 0; k < 3; ++k)
      if (const ObjWord word = lexer_.word(); word.text.empty()) fail(word, "three numbers");
    end_line();
    expect(next_line("'outer loop'"), "outer");
    expect(lexer_.word(), "loop");
    end_line();
    const auto first = static_cast<std::uint32_t>(soup_.vertices.size());
    for (int k = 0; k < 3; ++k) vertex();
    expect(next_line("'endloop'"), "endloop");
    end_line();
    expect(next_line("'endfacet'"), "endfacet");
    end_line();
    soup_.add({first, first + 1, first + 2}, line);
  }

  void vertex() {
    expect(next_line("'vertex'"), "vertex");
    Vec3 p;
    for (int a = 0; a < 3; ++a) {
      const ObjWord word = lexer_.word();
      const std::optional<double> value = parse_number(word.text);
      if (!value) fail(word, "a coordinate");
      p[a] = *value;
    }
    end_line();
    soup_.vertices.push_back(p);
  }

  ObjWord next_line(const char* expected) {
    if (!lexer_.next_statement())
      throw InputError({lexer_.name()}, "the file ends in the middle of a solid", expected);
    return lexer_.word();
  }
  void end_line() {
    if (const ObjWord word = lexer_.word(); !word.text.empty()) fail(word, "the end of the line");
  }
  void expect(const ObjWord& word, std::string_view keyword) {
    if (!is_word(word.text, keyword)) fail(word, "'" + std::string(keyword) + "'");
  }
  [[noreturn]] void fail(const ObjWord& word, const std::string& expected) const {
    throw InputError(
        lexer_.place(word),
        word.text.empty() ? "the line ends here" : in_quotes(word.text) + " stands here", expected);
  }

  ObjLexer lexer_;
  TriangleSoup soup_;
};

}  // namespace

bool has_binary_stl_size(std::string_view bytes) {
  return bytes.size() >= kHeaderBytes &&
         bytes.size() - kHeaderBytes == std::size_t{stated_count(bytes)} * kTriangleBytes;
}

TriangleSoup read_binary_stl(std::string_view bytes, const std::string& name) {
  if (bytes.size() < kHeaderBytes)
    throw InputError({name}, "the file of " + std::to_string(bytes.size()) + " bytes is cut short",
                     "an STL file");
  const std::size_t count = stated_count(bytes);
  if (!has_binary_stl_size(bytes))
    fail_at_byte(name, 80,
                 "the file states " + std::to_string(count) + " triangles but has " +
                     std::to_string(bytes.size()) + " bytes",
                 std::to_string(kHeaderBytes + count * kTriangleBytes) + " bytes of a binary STL");
  TriangleSoup soup;
  soup.file = name, soup.binary = true;
  soup.vertices.reserve(3 * count), soup.triangles.reserve(count), soup.places.reserve(count);
  for (std::size_t i = 0; i < count; ++i) {
    const std::size_t at = kHeaderBytes + i * kTriangleBytes;
    const auto first = static_cast<std::uint32_t>(3 * i);
    for (std::size_t k = 0; k < 3; ++k)
      soup.vertices.push_back(binary_point(bytes, at + kNormalBytes + 12 * k, name));
    soup.add({first, first + 1, first + 2}, at);
  }
  return soup;
}

TriangleSoup read_ascii_stl(std::string_view text, const std::string& name) {
  return AsciiReader(text, name).read();
}

}  // namespace limitgauge::model
