"""foreign_readers.py WRITE_SAMPLES SARIF_SCHEMA: the sample reports as readers see them that are not ours:
findings.sarif by its JSON Schema, findings.csv by Python's csv, junit.xml by junitparser, the VTK files by
Python's XML and zlib."""
import csv
import json
import pathlib
import struct
import subprocess
import sys
import tempfile
import unittest
import urllib.parse
import xml.etree.ElementTree
import zlib

import jsonschema
import junitparser

SAMPLES = ("passed", "failed", "undecided", "foreign", "cut")
LEVEL_OF_VERDICT = {"pass": "note", "indeterminate": "warning", "fail": "error"}
RANK = {"note": 0, "warning": 1, "error": 2}
COLUMNS = ("stage", "kind", "id", "depth_mm", "area_mm2", "x", "y", "z", "patch", "u", "v", "body",
           "program", "line", "move", "words")
TEXT_COLUMNS = ("stage", "kind", "id", "body", "program", "words")


class Sarif(unittest.TestCase):
    def test_schema(self):
        schema = json.loads(pathlib.Path(sarif_schema).read_text())
        jsonschema.Draft4Validator.check_schema(schema)
        # Said by the standard's errata, and not yet by this copy of its schema.
        schema["definitions"]["region"]["anyOf"] = [
            {"required": ["startLine"]}, {"required": ["charOffset"]}, {"required": ["byteOffset"]}]
        checker = jsonschema.FormatChecker()
        for name in SAMPLES:
            errors = list(jsonschema.Draft4Validator(schema, format_checker=checker)
                          .iter_errors(sarif[name]))
            self.assertEqual([], [f"{name}: {list(e.path)}: {e.message}" for e in errors])
        broken = json.loads(json.dumps(sarif["failed"]))
        broken["runs"][0]["results"][0]["level"] = "fatal"
        self.assertFalse(jsonschema.Draft4Validator(schema).is_valid(broken))

    def test_levels_agree_with_the_verdict(self):
        for name in SAMPLES:
            worst = max((RANK[r["level"]] for r in results(name)), default=0)
            self.assertEqual(worst, RANK[LEVEL_OF_VERDICT[result[name]["verdict"]]], name)

    def test_rules_and_artifacts_are_those_named(self):
        for name in SAMPLES:
            run = sarif[name]["runs"][0]
            rules = run["tool"]["driver"]["rules"]
            self.assertEqual(len(rules), len({r["id"] for r in rules}))
            for entry in run["results"]:
                self.assertEqual(rules[entry["ruleIndex"]]["id"], entry["ruleId"])
                for place in entry["locations"] + entry.get("relatedLocations", []):
                    artifact = place["physicalLocation"]["artifactLocation"]
                    self.assertEqual(run["artifacts"][artifact["index"]]["location"]["uri"],
                                     artifact["uri"])

    def test_snippets_are_the_lines_of_the_program(self):
        texts = {}
        for stage in result["failed"]["stages"]:
            for line in stage.get("program_lines", []):
                texts[stage["name"] + "/toolpath.ngc", line["line"]] = line["text"]
        seen = 0
        for entry in results("failed"):
            place = entry["locations"][0]["physicalLocation"]
            if "region" not in place:
                continue
            key = place["artifactLocation"]["uri"], place["region"]["startLine"]
            self.assertEqual(texts.get(key, ""), place["region"].get("snippet", {}).get("text", ""))
            seen += key in texts
        self.assertGreater(seen, 0)

    def test_every_finding_beyond_a_limit_is_a_result_and_no_other_is(self):
        stage = result["failed"]["stages"][1]
        beyond = [g for g in stage["deviation"]["gouges"]
                  if g["depth_mm"] > stage["gate"]["gouge_mm"]]
        self.assertGreater(len(beyond), 0)
        found = [r for r in results("failed") if r["ruleId"] == "gouge"]
        self.assertEqual([g["depth_mm"] for g in beyond],
                         [r["properties"]["depth_mm"] for r in found])
        self.assertEqual([], results("passed"))

    def test_fingerprints(self):
        for name in SAMPLES:
            prints = [r["partialFingerprints"]["limitgaugePlace/v1"] for r in results(name)]
            self.assertEqual(len(prints), len(set(prints)))
            for print_ in prints:
                self.assertRegex(print_, "^[0-9a-f]{16}:[1-9][0-9]*$")

    def test_hostile_names(self):
        run = sarif["foreign"]["runs"][0]
        uris = [a["location"]["uri"] for a in run["artifacts"]]
        self.assertEqual("nc/part 1 (T1-T2) é#?.ngc", urllib.parse.unquote(uris[0]))
        self.assertEqual(["JOB", None], [a["location"].get("uriBaseId") for a in run["artifacts"]])
        self.assertEqual("/nc/finish.ngc", urllib.parse.urlparse(uris[1]).path)
        for entry in run["results"]:
            text = entry["message"]["text"]
            self.assertNotRegex(text, r"(?<!\\)\[")
            self.assertNotRegex(text, r"(?<!\{)\{(?!\{)")

    def test_places_around_a_leftover(self):
        entry = next(r for r in results("foreign") if r["properties"].get("id") == "U1")
        lines = [p["physicalLocation"]["region"]["startLine"] for p in entry["relatedLocations"]]
        self.assertEqual([100, 105], lines)
        raw = next(r for r in results("foreign") if r["properties"].get("id") == "U2")
        self.assertNotIn("region", raw["locations"][0]["physicalLocation"])


