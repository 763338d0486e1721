#!/usr/bin/env bash
# Builds the planted-defect suite and runs all of it; prints its tables as Markdown. Ends with 1 when
# a defect was missed, misplaced or misnamed, a certified interval does not hold the truth, or an
# unharmed program fails. Options go to the suite: --cases FILE.tsv writes one line a program,
# --surface NAME, --cutter ID, --scenes COUNT and --triples COUNT keep to a part of it, --threads N. Without
# options 200 defects follow where parts lie turned, with --jobs DEFECTS they alone (--orientations SEED,
# --twins COUNT; --keep FOLDER keeps the jobs' files).
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."

cmake --preset release -DLIMITGAUGE_TESTS=ON >/dev/null
cmake --build --preset release --target limitgauge_defects >&2
suite=build/release/tests/defects/limitgauge_defects
failed=0
"$suite" --threads "$(nproc)" --triples 310 "$@" || failed=1
# Parts that lie turned: setups and machines with rotary axes.
[ $# -gt 0 ] || "$suite" --threads "$(nproc)" --orientations 1 --jobs 200 --twins 60 || failed=1
exit "$failed"
