#include "model/mesh/mesh_obj.h"

#include <algorithm>
#include <array>
#include <optional>
#include <utility>

#include "model/mesh/mesh_polygon.h"
#include "model/mesh/obj_lexer.h"
#include "model/text/message_text.h"
#include "model/text/number_text.h"

namespace limitgauge::model {
namespace {

constexpr std::array<std::string_view, 13> kWithoutMeaning = {
    "vt", "vn", "vp", "g", "o", "s", "l", "p", "mg", "usemtl", "mtllib", "usemap", "maplib"};

class MeshObjReader {
 public:
  MeshObjReader(std::string_view text, const std::string& name) : lexer_(text, name) {
    soup_.file = name;
  }

  TriangleSoup read() {
    while (lexer_.next_statement()) statement(lexer_.word());
    return fanned(std::move(soup_));
  }

 private:
  void statement(const ObjWord& word) {
    if (word.text == "v") return soup_.vertices.push_back(lexer_.vertex(word));
    if (word.text == "f") return face(word);
    if (std::ranges::find(kWithoutMeaning, word.text) != kWithoutMeaning.end())
      return lexer_.skip_statement();
    lexer_.fail(word, "unknown statement " + in_quotes(word.text), "v, f or a comment");
  }

  void face(const ObjWord& statement) {
    const std::size_t before = soup_.corners.size();
    for (ObjWord word = lexer_.word(); !word.text.empty(); word = lexer_.word())
      soup_.corners.push_back(corner(word));
    const std::size_t corners = soup_.corners.size() - before;
    if (corners < 3)
      lexer_.fail(statement, "a face with " + std::to_string(corners) + " corners",
                  "three or more");
    soup_.ends.push_back(soup_.corners.size());
    soup_.places.push_back(statement.line);
  }

  /// The vertex that a corner names, from 0.
  std::uint32_t corner(const ObjWord& word) {
    const std::string_view text = word.text.substr(0, word.text.find('/'));
    const std::optional<std::int64_t> index = parse_whole<std::int64_t>(text);
    if (!index)
      lexer_.fail(word, in_quotes(word.text) + " is no face corner", "v, v/vt, v//vn or v/vt/vn");
    const auto known = static_cast<std::int64_t>(soup_.vertices.size());
    const std::int64_t vertex = *index > 0 ? *index - 1 : known + *index;
    if (*index == 0 || vertex < 0 || vertex >= std::int64_t{UINT32_MAX})
      lexer_.fail(word, "there is no vertex " + std::to_string(*index),
                  "indices from 1, or from -1 backwards");
    return static_cast<std::uint32_t>(vertex);
  }

  ObjLexer lexer_;
  PolygonSoup soup_;
};

}  // namespace

TriangleSoup read_mesh_obj(std::string_view text, const std::string& name) {
  return MeshObjReader(text, name).read();
}

}  // namespace limitgauge::model
