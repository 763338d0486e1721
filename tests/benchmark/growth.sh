#!/usr/bin/env bash
# Fits exponents of every phase (model, planning, cutting, measuring by its parts, files), of the memory
# and of what is written, in faces, moves, area and voxels, from real runs of the built program.
#
#   tests/benchmark/growth.sh [--quick] [--save FIT]     some minutes; --quick: tiny parts, seconds, and
#                                                        fixed costs in place of growth
#   tests/benchmark/growth.sh --predict FIT faces=N moves=N area_mm2=N voxels=N [parts=N]
#
# LIMITGAUGE names another program than build/release/limitgauge.
set -euo pipefail
exec python3 "$(dirname "${BASH_SOURCE[0]}")/growth.py" "$@"
