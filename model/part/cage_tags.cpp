#include "model/part/cage_tags.h"

#include <algorithm>
#include <map>
#include <optional>
#include <utility>

#include "model/part/cage.h"
#include "model/text/message_text.h"
#include "model/text/number_text.h"

namespace limitgauge::model {
namespace {

constexpr std::array<std::string_view, 4> kTags = {"crease", "corner", "hole",
                                                   "interpolateboundary"};
/// Tags about texture coordinates alone.
constexpr std::array<std::string_view, 2> kTextureTags = {"facevaryinginterpolateboundary",
                                                          "facevaryingpropagatecorners"};

using Edge = std::array<Index, 2>;

Edge edge_between(Index a, Index b) {
  return {std::min(a, b), std::max(a, b)};
}

std::vector<Edge> edges_of(const Cage& cage) {
  std::vector<Edge> edges;
  for_each_edge(sorted_edge_uses(cage), [&](std::span<const EdgeUse> uses) {
    edges.push_back({uses[0].low, uses[0].high});
  });
  return edges;
}

}  // namespace

void CageTags::read() {
  Tag tag;
  tag.name = lexer_.word();
  if (std::ranges::find(kTextureTags, tag.name.text) != kTextureTags.end())
    return lexer_.skip_statement();
  if (std::ranges::find(kTags, tag.name.text) == kTags.end()) {
    const std::string near = meant_word(tag.name.text, kTags);
    lexer_.fail(tag.name, "unknown tag " + in_quotes(tag.name.text),
                near.empty() ? "crease, corner, hole or interpolateboundary" : in_quotes(near));
  }
  const std::array<int, 3> counts = read_counts();
  read_ids(tag, counts[0]);
  read_sharpness(tag, counts[1]);
  if (const ObjWord rest = lexer_.word(); !rest.text.empty())
    lexer_.fail(rest, "more values than the tag's counts say", "the end of the line");
  const std::array lists = {&creases_, &corners_, &holes_, &boundaries_};
  const auto which = std::ranges::find(kTags, tag.name.text) - kTags.begin();
  require_counts(tag, which == 0 ? 2 : 1, which < 2);
  lists[which]->push_back(std::move(tag));
}

std::array<int, 3> CageTags::read_counts() {
  const ObjWord word = lexer_.word();
  if (word.text.empty())
    lexer_.fail(word, "the tag has no values", "counts and values as in 2/1/0");
  std::array<int, 3> counts{};
  std::string_view rest = word.text;
  for (std::size_t i = 0; i < counts.size(); ++i) {
    const std::size_t slash = i + 1 < counts.size() ? rest.find('/') : rest.size();
    const auto count =
        slash == std::string_view::npos ? std::nullopt : parse_whole<int>(rest.substr(0, slash));
    if (!count || *count < 0)
      lexer_.fail(word, in_quotes(word.text) + " does not count the tag's values",
                  "integers/floats/strings as in 2/1/0");
    counts[i] = *count;
    rest.remove_prefix(std::min(slash + 1, rest.size()));
  }
  if (counts[2] != 0) lexer_.fail(word, "a tag with string values", "0 strings as in 2/1/0");
  return counts;
}

ObjWord CageTags::value_word(const Tag& tag) {
  const ObjWord word = lexer_.word();
  if (word.text.empty())
    lexer_.fail(tag.name, "the tag has fewer values than its counts say", "all of its values");
  return word;
}

void CageTags::read_ids(Tag& tag, int count) {
  for (int i = 0; i < count; ++i) {
    const ObjWord word = value_word(tag);
    const std::optional<Index> id = parse_whole<Index>(word.text);
    if (!id || *id < 0) lexer_.fail(word, in_quotes(word.text) + " is no id", "an integer from 0");
    tag.ids.push_back(*id);
    tag.id_words.push_back(word);
  }
}

void CageTags::read_sharpness(Tag& tag, int count) {
  for (int i = 0; i < count; ++i) {
    const ObjWord word = value_word(tag);
    const std::optional<double> value = parse_number(word.text);
    if (!value || *value < 0)
      lexer_.fail(word, "sharpness " + in_quotes(word.text),
                  "a number from 0 (smooth) to 10 and above (infinitely sharp)");
    tag.sharpness.push_back(*value);
  }
}

void CageTags::require_counts(const Tag& tag, std::size_t least_ids, bool with_sharpness) const {
  if (tag.ids.size() < least_ids)
    lexer_.fail(tag.name, "the tag has " + std::to_string(tag.ids.size()) + " ids",
                least_ids == 2 ? "two or more" : "one or more");
  const std::size_t places = tag.ids.size() - least_ids + 1;
  if (!with_sharpness && !tag.sharpness.empty())
    lexer_.fail(tag.name, "the tag has a sharpness", "ids only");
  if (with_sharpness && tag.sharpness.size() != 1 && tag.sharpness.size() != places)
    lexer_.fail(tag.name, "the tag has " + std::to_string(tag.sharpness.size()) + " sharpnesses",
                places == 1 ? "one" : "one, or " + std::to_string(places));
}

void CageTags::apply(Cage& cage) const {
  apply_creases(cage);
  apply_corners(cage);
  apply_holes(cage);
  apply_boundary(cage);
}

void CageTags::apply_creases(Cage& cage) const {
  if (creases_.empty()) return;
  const std::vector<Edge> edges = edges_of(cage);
  std::map<Edge, double> met;
  for (const Tag& tag : creases_) {
    for (std::size_t i = 0; i + 1 < tag.ids.size(); ++i) {
      const Edge ends = {tag.ids[i], tag.ids[i + 1]};
      const Edge edge = edge_between(ends[0], ends[1]);
      const double sharpness = tag.sharpness[tag.sharpness.size() > 1 ? i : 0];
      if (!std::ranges::binary_search(edges, edge))
        lexer_.fail(tag.id_words[i],
                    "no edge joins vertices " + std::to_string(ends[0]) + " and " +
                        std::to_string(ends[1]) + " (counted from 0)",
                    "an edge of the cage");
      const auto [known, is_new] = met.emplace(edge, sharpness);
      if (!is_new && known->second != sharpness)
        lexer_.fail(tag.id_words[i], "a second sharpness for the same edge", "one");
      if (is_new) cage.creases.push_back({ends, sharpness});
    }
  }
}

void CageTags::apply_corners(Cage& cage) const {
  std::vector<bool> used(cage.vertices.size(), false);
  for (const Index v : cage.face_corners) used[v] = true;
  std::map<Index, double> met;
  for (const Tag& tag : corners_) {
    for (std::size_t i = 0; i < tag.ids.size(); ++i) {
      const Index v = tag.ids[i];
      const double sharpness = tag.sharpness[tag.sharpness.size() > 1 ? i : 0];
      if (v >= static_cast<Index>(used.size()) || !used[v])
        lexer_.fail(tag.id_words[i],
                    "no face has vertex " + std::to_string(v) + " (counted from 0)",
                    "a vertex of the cage");
      const auto [known, is_new] = met.emplace(v, sharpness);
      if (!is_new && known->second != sharpness)
        lexer_.fail(tag.id_words[i], "a second sharpness for the same vertex", "one");
      if (is_new) cage.corners.push_back({v, sharpness});
    }
  }
}

void CageTags::apply_holes(Cage& cage) const {
  std::vector<bool> met(static_cast<std::size_t>(cage.face_count()), false);
  for (const Tag& tag : holes_) {
    for (std::size_t i = 0; i < tag.ids.size(); ++i) {
      const Index f = tag.ids[i];
      if (f >= cage.face_count())
        lexer_.fail(tag.id_words[i], "there is no face " + std::to_string(f) + " (counted from 0)",
                    "at most " + std::to_string(cage.face_count() - 1));
      if (!met[f]) cage.holes.push_back(f);
      met[f] = true;
    }
  }
}

void CageTags::apply_boundary(Cage& cage) const {
  for (const Tag& tag : boundaries_) {
    if (tag.ids.size() != 1 || tag.ids[0] > 2)
      lexer_.fail(tag.id_words[0], "boundary rule " + std::to_string(tag.ids[0]),
                  "0 (none), 1 (edge and corner) or 2 (edge only)");
    if (tag.ids[0] != boundaries_.front().ids[0])
      lexer_.fail(tag.id_words[0], "a second boundary rule that differs from the first", "one");
    cage.boundary = static_cast<BoundaryRule>(tag.ids[0]);
  }
}

}  // namespace limitgauge::model
