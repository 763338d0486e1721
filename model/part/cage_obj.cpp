#include "model/part/cage_obj.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <initializer_list>
#include <limits>
#include <ostream>
#include <utility>

#include "model/base/error.h"
#include "model/base/text_file.h"
#include "model/mesh/mesh_shells.h"
#include "model/mesh/obj_lexer.h"
#include "model/part/cage_tags.h"
#include "model/text/message_text.h"
#include "model/text/number_text.h"

namespace limitgauge::model {
namespace {

constexpr std::array<std::string_view, 10> kWithoutMeaning = {
    "vt", "vn", "vp", "g", "o", "s", "mg", "usemtl", "mtllib", "usemap"};
constexpr std::array<std::string_view, 9> kStatements = {"v", "f", "t",      "vt",    "vn",
                                                         "g", "s", "usemtl", "mtllib"};

/// The faces of a cage as triangles about their middles, without those that are holes.
struct FannedCage {
  TriangleMesh mesh;
  std::vector<Index> face_of;  ///< of each triangle
};

FannedCage fanned(const Cage& cage) {
  FannedCage out;
  out.mesh.vertices = cage.vertices;
  std::vector<bool> is_hole(static_cast<std::size_t>(cage.face_count()));
  for (const Index f : cage.holes) is_hole[static_cast<std::size_t>(f)] = true;
  for (Index f = 0; f < cage.face_count(); ++f) {
    if (is_hole[static_cast<std::size_t>(f)]) continue;
    const auto face = cage.face(f);
    Vec3 sum;
    for (const Index v : face) sum += cage.vertices[v];
    const auto middle = static_cast<std::uint32_t>(out.mesh.vertices.size());
    out.mesh.vertices.push_back(sum / static_cast<double>(face.size()));
    for (std::size_t k = 0; k < face.size(); ++k) {
      out.mesh.triangles.push_back({static_cast<std::uint32_t>(face[k]),
                                    static_cast<std::uint32_t>(face[(k + 1) % face.size()]),
                                    middle});
      out.face_of.push_back(f);
    }
  }
  return out;
}

class ObjReader {
 public:
  ObjReader(std::string_view text, const std::string& name) : lexer_(text, name), tags_(lexer_) {
    cage_.ends_in_line = text.ends_with('\n');
  }

  Cage read() {
    while (lexer_.next_statement()) statement(lexer_.word());
    if (cage_.face_count() == 0)
      throw InputError({lexer_.name()}, "the file has no faces", "a cage with 'v' and 'f' lines");
    check_corners();
    check_manifold();
    if (!cage_.ends_in_line && ends_in_face_) check_last_face();
    tags_.apply(cage_);
    check_bodies();
    return std::move(cage_);
  }

 private:
  struct Place {
    std::uint32_t line = 0, column = 0;
  };

  void statement(const ObjWord& word) {
    ends_in_face_ = word.text == "f";
    if (word.text == "v") return vertex(word);
    if (word.text == "f") return face(word);
    if (word.text == "t") return tags_.read();
    if (std::ranges::find(kWithoutMeaning, word.text) != kWithoutMeaning.end())
      return lexer_.skip_statement();
    const std::string near = meant_word(word.text, kStatements);
    lexer_.fail(word, "unknown statement " + in_quotes(word.text),
                near.empty() ? "v, f, t or a comment" : in_quotes(near));
  }

  void vertex(const ObjWord& statement) {
    cage_.vertices.push_back(lexer_.vertex(statement));
    require_countable(cage_.vertices.size(), statement);
  }

  void face(const ObjWord& statement) {
    face_places_.push_back({statement.line, statement.column});
    const std::size_t before = cage_.face_corners.size();
    for (ObjWord word = lexer_.word(); !word.text.empty(); word = lexer_.word()) {
      cage_.face_corners.push_back(corner(word));
      corner_places_.push_back({word.line, word.column});
    }
    const std::size_t corners = cage_.face_corners.size() - before;
    if (corners < 3)
      lexer_.fail(statement, "a face with " + std::to_string(corners) + " corners",
                  "three or more");
    require_countable(cage_.face_corners.size(), statement);
    cage_.face_offsets.push_back(static_cast<Index>(cage_.face_corners.size()));
  }

  /// `v`, `v/vt`, `v//vn` or `v/vt/vn`; the vertex as a 0-based index.
  Index corner(const ObjWord& word) {
    const std::size_t slash = std::min(word.text.find('/'), word.text.size());
    const Index written = index(word, word.text.substr(0, slash));
    if (slash < word.text.size()) check_unused_indices(word, word.text.substr(slash + 1));
    if (written > 0) return written - 1;
    const Index count = static_cast<Index>(cage_.vertices.size());
    if (-written > count)
      lexer_.fail(word, "vertex " + std::to_string(written) + " counts back past the first vertex",
                  "at most " + std::to_string(count) + " back");
    return count + written;
  }

  void check_unused_indices(const ObjWord& word, std::string_view rest) {
    const std::size_t slash = rest.find('/');
    const bool has_normal = slash != std::string_view::npos;
    const std::string_view texture = rest.substr(0, slash);
    if (!texture.empty() || !has_normal) index(word, texture);
    if (has_normal) index(word, rest.substr(slash + 1));
  }

