#pragma once

#include <array>
#include <string>
#include <vector>

#include "model/mesh/obj_lexer.h"
#include "model/part/cage.h"

namespace limitgauge::model {

/// The `t` statements of an OBJ cage: `t NAME ints/floats/strings values...`, ids from 0, as
/// OpenSubdiv's regression shapes write them. A crease tag may name a chain of vertices, with one
/// sharpness for all or one an edge.
class CageTags {
 public:
  explicit CageTags(ObjLexer& lexer) : lexer_(lexer) {}

  /// Reads one tag; the lexer stands behind the `t`.
  void read();
  /// Checks all tags against the faces and stores them in `cage`.
  void apply(Cage& cage) const;

 private:
  struct Tag {
    ObjWord name;
    std::vector<Index> ids;
    std::vector<ObjWord> id_words;
    std::vector<double> sharpness;
  };

  std::array<int, 3> read_counts();
  void read_ids(Tag& tag, int count);
  void read_sharpness(Tag& tag, int count);
  ObjWord value_word(const Tag& tag);
  void require_counts(const Tag& tag, std::size_t least_ids, bool with_sharpness) const;
  void apply_creases(Cage& cage) const;
  void apply_corners(Cage& cage) const;
  void apply_holes(Cage& cage) const;
  void apply_boundary(Cage& cage) const;

  ObjLexer& lexer_;
  std::vector<Tag> creases_, corners_, holes_, boundaries_;
};

}  // namespace limitgauge::model
