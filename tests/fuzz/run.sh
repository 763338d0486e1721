#!/usr/bin/env bash
# run.sh SECONDS [TARGET...] - builds the fuzz targets and runs each of them (or those named) for
# SECONDS, FUZZ_JOBS of them at a time (default 1). Prints executions and coverage; a crash, a
# sanitizer's report, a leak, more than 1 s for an input or more than 1 GiB is a finding: it is kept
# in build/fuzz/findings/TARGET, and the exit code is 1. What extends the coverage is kept in
# build/fuzz/corpus/TARGET, so that the next run goes on from there.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/../.."
here=tests/fuzz
build=build/fuzz
longest=65536  # bytes of an input

[ $# -ge 1 ] || { echo "usage: run.sh SECONDS [TARGET...]" >&2; exit 2; }

export ASAN_OPTIONS=quarantine_size_mb=64:malloc_context_size=6
export UBSAN_OPTIONS=print_stacktrace=1

# Bounds for an input. Whoever reads a .vdb has a process that may take time, ask for memory and break
# down over it, none of which is a finding or worth the time to tell of.
options_of() {
  case $1 in
    vdb) echo -timeout=30 -report_slow_units=30 -malloc_limit_mb=1000000 -max_len=200000 \
           -print_funcs=0 -detect_leaks=0 ;;
    *) echo -timeout=1 -malloc_limit_mb=1024 -max_len=$longest ;;
  esac
}

# An input that took long while the machine was busy with something else is no finding: it must take
# more than 1 s of processor time by itself.
is_slow() {
  local binary=$1 input=$2 TIMEFORMAT='%U %S' used
  used=$({ time "$binary" -timeout=60 "$input" >/dev/null 2>&1; } 2>&1) || return 0
  awk -v used="$used" 'BEGIN { split(used, s, " "); exit !(s[1] + s[2] > 1) }'
}

# Goes on behind a false alarm until the time is up.
fuzz() {
  local target=$1 seconds=$2 binary=$build/$here/fuzz_$1
  local found=$build/findings/$target/ corpus=$build/corpus/$target log=$build/log/$target.log
  local until=$((SECONDS + seconds)) left executions=0 executed status input
  mkdir -p "$found" "$corpus" "$build/log"
  [ "$target" != vdb ] || export ASAN_OPTIONS=$ASAN_OPTIONS:symbolize=0 UBSAN_OPTIONS=symbolize=0
  : > "$log"
  while left=$((until - SECONDS)); [ "$left" -gt 0 ]; do
    touch "$build/log/$target.begin"
    status=0
    # shellcheck disable=SC2046  # several words
    "$binary" -max_total_time="$left" -rss_limit_mb=1024 $(options_of "$target") \
      -dict="$here/dictionaries/$target.dict" -artifact_prefix="$found" \
      -print_final_stats=1 -verbosity=1 "$corpus" "$build/seeds/$target" >"$log.now" 2>&1 || status=$?
    cat "$log.now" >> "$log"
    executed=$(sed -n 's/^stat::number_of_executed_units: *//p' "$log.now" | tail -1)
    executions=$((executions + ${executed:-0}))
    [ $status -ne 0 ] || break
    input=$(find "$found" -type f -newer "$build/log/$target.begin" | head -1)
    case $input in
      */timeout-*) is_slow "$binary" "$input" && break; rm "$input"; status=0 ;;
      *) break ;;
    esac
  done
  report "$target" "$executions" "$seconds" "$log.now" "$status" "$found"
}

report() {
  local target=$1 executions=$2 seconds=$3 log=$4 status=$5 found=$6 covered all
  covered=$(grep -o 'cov: [0-9]*' "$log" | tail -1 | cut -d' ' -f2)
  all=$(sed -n 's/.*Loaded 1 modules *(\([0-9]*\) inline.*/\1/p' "$log" | head -1)
  printf '%-10s %10d executions %8d a second   coverage %6s of %6s edges   ' "$target" \
    "$executions" $((executions / seconds)) "${covered:-?}" "${all:-?}"
  if [ "$status" -eq 0 ]; then echo "no finding"; return 0; fi
  echo "FINDING in $found"
  grep -E -m3 'ERROR|SUMMARY|runtime error|broken promise|terminate' "$log" || tail -5 "$log"
  return 1
}

if [ "$1" = --one ]; then
  fuzz "$2" "$3"
  exit
fi

seconds=$1
shift
cmake --preset fuzz -DLIMITGAUGE_UNITY=ON >/dev/null
cmake --build --preset fuzz
$here/seeds.sh $build/seeds
$build/$here/vdb_seeds $build/seeds/vdb
targets=("$@")
[ ${#targets[@]} -gt 0 ] || mapfile -t targets < <(cd $build/$here && ls fuzz_* | sed 's/^fuzz_//')
printf '%s\n' "${targets[@]}" |
  xargs -P "${FUZZ_JOBS:-1}" -I{} "$here/run.sh" --one {} "$seconds" || exit 1
