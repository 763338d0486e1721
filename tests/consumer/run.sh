#!/usr/bin/env bash
# tests/consumer/run.sh CMAKE BUILD: what docs/cpp.md says. Installs the build's libraries into a
# scratch folder, builds the project in this folder against that alone, and certifies a program of the
# engine's: it passes, and fails with one point of it lowered into the part.
set -euo pipefail
cmake=$1 build=$(realpath "$2")
source=$(realpath "$(dirname "${BASH_SOURCE[0]}")")
fixtures=$source/../../fixtures
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
cd "$scratch"

fail() {
  echo "run.sh: $*" >&2
  exit 1
}

"$cmake" --install "$build" --prefix "$scratch/prefix" --component Development >installed.txt
package=$(dirname "$(find prefix -name LimitgaugeConfig.cmake)")
if grep -rF -e "$build" -e "$(realpath "$source/../..")/" "$package"; then
  fail "the installed package names the build or the sources"
fi

configure() {
  "$cmake" -S "$source" -B "$1" -G Ninja -DCMAKE_BUILD_TYPE=Release \
    -DCMAKE_PREFIX_PATH="$scratch/prefix" "${@:2}"
}
for wrong in 0.0 99.0; do
  if configure refused -DWANTED=$wrong >refused.txt 2>&1; then
    fail "version $wrong was found"
  fi
  grep -q "compatible with requested version \"$wrong\"" refused.txt || fail "$(cat refused.txt)"
  rm -r refused
done
configure work >configured.txt || fail "$(cat configured.txt)"
"$cmake" --build work

"$build/limitgauge" plan "$fixtures/jobs/quick-dome.toml" -o plan >/dev/null
# One point in the middle of a row across the middle, 0.1 mm lower.
awk 'NR > 2000 && /^Y[-0-9.]+ Z[-0-9.]+$/ && substr($1, 2) ^ 2 < 9 && !done++ {
       printf "%s Z%.4f\n", $1, substr($2, 2) - 0.1
       next
     }
     { print }' plan/finish/toolpath.ngc >gouged.ngc
line=$(cmp plan/finish/toolpath.ngc gouged.ngc | sed 's/.*line //') || true
[ -n "$line" ] || fail "no gouge was planted"

arguments=("ball:D=6,L=20" "box:26,26,9@-13,-13,-4")
code=0
work/certify "$fixtures/cages/quick-dome.obj" plan/finish/toolpath.ngc "${arguments[@]}" | tee good.txt || code=$?
[ $code = 0 ] && grep -q '^verdict pass$' good.txt || fail "a good program: exit code $code"
code=0
work/certify "$fixtures/cages/quick-dome.obj" gouged.ngc "${arguments[@]}" | tee gouged.txt || code=$?
[ $code = 1 ] && grep -q '^verdict fail$' gouged.txt || fail "a gouged program: exit code $code"
grep -q "^  gouge .*program line $line$" gouged.txt || fail "line $line is not named"
work/cross_check "$fixtures/cages/quick-dome.obj" plan/finish/toolpath.ngc "${arguments[@]}"
