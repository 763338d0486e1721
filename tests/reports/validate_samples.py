"""validate_samples.py WRITE_SAMPLES: every sample result.json holds against the shipped schema, by a
validator that is not ours, and results that break the contract do not."""
import copy
import json
import pathlib
import subprocess
import sys
import tempfile

import jsonschema

scratch = tempfile.TemporaryDirectory(prefix="limitgauge-")
folder = pathlib.Path(scratch.name)
subprocess.run([sys.argv[1], folder, "--no-pictures"], check=True)
schema = json.loads((folder / "schema.json").read_text())
jsonschema.Draft202012Validator.check_schema(schema)
validator = jsonschema.Draft202012Validator(schema)

results = {name: json.loads((folder / name / "result.json").read_text())
           for name in ("passed", "failed", "undecided", "foreign", "cut")}
for name, result in results.items():
    for error in validator.iter_errors(result):
        sys.exit(f"{name}: {error.json_path}: {error.message}")


def broken(change):
    result = copy.deepcopy(results["failed"])
    change(result)
    return result


def set_at(*path, value):
    def change(node):
        for key in path[:-1]:
            node = node[key]
        node[path[-1]] = value
    return change


def drop(*path):
    def change(node):
        for key in path[:-1]:
            node = node[key]
        del node[path[-1]]
    return change


def without_design(change):
    def on_cut(result):
        result.clear()
        result.update(copy.deepcopy(results["cut"]))
        change(result)
    return on_cut


changes = {
    "no surface and yet deviations": drop("surface"),
    "cut with a deviation": without_design(set_at("stages", 0, "deviation", value=results["failed"]["stages"][0]["deviation"])),
    "cut with an allowance": without_design(set_at("stages", 0, "allowance_mm", value=0)),
    "cut with a limit": without_design(set_at("stages", 0, "gate", value={"gouge_mm": 0.1})),
    "cut that is undecided": without_design(set_at("stages", 0, "verdict", value="indeterminate")),
    "cut without simulation": without_design(drop("stages", 0, "simulation")),
    "no verdict": drop("verdict"),
    "unknown verdict": set_at("verdict", value="maybe"),
    "other schema": set_at("schema", value="limitgauge.result/1"),
    "negative gouge": set_at("stages", 0, "deviation", "gouge_mm", "low", value=-1e-9),
    "null figure": set_at("stages", 0, "deviation", "mean_mm", value=None),
    "run stage without deviation": drop("stages", 0, "deviation"),
    "stage that was not run with deviation": set_at("stages", 2, "deviation", value={}),
    "neither strategy nor program": drop("stages", 0, "strategy"),
    "finding without line": drop("stages", 1, "deviation", "gouges", 0, "line"),
    "input without checksum": drop("inputs", 0, "sha256"),
    "input with half a checksum": set_at("inputs", 0, "sha256", value="3" * 32),
    "box of one corner": set_at("surface", "bbox_mm", value=[[0, 0, 0]]),
}
for what, change in changes.items():
    if validator.is_valid(broken(change)):
        sys.exit(f"the schema lets pass: {what}")
print(f"{len(results)} results hold, {len(changes)} broken ones are refused")
