#!/usr/bin/env bash
# baselines.sh check|approve [NAME...] - the project's own accuracy, guarded by its own command: runs
# the small jobs of fixtures/baselines (or those named) and compares each result with the one that is
# kept there. `check` exits with 1 where a figure got worse; `approve` keeps the new results instead,
# stripped of clocks and of what depends on the machine.
# LIMITGAUGE names the program (default: build/release/limitgauge).
set -euo pipefail
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
cd "$here/../fixtures/baselines"
program=${LIMITGAUGE:-$here/../build/release/limitgauge}

usage() { echo "usage: baselines.sh check|approve [NAME...]" >&2; exit 3; }
[ $# -ge 1 ] || usage
mode=$1
shift
case $mode in check | approve) ;; *) usage ;; esac
names=("$@")
[ ${#names[@]} -gt 0 ] || mapfile -t names < <(sed -n 's/^\([a-z-]*\) .*/\1/p' jobs.txt)

scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT

# Exit codes 0 to 2 are results; the kept one says which it was.
run_job() {
  local name=$1 status=0 job
  read -ra job < <(sed -n "s/^$name //p" jobs.txt) ||
    { echo "baselines.sh: no baseline is called $name (jobs.txt)" >&2; exit 3; }
  "$program" run "${job[@]}" -o "$scratch/$name" --no-pictures --quiet || status=$?
  [ "$status" -le 2 ] || { echo "baselines.sh: $name did not run" >&2; exit "$status"; }
}

approve() {
  run_job "$1"
  python3 "$here/baselines/strip.py" "$scratch/$1/result.json" "$1.json"
  echo "$1: kept"
}

check() {
  local status=0
  run_job "$1"
  "$program" compare "$1.json" "$scratch/$1" >"$scratch/$1.txt" 2>&1 || status=$?
  if [ "$status" -eq 0 ]; then
    echo "$1: $(sed -n 's/^comparison: //p' "$scratch/$1.txt")"
  else
    echo "$1:"
    cat "$scratch/$1.txt"
  fi
  return "$status"
}

worst=0
for name in "${names[@]}"; do
  status=0
  "$mode" "$name" || status=$?
  [ "$status" -le "$worst" ] || worst=$status
done
if [ "$mode" = check ] && [ "$worst" -eq 1 ]; then
  echo "A figure is worse than what is kept in fixtures/baselines. Where that is meant:" \
    "tests/baselines.sh approve, and say why in the commit." >&2
fi
exit "$worst"
