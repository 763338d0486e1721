#include <algorithm>
#include <array>
#include <utility>

#include "model/base/error.h"
#include "model/mesh/mesh_ply.h"
#include "model/text/message_text.h"
#include "model/text/number_text.h"

namespace limitgauge::model {
namespace {

struct TypeName {
  std::string_view name;
  PlyType type;
};
constexpr std::array<TypeName, 16> kTypes = {{{"char", PlyType::int8},
                                              {"int8", PlyType::int8},
                                              {"uchar", PlyType::uint8},
                                              {"uint8", PlyType::uint8},
                                              {"short", PlyType::int16},
                                              {"int16", PlyType::int16},
                                              {"ushort", PlyType::uint16},
                                              {"uint16", PlyType::uint16},
                                              {"int", PlyType::int32},
                                              {"int32", PlyType::int32},
                                              {"uint", PlyType::uint32},
                                              {"uint32", PlyType::uint32},
                                              {"float", PlyType::float32},
                                              {"float32", PlyType::float32},
                                              {"double", PlyType::float64},
                                              {"float64", PlyType::float64}}};

struct Word {
  std::string_view text;
  int column = 0;
};

std::vector<Word> words_of(std::string_view line) {
  std::vector<Word> words;
  for (std::size_t at = 0; at < line.size();) {
    const std::size_t begin = line.find_first_not_of(" \t", at);
    if (begin == std::string_view::npos) break;
    at = std::min(line.find_first_of(" \t", begin), line.size());
    words.push_back({line.substr(begin, at - begin), static_cast<int>(begin) + 1});
  }
  return words;
}

class HeaderReader {
 public:
  HeaderReader(std::string_view bytes, const std::string& name) : rest_(bytes), name_(name) {}

  PlyHeader read() {
    const std::size_t size = rest_.size();
    next_line();
    if (words_.size() != 1 || words_[0].text != "ply") fail(0, "the file is no PLY", "'ply'");
    next_line();
    format();
    for (next_line(); word(0) != "end_header"; next_line()) statement();
    header_.bytes = size - rest_.size();
    return std::move(header_);
  }

 private:
  void next_line() {
    const std::size_t end = rest_.find('\n');
    if (end == std::string_view::npos)
      throw InputError({name_}, "the file ends in its header", "'end_header'");
    std::string_view line = rest_.substr(0, end);
    rest_.remove_prefix(end + 1);
    if (line.ends_with('\r')) line.remove_suffix(1);
    words_ = words_of(line);
    ++header_.lines;
  }

  void format() {
    if (word(0) != "format") fail(0, in_quotes(word(0)) + " stands here", "'format'");
    if (word(1) == "binary_little_endian")
      header_.order = std::endian::little;
    else if (word(1) == "binary_big_endian")
      header_.order = std::endian::big;
    else if (word(1) != "ascii")
      fail(1, "unknown format " + in_quotes(word(1)),
           "ascii, binary_little_endian or binary_big_endian");
    if (word(2) != "1.0") fail(2, "unknown version " + in_quotes(word(2)), "1.0");
  }

  void statement() {
    if (words_.empty() || word(0) == "comment" || word(0) == "obj_info") return;
    if (word(0) == "element") return element();
    if (word(0) == "property") return property();
    fail(0, in_quotes(word(0)) + " stands here", "element, property, comment or end_header");
  }

  void element() {
    const std::string_view text = word(2);
    PlyElement e{std::string(word(1)), 0, header_.lines, {}};
    const auto count = parse_whole<decltype(e.count)>(text);
    if (words_.size() != 3 || !count)
      fail(2, in_quotes(text) + " is no number of elements", "'element NAME COUNT'");
    e.count = *count;
    header_.elements.push_back(std::move(e));
  }

  void property() {
    if (header_.elements.empty()) fail(0, "a property of no element", "'element' before it");
    PlyProperty p;
    const bool list = word(1) == "list";
    if (words_.size() != (list ? 5U : 3U))
      fail(0, "a property of " + std::to_string(words_.size() - 1) + " words",
           "'property TYPE NAME' or 'property list TYPE TYPE NAME'");
    if (list) p.list_count = type(2);
    if (p.list_count == PlyType::float32 || p.list_count == PlyType::float64)
      fail(2, "a list's length of type " + in_quotes(word(2)), "an integer type");
    p.type = type(list ? 3 : 1);
    p.name = words_.back().text;
    header_.elements.back().properties.push_back(std::move(p));
  }

  PlyType type(std::size_t at) {
    const auto found = std::ranges::find(kTypes, word(at), &TypeName::name);
    if (found == kTypes.end())
      fail(at, "unknown type " + in_quotes(word(at)), "a type such as float, double, uchar or int");
    return found->type;
  }

  std::string_view word(std::size_t at) const {
    return at < words_.size() ? words_[at].text : std::string_view();
  }
  [[noreturn]] void fail(std::size_t at, const std::string& wrong,
                         const std::string& expected) const {
    throw InputError({name_, header_.lines, at < words_.size() ? words_[at].column : 1}, wrong,
                     expected);
  }

  std::string_view rest_;
  std::string name_;
  std::vector<Word> words_;
  PlyHeader header_;
};

}  // namespace

std::size_t bytes_of(PlyType type) {
  switch (type) {
    case PlyType::int8:
    case PlyType::uint8:
      return 1;
    case PlyType::int16:
    case PlyType::uint16:
      return 2;
    case PlyType::float64:
      return 8;
    default:
      return 4;
  }
}

PlyHeader read_ply_header(std::string_view bytes, const std::string& name) {
  return HeaderReader(bytes, name).read();
}

}  // namespace limitgauge::model
