#!/usr/bin/env bash
# The one list of Debian packages (12 and 13), by what they are for:
#   setup.sh build   building the program and running it (demo.sh needs no more)
#   setup.sh test    what the tests, benchmarks and fuzz tests need beside that
#   setup.sh all     both (without an argument as well)
# Installs those that are missing; does nothing, and needs no network, where all are there.
set -euo pipefail

build=(
  g++ cmake ninja-build ccache git ca-certificates
  # simulator: OpenVDB with what its headers and its library need; of Boost the verifier has rational numbers
  libopenvdb-dev libtbb-dev libimath-dev libboost-dev
  # meshes and exact predicates, with the exact numbers that they fall back to
  libcgal-dev libgmp-dev libmpfr-dev
  # least squares, eigenvectors
  libeigen3-dev
  # another evaluator of the limit surface, the witness of every run
  libosd-dev
  # reports: JSON, XML, pictures, text; VTK files, compressed by libdeflate
  nlohmann-json3-dev libpugixml-dev libpng-dev zlib1g-dev libfmt-dev libvtk9-dev libdeflate-dev
  # the report's script, bundled from reports/web at build time; a node that came with npm brings both
  nodejs
  # command line and job files; checksums of what was read
  libcli11-dev libtomlplusplus-dev libssl-dev
  # histories; the search of a study, found by pkg-config as libdeflate is
  libsqlite3-dev libnlopt-cxx-dev pkgconf
)
command -v npm >/dev/null || build+=(npm)

tests=(
  # the framework, a validator of our JSON, a reader of our JUnit, a reader of our manual page, one of
  # the examples for CI
  catch2 python3 python3-jsonschema python3-junitparser mandoc python3-yaml
  # the packages that cpack makes
  dpkg-dev file
  # benchmarks: the harness
  libbenchmark-dev
  # fuzz tests: clang of either release (14, 19) with its fuzzer's and sanitizers' runtimes
  clang libclang-rt-dev
  # tests of the report in a real browser
  chromium-headless-shell
  # tests of studies as job arrays: a cluster of one node
  slurm-wlm munge
)

case "${1:-all}" in
  build) packages=("${build[@]}") ;;
  test) packages=("${tests[@]}") ;;
  all) packages=("${build[@]}" "${tests[@]}") ;;
  *) echo "usage: setup.sh [build|test|all]" >&2; exit 2 ;;
esac

missing=()
for package in "${packages[@]}"; do
  status=$(dpkg-query -W -f '${db:Status-Status}' "$package" 2>/dev/null || true)
  [ "$status" = installed ] || missing+=("$package")
done
[ ${#missing[@]} -gt 0 ] || exit 0

as_root=()
if [ "$(id -u)" -ne 0 ]; then
  command -v sudo >/dev/null || { echo "setup.sh: these packages are missing and sudo is not there: ${missing[*]}" >&2; exit 1; }
  as_root=(sudo)
fi
echo "setup.sh: installing ${missing[*]}"
"${as_root[@]}" apt-get update -q
"${as_root[@]}" env DEBIAN_FRONTEND=noninteractive apt-get install -q -y --no-install-recommends "${missing[@]}"