  Index index(const ObjWord& word, std::string_view text) {
    Index value = 0;
    const auto [stop, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (error == std::errc::result_out_of_range)
      lexer_.fail(word, "index " + in_quotes(text) + " is beyond what is readable",
                  "at most 2147483647");
    if (error != std::errc() || stop != text.data() + text.size())
      lexer_.fail(word, in_quotes(word.text) + " is no face corner", "v, v/vt, v//vn or v/vt/vn");
    if (value == 0 || value == std::numeric_limits<Index>::min())
      lexer_.fail(word, "index " + std::to_string(value) + " in " + in_quotes(word.text),
                  "indices count from 1, or from -1 backwards");
    return value;
  }

  /// Vertices may follow the faces that name them, so ranges are known only now.
  void check_corners() {
    std::vector<Index> last_face(cage_.vertices.size(), cage_.face_count());
    for (Index f = 0; f < cage_.face_count(); ++f) {
      for (Index c = cage_.face_offsets[f]; c < cage_.face_offsets[f + 1]; ++c) {
        const Index v = cage_.face_corners[c];
        if (v >= static_cast<Index>(cage_.vertices.size()))
          fail(corner_places_[c], "there is no vertex " + std::to_string(v + 1LL),
               "at most " + std::to_string(cage_.vertices.size()));
        if (last_face[v] == f)
          fail(corner_places_[c], "vertex " + std::to_string(v + 1) + " stands twice in this face",
               "different corners");
        last_face[v] = f;
      }
    }
  }

  void check_manifold() {
    const std::vector<CageDefect> defects = find_defects(cage_);
    if (defects.empty()) return;
    fail(face_places_[defects.front().face], describe(defects.front()),
         "a two-manifold cage whose faces all turn the same way");
  }

  /// What a body that is inside out needs cut is what others need to stand.
  void check_bodies() {
    const FannedCage fans = fanned(cage_);
    const MeshShells all = shells_of(fans.mesh);
    if (const auto shell = inside_out_shell(fans.mesh, all))
      fail(face_places_[fans.face_of[all.shells[*shell].first_triangle]],
           "this face is of a closed body that is inside out and no cavity of another: its normals "
           "point into the material",
           "corners that go round counter-clockwise seen from outside");
  }

  /// Some programs end no last line, so that its lack alone says little; with a face that looks cut
  /// short it says enough: the surface would be another one.
  void check_last_face() {
    const Index last = cage_.face_count() - 1;
    const std::size_t corners = cage_.face(last).size();
    std::size_t fewest = std::numeric_limits<std::size_t>::max();
    for (Index f = 0; f < last; ++f) fewest = std::min(fewest, cage_.face(f).size());
    const bool is_least = last > 0 && corners < fewest;
    if (!is_least && !leaves_only_hole(last)) return;
    fail(face_places_[last],
         std::string("the file ends in this face, without a line end, and the face ") +
             (is_least ? "has fewer corners than any other" : "leaves the only hole of the cage") +
             ": the file may have been cut off",
         "the whole file, or a line end behind the face where it is whole");
  }

  /// Whether corners that are missing behind the last of `face` would close the cage: of the face's
  /// edges only the closing one is open, and one or two corners fill the hole there.
  bool leaves_only_hole(Index face) const {
    constexpr std::size_t kFewest = 3, kMost = 4;
    const Index closing = cage_.face_offsets[face + 1] - 1;
    std::size_t open = 0, open_of_face = 0;
    bool is_closing_open = false;
    for_each_edge(sorted_edge_uses(cage_), [&](std::span<const EdgeUse> uses) {
      if (uses.size() != 1) return;
      ++open;
      open_of_face += uses[0].face == face ? 1 : 0;
      is_closing_open = is_closing_open || uses[0].corner == closing;
    });
    return is_closing_open && open_of_face == 1 && open >= kFewest && open <= kMost;
  }

  void require_countable(std::size_t count, const ObjWord& word) {
    if (count > static_cast<std::size_t>(std::numeric_limits<Index>::max() - 1))
      lexer_.fail(word, "the cage has more than 2147483646 vertices or corners", "a smaller cage");
  }

  [[noreturn]] void fail(Place place, const std::string& wrong, const std::string& expected) const {
    lexer_.fail(ObjWord{{}, place.line, place.column}, wrong, expected);
  }

  ObjLexer lexer_;
  CageTags tags_;
  Cage cage_;
  std::vector<Place> face_places_, corner_places_;
  bool ends_in_face_ = false;
};

Cage read_text_obj(const std::string& text, const std::string& name) {
  Cage cage = ObjReader(text, name).read();
  cage.name = std::filesystem::path(name).stem().string();
  return cage;
}

void write_tag(std::ostream& out, std::string_view name, std::initializer_list<Index> ids,
               double sharpness) {
  out << "t " << name << ' ' << ids.size() << "/1/0";
  for (const Index id : ids) out << ' ' << id;
  out << ' ' << shortest(sharpness) << '\n';
}

}  // namespace

Cage read_cage_obj(const std::filesystem::path& path) {
  return read_text_obj(read_text_file(path), path.string());
}

Cage read_cage_obj(std::istream& in, const std::string& name_in_errors) {
  return read_text_obj(read_text(in, name_in_errors), name_in_errors);
}

void write_cage_obj(const Cage& cage, std::ostream& out) {
  for (const Vec3& v : cage.vertices)
    out << "v " << shortest(v.x) << ' ' << shortest(v.y) << ' ' << shortest(v.z) << '\n';
  for (Index f = 0; f < cage.face_count(); ++f) {
    out << 'f';
    for (const Index v : cage.face(f)) out << ' ' << v + 1;
    out << '\n';
  }
  for (const Crease& crease : cage.creases)
    write_tag(out, "crease", {crease.vertices[0], crease.vertices[1]}, crease.sharpness);
  for (const Corner& corner : cage.corners)
    write_tag(out, "corner", {corner.vertex}, corner.sharpness);
  for (const Index hole : cage.holes) out << "t hole 1/0/0 " << hole << '\n';
  out << "t interpolateboundary 1/0/0 " << static_cast<int>(cage.boundary) << '\n';
}

}  // namespace limitgauge::model
