#!/usr/bin/env bash
# seeds.sh FOLDER - collects what the fuzz targets start from: FOLDER/TARGET/..., the project's own
# fixtures by reader, and what tests/fuzz/seeds adds where a reader has no fixtures.
set -euo pipefail
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
fixtures=$here/../../fixtures
to=$1

# collect TARGET PATTERN [FOLDER] - by name and a running number: files of two folders may share a name.
collect() {
  local target=$1 pattern=$2 within=${3:-$fixtures} file count=0
  mkdir -p "$to/$target"
  while IFS= read -r file; do
    count=$((count + 1))
    cp "$file" "$to/$target/$count-$(basename "$file")"
  done < <(find "$within" -type f -name "$pattern" | sort)
}

rm -rf "$to"
collect cage '*.obj'
collect mesh_obj '*.obj'
collect mesh_stl '*.stl'
collect mesh_ply '*.ply'
for pattern in '*.ngc' '*.nc' '*.tap' '*.mpf'; do collect program "$pattern"; done
collect cl_data '*.apt'
collect tool_table '*.tbl'
collect job '*.toml'
mkdir -p "$to/result"
cp "$fixtures"/baselines/*.json "$to/result/"
# The jobs' files stand beside other folders' jobs; the target has one folder with one of each.
sed -i -E 's#"[^"]*\.obj"#"part.obj"#; s#"[^"]*\.ngc"#"part.ngc"#' "$to"/job/*.toml
collect study '*.toml' "$fixtures/studies"
sed -i -E 's#^job = "[^"]*"#job = "study_job.toml"#' "$to"/study/*.toml
cp -r "$here"/seeds/* "$to"/
