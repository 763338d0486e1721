"""validate_studies.py WRITE_STUDIES: every sample study.json holds against the shipped schema, by a
validator that is not ours, and ones that break the contract do not; study.csv says the same."""
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

studies = {name: json.loads((folder / name / "study.json").read_text())
           for name in ("sixty", "hostile", "failed", "single")}
for name, study in studies.items():
    for error in validator.iter_errors(study):
        sys.exit(f"{name}: {error.json_path}: {error.message}")


def rows_of(name):
    with open(folder / name / "study.csv", newline="", encoding="utf-8") as file:
        return list(csv.DictReader(file, strict=True))


def number(text):
    return float(text) if text else None


for name, study in studies.items():
    rows = rows_of(name)
    if len(rows) != len(study["cases"]):
        sys.exit(f"{name}: study.csv has {len(rows)} lines for {len(study['cases'])} cases")
    for row, case in zip(rows, study["cases"]):
        if int(row["case"]) != case["case"] or row["status"] != case["status"]:
            sys.exit(f"{name}: line of case {case['case']} is another one")
        heads = list(row)
        first = 3 + len(study["keys"])
        figures = [number(row[head]) for head in heads[first:first + len(study["figures"])]]
        if figures != case["figures"]:
            sys.exit(f"{name}: case {case['case']}: {figures} for {case['figures']}")


def broken(change):
    study = copy.deepcopy(studies["sixty"])
    change(study)
    return study


def at(study, path):
    for key in path:
        study = study[key]
    return study


def set_at(*path, value):
    return lambda study: at(study, path[:-1]).__setitem__(path[-1], value)


def drop(*path):
    return lambda study: at(study, path[:-1]).__delitem__(path[-1])


changes = {
    "other schema": set_at("schema", value="limitgauge.study/2"),
    "no run": drop("run"),
    "unknown method": set_at("plan", "method", value="guess"),
    "unknown status": set_at("cases", 0, "status", value="maybe"),
    "figure that is text": set_at("cases", 0, "figures", 0, value="1"),
    "half a key": set_at("cases", 0, "key", value="00ff"),
    "passed without result": drop("cases", 0, "result"),
    "lost with result": set_at("cases", 20, "result", value="cases/0000/0020/result.json"),
    "result elsewhere": set_at("cases", 0, "result", value="../result.json"),
    "setting without its text": drop("cases", 0, "settings", 0, "toml"),
    "negative count": set_at("counts", "fail", value=-1),
    "front without cases": drop("analysis", "fronts", 0, "cases"),
    "share above 1": set_at("analysis", "responses", 0, "variance_share", value=1.5),
}
for what, change in changes.items():
    if validator.is_valid(broken(change)):
        sys.exit(f"the schema lets pass: {what}")
print(f"{len(studies)} studies hold, {len(changes)} broken ones are refused")