class Csv(unittest.TestCase):
    def test_rows_are_the_findings(self):
        for name in SAMPLES:
            self.assertEqual(list(COLUMNS), list(rows[name][0].keys()))
            for stage in result[name]["stages"]:
                mine = [r for r in rows[name] if r["stage"].lstrip("'") == stage["name"]]
                deviation = stage.get("deviation", {"gouges": [], "uncuts": []})
                for kind, key, letter in (("gouge", "gouges", "G"), ("uncut", "uncuts", "U")):
                    got = [r for r in mine if r["kind"] == kind]
                    self.assertEqual(len(deviation[key]), len(got))
                    for i, (want, row) in enumerate(zip(deviation[key], got)):
                        self.assertEqual(f"{letter}{i + 1}", row["id"])
                        for column in ("x", "y", "z", "depth_mm", "area_mm2", "u", "v", "patch"):
                            self.assertEqual(want[column], float(row[column]))
                        self.assertEqual(want["line"], int(row["line"] or 0))
                process = [r for r in mine if r["id"].startswith("P")]
                groups = stage.get("simulation", {"findings": []})["findings"]
                self.assertEqual(sorted((g["kind"], g["line"]) for g in groups),
                                 sorted((r["kind"], int(r["line"])) for r in process))

    def test_no_cell_is_a_formula(self):
        tried = 0
        for row in rows["foreign"]:
            for column in TEXT_COLUMNS:
                self.assertNotRegex(row[column], r"^\s*[=+\-@]")
                tried += row[column].startswith("'")
        self.assertGreater(tried, 0)
        names = {row["stage"] for row in rows["foreign"]}
        self.assertEqual({"'=1+1", "'@semi \"{0}\", [a](b)"}, names)

    def test_lines_end_as_the_standard_says(self):
        for name in SAMPLES:
            data = (folder / name / "findings.csv").read_bytes()
            self.assertEqual(data.count(b"\n"), data.count(b"\r\n"))
            self.assertTrue(data.endswith(b"\r\n"))


class Junit(unittest.TestCase):
    def test_cases_stand_for_the_verdicts(self):
        for name in SAMPLES:
            xml = junitparser.JUnitXml.fromfile(str(folder / name / "junit.xml"))
            self.assertEqual(len(result[name]["stages"]), len(list(xml)))
            for suite, stage in zip(xml, result[name]["stages"]):
                self.assertEqual(stage["name"], suite.name)
                given = {p.name: p.value for p in suite.properties()}
                self.assertEqual(stage["verdict"], given["verdict"])
                counts = {junitparser.Failure: 0, junitparser.Error: 0, junitparser.Skipped: 0}
                for case in suite:
                    for outcome in case.result:
                        counts[type(outcome)] += 1
                self.assertEqual((suite.failures, suite.errors, suite.skipped), tuple(counts.values()))
                self.assertEqual(stage["verdict"] == "fail", suite.failures > 0)
                self.assertEqual(stage["verdict"] == "indeterminate",
                                 suite.errors > 0 and suite.failures == 0)
                if stage["verdict"] == "not_run":
                    self.assertEqual(suite.tests, suite.skipped)
                self.assertLessEqual(sum(c.time for c in suite), suite.time + 0.001)

    def test_failures_name_the_worst_place(self):
        xml = junitparser.JUnitXml.fromfile(str(folder / "failed" / "junit.xml"))
        messages = {case.name: case.result[0].message for suite in xml for case in suite
                    if case.result and isinstance(case.result[0], junitparser.Failure)}
        self.assertIn("worst G1", messages["gouge"])
        self.assertIn("of semi-finish/toolpath.ngc", messages["gouge"])
        self.assertIn("line 423 of", messages["rapid collisions"])
        self.assertIn("line 1513 of", messages["holder collisions"])
        self.assertIn("line 1612 of", messages["process faults"])


