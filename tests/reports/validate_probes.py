"""validate_probes.py WRITE_PROBES: every sample probe.json holds against the shipped schema, by a
validator that is not ours, and ones that break the contract do not; probe.csv says the same."""
import copy
import csv
import json
import pathlib
import subprocess
import sys
import tempfile

import jsonschema

scratch = tempfile.TemporaryDirectory(prefix="limitgauge-")
folder = pathlib.Path(scratch.name)
subprocess.run([sys.argv[1], folder], check=True)
schema = json.loads((folder / "schema.json").read_text())
jsonschema.Draft202012Validator.check_schema(schema)
validator = jsonschema.Draft202012Validator(schema)

NAMES = ("two-hundred", "many", "one", "floor", "slanted", "failed", "hostile")
probes = {name: json.loads((folder / name / "result.json").read_text()) for name in NAMES}
for name, probe in probes.items():
    for error in validator.iter_errors(probe):
        sys.exit(f"{name}: {error.json_path}: {error.message}")

for name, probe in probes.items():
    with open(folder / name / "probe.csv", newline="", encoding="utf-8") as file:
        rows = {int(row["file_line"]): row for row in csv.DictReader(file, strict=True)}
    if len(rows) != probe["points"]:
        sys.exit(f"{name}: probe.csv has {len(rows)} lines for {probe['points']} points")
    for point in probe["worst"]:
        row = rows[point["file_line"]]
        said = [point["residual"]["value_mm"], point["shifted"].get("high_mm"), point["made_by"]]
        high = row["shifted_high_mm"]
        if said != [float(row["residual_mm"]), float(high) if high else None, row["made_by"]]:
            sys.exit(f"{name}: line {point['file_line']}: {row} for {point}")


def broken(change):
    probe = copy.deepcopy(probes["two-hundred"])
    change(probe)
    return probe


def at(value, path):
    for key in path:
        value = value[key]
    return value


def set_at(*path, value):
    return lambda probe: at(probe, path[:-1]).__setitem__(path[-1], value)


def drop(*path):
    return lambda probe: at(probe, path[:-1]).__delitem__(path[-1])


changes = {
    "other schema": set_at("schema", value="limitgauge.probe/2"),
    "no shift": drop("shift"),
    "no points": set_at("points", value=0),
    "undetermined with a figure": set_at("shift", "axes", 0, "determined", value=False),
    "determined without one": drop("shift", "axes", 0, "shift_mm"),
    "no uncertainty at all": set_at("worst", 0, "u_mm", value=0),
    "made by nobody": set_at("worst", 0, "made_by", value="hand"),
    "a move of no stage": drop("worst", 0, "stage"),
    "no low end": drop("worst", 0, "residual", "low_mm"),
    "negative root mean square": set_at("before", "rms_mm", value=-1),
    "half a checksum": set_at("result", "sha256", value="00ff"),
}
for what, change in changes.items():
    if validator.is_valid(broken(change)):
        sys.exit(f"the schema lets pass: {what}")
print(f"{len(probes)} results of probe hold, {len(changes)} broken ones are refused")
