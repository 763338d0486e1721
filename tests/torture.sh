#!/usr/bin/env bash
# torture.sh MINUTES [--seed N] [--patience S] [SCENARIO...] - kills, stops, fills, starves and lies to the program for so
# long, and says what was lost, mixed or left hanging; tests/torture/README.md. PROGRAM: the program, if it
# is not that of the release build.
set -euo pipefail
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
exec python3 "$here/torture/torture.py" "${PROGRAM:-$here/../build/release/limitgauge}" "$@"