class Vtk(unittest.TestCase):
    """The layout as https://docs.vtk.org/en/latest/design_documents/VTKFileFormats.html has it."""

    def test_one_file_names_those_of_all_stages(self):
        for name in SAMPLES:
            root = xml.etree.ElementTree.parse(folder / name / "stages.vtm").getroot()
            self.assertEqual("vtkMultiBlockDataSet", root.get("type"))
            blocks = root.find("vtkMultiBlockDataSet").findall("Block")
            ran = [s["name"] for s in result[name]["stages"] if s["verdict"] != "not_run"]
            self.assertEqual(ran, [b.get("name") for b in blocks])
            for block in blocks:
                leaves = {d.get("name"): d.get("file") for d in block.findall("DataSet")}
                self.assertEqual({"toolpath"} if name == "cut" else {"deviation", "toolpath"}, set(leaves))
                for file in leaves.values():
                    self.assertTrue((folder / name / file).is_file(), file)

    def test_deviation_and_gate_are_those_measured(self):
        for name in SAMPLES:
            for stage in result[name]["stages"]:
                if "deviation" not in stage:
                    continue
                mesh = PolyData(folder / name / stage["name"] / "deviation.vtp")
                self.assertEqual("deviation_mm", mesh.piece.find("PointData").get("Scalars"))
                self.assertEqual("normal", mesh.piece.find("PointData").get("Normals"))
                with open(folder / name / stage["name"] / "field.txt") as lines:
                    field = [line.split() for line in lines]
                self.assertEqual(len(field), int(mesh.piece.get("NumberOfPoints")))
                single = [struct.unpack("<f", struct.pack("<f", float(f[0])))[0] for f in field]
                self.assertEqual(single, list(mesh.values("PointData", "deviation_mm", "f")))
                self.assertEqual([int(f[1]) for f in field],
                                 list(mesh.values("PointData", "line", "I")))
                facts = {a.get("Name") for a in mesh.data.find("FieldData")}
                for key, limit in stage["gate"].items():
                    fact = {"coverage": "coverage_limit", "unreachable": "unreachable_limit"}.get(
                        key, key.replace("_mm", "_limit_mm"))
                    self.assertEqual([limit], list(mesh.values("FieldData", fact, "d")))
                    facts.remove(fact)
                self.assertEqual({"stage", "tool", "verdict", "units", "allowance_mm"}, facts)


class PolyData:
    """A .vtp file with raw appended data in blocks that zlib has compressed."""

    def __init__(self, path):
        text = path.read_bytes()
        begin = text.index(b"<AppendedData")
        self.appended = text[text.index(b"_", begin) + 1:]
        self.data = xml.etree.ElementTree.fromstring(text[:begin] + b"</VTKFile>").find("PolyData")
        self.piece = self.data.find("Piece")

    def values(self, section, name, code):
        parent = self.data if section == "FieldData" else self.piece
        array, = (a for a in parent.find(section) if a.get("Name") == name)
        at = int(array.get("offset"))
        blocks, = struct.unpack_from("<Q", self.appended, at)
        sizes = struct.unpack_from(f"<{blocks}Q", self.appended, at + 24)
        at += 24 + 8 * blocks
        data = b""
        for size in sizes:
            data += zlib.decompress(self.appended[at:at + size])
            at += size
        return struct.unpack(f"<{len(data) // struct.calcsize(code)}{code}", data)


def results(name):
    return sarif[name]["runs"][0]["results"]


program, sarif_schema = sys.argv[1:]
scratch = tempfile.TemporaryDirectory(prefix="limitgauge-")
folder = pathlib.Path(scratch.name)
subprocess.run([program, folder, "--no-pictures"], check=True)
result = {name: json.loads((folder / name / "result.json").read_text()) for name in SAMPLES}
sarif = {name: json.loads((folder / name / "findings.sarif").read_text()) for name in SAMPLES}
rows = {}
for sample in SAMPLES:
    with open(folder / sample / "findings.csv", encoding="utf-8", newline="") as file:
        rows[sample] = list(csv.DictReader(file, strict=True))
unittest.main(argv=sys.argv[:1])
