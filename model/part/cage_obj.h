#pragma once

#include <filesystem>
#include <istream>
#include <ostream>
#include <string>

#include "model/part/cage.h"

namespace limitgauge::model {

/// Reads a cage from Wavefront OBJ: `v`, `f` (n-gons; 1-based or negative relative indices; texture
/// and normal indices are checked for form and dropped), `t crease|corner|hole|interpolateboundary`
/// tags with 0-based ids (as OpenSubdiv's regression shapes write them), comments, line
/// continuations. `vt`, `vn`, `vp`, `g`, `o`, `s`, `usemtl`, `mtllib` carry nothing of the surface.
/// Anything else, an index out of range, a coordinate that is not a finite number, a non-manifold
/// or inconsistently oriented cage is an InputError with line and column. Vertices may follow the
/// faces that name them; those that no face names are kept and take no part. A crease or corner
/// tagged twice alike counts once, tagged twice differently is an error. The cage is named after
/// the file.
Cage read_cage_obj(const std::filesystem::path& path);
Cage read_cage_obj(std::istream& in, const std::string& name_in_errors);

/// Writes `cage` so that read_cage_obj gives the same cage, digit for digit; its name is the
/// file's.
void write_cage_obj(const Cage& cage, std::ostream& out);

}  // namespace limitgauge::model
