#include "model/mesh/mesh_ply.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "model/base/byte_reader.h"
#include "model/base/error.h"
#include "model/mesh/mesh_polygon.h"
#include "model/mesh/obj_lexer.h"
#include "model/text/message_text.h"
#include "model/text/number_text.h"

namespace limitgauge::model {
namespace {

/// The numbers of a binary body.
class BinaryBody {
 public:
  BinaryBody(std::string_view bytes, const PlyHeader& header, std::string name)
      : bytes_(bytes), at_(header.bytes), order_(*header.order), name_(std::move(name)) {}

  static constexpr bool kBinary = true;
  std::uint64_t place() const { return at_; }
  std::size_t left() const { return bytes_.size() - at_; }
  static std::size_t least_bytes(const PlyProperty& p) {
    return bytes_of(p.list_count.value_or(p.type));
  }
  static std::size_t item_bytes(const PlyProperty& p) { return bytes_of(p.type); }
  void begin_row() {}
  void end_row() {}
  void skip(PlyType type) { take(type); }

  double number(PlyType type) {
    const std::string_view b = take(type);
    switch (type) {
      case PlyType::int8:
        return number_in<std::int8_t>(b, order_);
      case PlyType::uint8:
        return number_in<std::uint8_t>(b, order_);
      case PlyType::int16:
        return number_in<std::int16_t>(b, order_);
      case PlyType::uint16:
        return number_in<std::uint16_t>(b, order_);
      case PlyType::int32:
        return number_in<std::int32_t>(b, order_);
      case PlyType::uint32:
        return number_in<std::uint32_t>(b, order_);
      case PlyType::float32:
        return number_in<float>(b, order_);
      case PlyType::float64:
        return number_in<double>(b, order_);
    }
    return 0;
  }

  void end() {
    last_ = at_;
    if (left() > 0)
      fail(
          "the file goes on for " + std::to_string(left()) + " bytes that its header does not know",
          "its end");
  }
  /// Where the last number stood.
  [[noreturn]] void fail(const std::string& wrong, const std::string& expected) const {
    fail_at_byte(name_, last_, wrong, expected);
  }

 private:
  std::string_view take(PlyType type) {
    const std::size_t size = bytes_of(type);
    last_ = at_;
    if (left() < size) fail("the file ends in the middle of an element", "more");
    at_ += size;
    return bytes_.substr(at_ - size, size);
  }

  std::string_view bytes_;
  std::size_t at_, last_ = at_;
  std::endian order_;
  std::string name_;
};

/// The numbers of an ASCII body, an element a line.
class AsciiBody {
 public:
  AsciiBody(std::string_view bytes, const PlyHeader& header, const std::string& name)
      : lexer_(bytes.substr(header.bytes), name),
        lines_before_(header.lines),
        most_words_(bytes.size() - header.bytes) {}

  static constexpr bool kBinary = false;
  std::uint64_t place() const { return line_of(word_); }
  /// In words, each of which takes two bytes: itself and what ends it.
  std::size_t left() const { return most_words_ / 2 + 1; }
  static std::size_t least_bytes(const PlyProperty&) { return 1; }
  static std::size_t item_bytes(const PlyProperty&) { return 1; }

  void begin_row() {
    if (!lexer_.next_statement())
      throw InputError({lexer_.name()}, "the file ends before all elements that its header states",
                       "more");
    next();
  }
  void end_row() {
    if (!word_.text.empty())
      fail_at(word_, in_quotes(word_.text) + " is one too many", "the line's end");
  }
  void skip(PlyType) {
    if (word_.text.empty()) fail_at(word_, "the line ends here", "a number");
    next();
  }
  double number(PlyType) {
    const auto value = parse_number(word_.text);
    if (!value)
      fail_at(word_,
              word_.text.empty() ? "the line ends here"
                                 : in_quotes(word_.text) + " is not a finite number",
              "a number");
    next();
    return *value;
  }
  void end() {
    if (!lexer_.next_statement()) return;
    next();
    fail_at(word_, "the file goes on behind the elements that its header states", "its end");
  }
  /// Where the last number stood.
  [[noreturn]] void fail(const std::string& wrong, const std::string& expected) const {
    fail_at(last_, wrong, expected);
  }

 private:
  void next() {
    last_ = word_;
    word_ = lexer_.word();
  }
  [[noreturn]] void fail_at(const ObjWord& word, const std::string& wrong,
                            const std::string& expected) const {
    throw InputError(
        {lexer_.name(), static_cast<int>(line_of(word)), static_cast<int>(word.column)}, wrong,
        expected);
  }
  std::uint32_t line_of(const ObjWord& word) const {
    return word.line + static_cast<std::uint32_t>(lines_before_);
  }

