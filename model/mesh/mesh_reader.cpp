#include "model/mesh/mesh_reader.h"

#include <algorithm>
#include <new>
#include <string_view>
#include <utility>

#include "model/base/error.h"
#include "model/base/text_file.h"
#include "model/mesh/mesh_obj.h"
#include "model/mesh/mesh_ply.h"
#include "model/mesh/mesh_stl.h"

namespace limitgauge::model {
namespace {

bool has_extension(const std::string& name, std::string_view extension) {
  std::string found = std::filesystem::path(name).extension().string();
  for (char& c : found)
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  return found == extension;
}

/// The first word, past blanks and a byte order mark.
std::string_view first_word(std::string_view text) {
  if (text.starts_with("\xEF\xBB\xBF")) text.remove_prefix(3);
  constexpr std::string_view kBlanks = " \t\r\n";
  const std::size_t begin = std::min(text.find_first_not_of(kBlanks), text.size());
  const std::size_t end = std::min(text.find_first_of(kBlanks, begin), text.size());
  return text.substr(begin, end - begin);
}

bool begins_as_solid(std::string_view bytes) {
  const std::string_view word = first_word(bytes);
  return word == "solid" || word == "SOLID" || word == "Solid";
}

TriangleSoup soup_of(std::string_view bytes, const std::string& name) {
  if (bytes.empty()) throw InputError({name}, "the file is empty", "a mesh as STL, OBJ or PLY");
  if (first_word(bytes) == "ply" || has_extension(name, ".ply")) return read_mesh_ply(bytes, name);
  if (has_extension(name, ".obj")) return read_mesh_obj(bytes, name);
  // Writers of binary STL put all sorts of things into its header, "solid" too: the size decides.
  if (has_binary_stl_size(bytes)) return read_binary_stl(bytes, name);
  if (begins_as_solid(bytes)) return read_ascii_stl(bytes, name);
  if (has_extension(name, ".stl")) return read_binary_stl(bytes, name);
  throw InputError({name}, "the file is no mesh of a known kind", "STL, OBJ or PLY");
}

/// What `make` makes; memory that does not do is a ResourceError.
template <class Make>
auto within_memory(const std::string& name, const Make& make) {
  try {
    return make();
  } catch (const std::bad_alloc&) {
    throw ResourceError(name + ": there is not enough memory for this mesh");
  }
}

MeshReading reading_of(std::string_view bytes, const std::string& name) {
  return within_memory(name, [&] { return solid_of(soup_of(bytes, name)); });
}

}  // namespace

TriangleSoup read_mesh_soup(const std::filesystem::path& path) {
  const std::string name = path.string();
  return within_memory(name, [&] { return soup_of(read_text_file(path), name); });
}

MeshReading read_mesh_file(const std::filesystem::path& path) {
  return reading_of(read_text_file(path), path.string());
}

MeshReading read_mesh(std::istream& in, const std::string& name_in_errors) {
  return reading_of(read_text(in, name_in_errors), name_in_errors);
}

TriangleMesh read_triangle_mesh(const std::filesystem::path& path) {
  return read_mesh_file(path).mesh;
}

TriangleMesh read_triangle_mesh(std::istream& in, const std::string& name_in_errors) {
  return read_mesh(in, name_in_errors).mesh;
}

}  // namespace limitgauge::model
