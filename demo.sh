#!/usr/bin/env bash
# Builds Limitgauge and runs the aircraft job: three stages planned, cut, measured and gated.
# Ends with the verdict table and the report's path. Further arguments go to `limitgauge run`.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")"

./setup.sh build
cmake --preset release -DLIMITGAUGE_TESTS=OFF -DLIMITGAUGE_UNITY=ON >/dev/null
cmake --build --preset release --target limitgauge
build/release/limitgauge run fixtures/jobs/aircraft.toml --output out/aircraft --force "$@"