  ObjLexer lexer_;
  ObjWord word_, last_;
  int lines_before_;
  std::size_t most_words_;
};

std::size_t index_of(const PlyElement& e, std::initializer_list<std::string_view> names, bool list,
                     const std::string& file) {
  for (std::size_t i = 0; i < e.properties.size(); ++i)
    if (e.properties[i].list_count.has_value() == list &&
        std::ranges::find(names, e.properties[i].name) != names.end())
      return i;
  throw InputError({file, e.line, 1},
                   "the element " + in_quotes(e.name) + " has no " + std::string(*names.begin()),
                   list ? "a list of that name" : "a number of that name");
}

template <class Body>
class PlyReader {
 public:
  PlyReader(Body body, const PlyHeader& header, const std::string& name)
      : body_(std::move(body)), header_(header) {
    soup_.binary = Body::kBinary, soup_.file = name;
  }

  TriangleSoup read() {
    for (const PlyElement& e : header_.elements) {
      require_room(e);
      if (e.name == "vertex")
        vertices(e);
      else if (e.name == "face")
        faces(e);
      else
        others(e);
    }
    body_.end();
    return fanned(std::move(soup_));
  }

 private:
  void require_room(const PlyElement& e) {
    std::size_t least = 0;
    for (const PlyProperty& p : e.properties) least += Body::least_bytes(p);
    if (least > 0 && e.count > body_.left() / least)
      throw InputError(
          {soup_.file, e.line, 1},
          "the file is too short for " + std::to_string(e.count) + " elements " + in_quotes(e.name),
          "a count that fits the file");
  }

  void vertices(const PlyElement& e) {
    const std::array<std::size_t, 3> axes = {index_of(e, {"x"}, false, soup_.file),
                                             index_of(e, {"y"}, false, soup_.file),
                                             index_of(e, {"z"}, false, soup_.file)};
    for (std::size_t n = 0; n < e.count; ++n) {
      body_.begin_row();
      Vec3 p;
      for (std::size_t i = 0; i < e.properties.size(); ++i) {
        const auto axis = std::ranges::find(axes, i);
        if (axis == axes.end())
          skip(e.properties[i]);
        else
          p[static_cast<int>(axis - axes.begin())] = coordinate(e.properties[i].type);
      }
      body_.end_row();
      soup_.vertices.push_back(p);
    }
  }

  double coordinate(PlyType type) {
    const double value = body_.number(type);
    if (!std::isfinite(value)) body_.fail("a coordinate is not a finite number", "millimetres");
    return value;
  }

  void faces(const PlyElement& e) {
    const std::size_t list = index_of(e, {"vertex_indices", "vertex_index"}, true, soup_.file);
    for (std::size_t n = 0; n < e.count; ++n) {
      body_.begin_row();
      const std::uint64_t place = body_.place();
      for (std::size_t i = 0; i < e.properties.size(); ++i)
        if (i == list)
          corners(e.properties[i]);
        else
          skip(e.properties[i]);
      body_.end_row();
      soup_.ends.push_back(soup_.corners.size());
      soup_.places.push_back(place);
    }
  }

  void corners(const PlyProperty& p) {
    const std::size_t count = length(p);
    if (count < 3) body_.fail("a face with " + std::to_string(count) + " corners", "three or more");
    for (std::size_t k = 0; k < count; ++k) {
      const double index = body_.number(p.type);
      if (!(index >= 0 && index < UINT32_MAX && index == std::floor(index)))
        body_.fail("there is no vertex " + shortest(index), "a vertex counted from 0");
      soup_.corners.push_back(static_cast<std::uint32_t>(index));
    }
  }

  /// Of a list, which must have room in what is left.
  std::size_t length(const PlyProperty& p) {
    const double count = body_.number(*p.list_count);
    const auto most = static_cast<double>(body_.left() / Body::item_bytes(p));
    if (!(count >= 0 && count <= most && count == std::floor(count)))
      body_.fail("a list of " + shortest(count), "a length that fits the file");
    return static_cast<std::size_t>(count);
  }

  void others(const PlyElement& e) {
    if (e.properties.empty()) return;
    for (std::size_t n = 0; n < e.count; ++n) {
      body_.begin_row();
      for (const PlyProperty& p : e.properties) skip(p);
      body_.end_row();
    }
  }

  void skip(const PlyProperty& p) {
    for (std::size_t k = p.list_count ? length(p) : 1; k > 0; --k) body_.skip(p.type);
  }

  Body body_;
  const PlyHeader& header_;
  PolygonSoup soup_;
};

}  // namespace

TriangleSoup read_mesh_ply(std::string_view bytes, const std::string& name) {
  const PlyHeader header = read_ply_header(bytes, name);
  if (header.order) return PlyReader(BinaryBody(bytes, header, name), header, name).read();
  return PlyReader(AsciiBody(bytes, header, name), header, name).read();
}

}  // namespace limitgauge::model
