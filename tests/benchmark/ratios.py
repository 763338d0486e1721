"""Ratios from what the benchmarks wrote: lines NAME VALUE on standard output, and on standard error
before each what is counted and what is not.

    ratios.py RESULTS.json      prints the ratios
    ratios.py --list            prints names, and what is in and out, without values
"""

import json
import math
import statistics
import sys

CELL = "cell_memory/iterations:1", "model_memory/iterations:1"

# name: (how, what is in, what is out)
RATIOS = {
    "certify_1um_vs_cut": (
        ("certify_finish/1000/real_time", "cut_finish/100/real_time"),
        "both sides' certificates of a dome to 1 µm over its cut at 0.1 mm, two threads",
        "cells of the surface, removed space and reach, which are built before"),
    "certify_100nm_vs_1um": (
        ("certify_finish/100/real_time", "certify_finish/1000/real_time"),
        "the same certificates to 0.1 µm over 1 µm", "as above"),
    "remove_vs_cut": (
        ("remove_finish/100/real_time", "cut_finish/100/real_time"),
        "lines of material cut by the same path over the level set's cut, two threads", "raw stocks"),
    "certify_casting_vs_block": (
        ("certify_finish_of_casting/1000/real_time", "certify_finish/1000/real_time"),
        "the certificates out of a casting of 200,000 triangles over those out of a block", "as above"),
    "cut_vs_floor": (
        ("cut_aircraft/50/process_time/real_time", "cut_aircraft_floor/50/process_time/real_time"),
        "the aircraft's finish stage at 0.05 mm, index of moves included, over one vectorised distance and"
        " write for each voxel whose value the stage changes, processor time of both threads",
        "voxels that go from inside to outside by whole blocks, and those that stay: on the floor's side;"
        " a copy of the stock: on both"),
    "cut_vs_floor_100um": (
        ("cut_aircraft/100/process_time/real_time", "cut_aircraft_floor/100/process_time/real_time"),
        "the same at 0.1 mm", "as above"),
    "cut_growth_moves": (
        "growth moves", "exponent of the time of a cut in its moves, 26,000 to 208,000 over one dome",
        "the raw stock"),
    "cut_growth_voxels": (
        "growth voxels", "exponent of the time of a cut in the voxels of its surface, 0.4 to 0.05 mm",
        "the raw stock"),
    "section_vs_cgal_slicer": (
        ("section_family", "section_cgal_slicer/iterations:1"),
        "872 planes through the aircraft's finish model, curves joined, over CGAL's slicer on the same"
        " triangles; both find the same points (places to 1e-9 mm and their count are compared), one thread",
        "what each builds once: quadtrees here, the tree of edges there"),
    "closest_point_vs_cgal_aabb": (
        "closest", "4096 nearest points on the exact surface over CGAL's tree of 32,768 triangles a patch, the"
        " worst of two surfaces and two distances, one thread",
        "both trees, which are built before"),
    "parse_vs_from_chars": (
        ("parse_program/iterations:1", "parse_from_chars/iterations:1"),
        "five million lines from memory to checked motions over std::from_chars of each number with a meaning"
        " to the path, one thread",
        "on the scanner's side: comments, blanks, words of spindle, tool and machine functions, and storing"
        " anything"),
    "cell_memory_vs_half_edge": (
        (CELL[0], "vs_half_edge"),
        "CELL as the paper has it (control points in single precision, strips, rings) over CGAL's Polyhedron_3"
        " with points in single precision, the aircraft at depth 8, bytes allocated",
        "limit points and normals on both sides"),
    "cell_memory_vs_half_edge_formula": (
        (CELL[0], "vs_half_edge_formula"),
        "the same as the paper's section 8.1 counts it, 22 pointers a vertex; its limit is 0.0638",
        "rings and the half-edges' outer layer on CELL's side"),
    "cell_memory_vs_surface_mesh": (
        (CELL[0], "vs_surface_mesh"),
        "CELL's control points in double precision over CGAL's Surface_mesh reserved exactly, depth 8, bytes"
        " allocated", "spare room on both sides; limit points and normals on both"),
    "model_memory_vs_half_edge": (
        (CELL[1], "vs_half_edge"),
        "all that plans are made on (limit points and normals in double precision, finer pieces at corners,"
        " bounds, cage) over CGAL's Polyhedron_3 of the patches' meshes, the aircraft to 0.01 mm, bytes allocated",
        "normals and the finer pieces on the half-edges' side; quadtrees and offsets, which a stage builds for"
        " itself"),
    "cell_refine_vs_cgal": (
        ("cell_refine/real_time", "cell_refine_cgal/real_time"),
        "the aircraft's cage to depth 7 over CGAL's subdivision, each from the cage on, one thread",
        "reading the file"),
    "cell_refine_vs_opensubdiv": (
        ("cell_refine/real_time", "cell_refine_opensubdiv/real_time"),
        "the same over OpenSubdiv's refiner and its interpolation in single precision, its base level built"
        " each time as our outer layer is, one thread", "reading the file"),
}

# Processor time, whatever else the machine does: these run on one thread in both, or (the aircraft's cut)
# count that of the whole process.
OWN_TIME = "section", "parse", "cell", "closest_point", "cut_aircraft"


class Runs:
    def __init__(self, file):
        self.times, self.values = {}, {}
        for run in json.load(open(file))["benchmarks"]:
            if run.get("run_type") != "iteration":
                continue
            if run.get("error_occurred"):
                sys.exit(f"{run['run_name']}: {run['error_message']}")
            clock = "cpu_time" if run["run_name"].startswith(OWN_TIME) else "real_time"
            self.times.setdefault(run["run_name"], []).append(run[clock])
            for key, value in run.items():
                self.values.setdefault((run["run_name"], key), []).append(value)

    def ratio(self, over, under):
        return statistics.median(a / b for a, b in zip(self.times[over], self.times[under]))

    def closest(self):
        kinds = [run.removeprefix("closest_point_exact") for run in self.times
                 if run.startswith("closest_point_exact")]
        return max(self.ratio("closest_point_exact" + k, "closest_point_cgal_aabb" + k) for k in kinds)

    def growth(self, of):
        """Slope of log time over log size, least squares."""
        names = [run for run in self.times if run.startswith(f"cut_growth_{of}/")]
        # The voxels of a surface go with the inverse square of their edge.
        sizes = [self.values[run, "moves"][0] if of == "moves" else int(run.split("/")[1]) ** -2.0
                 for run in names]
        xs = [math.log(size) for size in sizes]
        ys = [math.log(statistics.median(self.times[run])) for run in names]
        x0, y0 = statistics.mean(xs), statistics.mean(ys)
        return sum((x - x0) * (y - y0) for x, y in zip(xs, ys)) / sum((x - x0) ** 2 for x in xs)

    def value(self, how):
        if how == "closest":
            return self.closest()
        if isinstance(how, str):
            return self.growth(how.split()[1])
        return statistics.median(self.values[how]) if how in self.values else self.ratio(*how)


def main(arguments):
    if len(arguments) != 1:
        sys.exit(__doc__)
    runs = None if arguments[0] == "--list" else Runs(arguments[0])
    for name, (how, inside, outside) in RATIOS.items():
        print(f"# in: {inside}\n# out: {outside}", file=sys.stderr, flush=True)
        print(name if runs is None else f"{name} {runs.value(how):.3g}", flush=True)


if __name__ == "__main__":
    main(sys.argv[1:])
