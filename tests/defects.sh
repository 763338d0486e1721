#!/usr/bin/env bash
# Builds the planted-defect suite and runs all of it; prints its tables as Markdown. Ends with 1 when
# a defect was missed, misplaced or misnamed, a certified interval does not hold the truth, or an
# unharmed program fails. Options go to the suite: --cases FILE.tsv writes one line a program,
# --surface NAME, --cutter ID, --scenes COUNT and --triples COUNT keep to a part of it, --threads N.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."

cmake --preset release -DLIMITGAUGE_TESTS=ON >/dev/null
cmake --build --preset release --target limitgauge_defects >&2
exec build/release/tests/defects/limitgauge_defects --threads "$(nproc)" --triples 310 "$@"
