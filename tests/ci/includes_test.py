#!/usr/bin/env python3
"""Includes run one way, in no circle, and rooms stay small enough to look over.

A noun is a header with the source of its name. Usage: includes_test.py SOURCE_TREE
"""
import collections
import pathlib
import posixpath
import re
import sys

# What each room of the house may include besides itself; engine has two floors.
ARROWS = {
    "model": [],
    "engine/surface": ["model"],
    "engine/strategy": ["engine/surface", "model"],
    "simulator": ["model"],
    "verifier": ["model"],
    "study": ["model"],
    "history": ["model"],
    "witness": ["model"],
    "reports": ["witness", "history", "study", "verifier", "simulator", "engine/strategy",
                "engine/surface", "model"],
    "app": ["reports", "witness", "history", "study", "verifier", "simulator", "engine/strategy",
            "engine/surface", "model"],
}
MOST_FILES = 32  # side by side in one folder; thirty is meant
INCLUDE = re.compile(r'^#include "([^"]+)"', re.MULTILINE)
IMPORT = re.compile(r"^(?:import|export|\}) (?:.* )?from '(\.[^']+)'", re.MULTILINE)


def read_tree(root):
    """Path of each header, source and script of the house, with its text."""
    tops = {room.split("/")[0] for room in ARROWS} | {"tests"}  # tests may know everything
    files = [f for top in sorted(tops) for f in sorted((root / top).rglob("*"))
             if f.suffix in (".h", ".cpp", ".js", ".mjs", ".css") and "node_modules" not in f.parts]
    return {f.relative_to(root).as_posix(): f.read_text(encoding="utf-8") for f in files}


def noun_of(path):
    return path.rsplit(".", 1)[0]


def room_of(path):
    return next((room for room in ARROWS if path.startswith(room + "/")), None)


def includes_of(files):
    """The nouns that each noun includes, its own header left out."""
    graph = collections.defaultdict(set)
    nouns = {noun_of(path) for path in files}
    for path, text in files.items():
        noun, folder = noun_of(path), posixpath.dirname(path)
        others = INCLUDE.findall(text) + [
            posixpath.normpath(posixpath.join(folder, i)) for i in IMPORT.findall(text)]
        graph[noun] |= {noun_of(i) for i in others} & nouns - {noun}
    return graph


def circles(graph):
    """Nouns left when those that include nothing that is left have been taken away, and those that
    nothing left includes: every circle, and what lies between two of them."""
    left = {noun: set(others) for noun, others in graph.items()}
    for _ in range(2):
        ends = [noun for noun, others in left.items() if not others]
        while ends:
            for noun in ends:
                del left[noun]
            for others in left.values():
                others.difference_update(ends)
            ends = [noun for noun, others in left.items() if not others]
        backwards = {noun: set() for noun in left}
        for noun, others in left.items():
            for other in others:
                backwards[other].add(noun)
        left = backwards
    return sorted(left)


def faults(files):
    found = []
    ring = circles(includes_of(files))
    if ring:
        found.append("includes in a circle: " + ", ".join(ring))
    for path, text in files.items():
        room = room_of(path)
        for include in INCLUDE.findall(text):
            other = room_of(include)
            if room and other and other != room and other not in ARROWS[room]:
                found.append(f"{path} includes {include}: {room} may not know {other}")
    rooms = collections.Counter(path.rsplit("/", 1)[0] for path in files)
    found += [f"{room} has {count} files side by side; at most {MOST_FILES}"
              for room, count in rooms.items() if count > MOST_FILES]
    return found


def planted():
    """Each fault in a house that is in order but for it, so that a check that finds none says so."""
    sound = {"model/a.h": "", "model/b.h": '#include "model/a.h"\n',
             "verifier/c.h": '#include "model/b.h"\n', "verifier/c.cpp": '#include "verifier/c.h"\n'}
    assert not faults(sound)
    circle = sound | {"model/a.cpp": '#include "model/a.h"\n#include "model/b.h"\n'}
    assert faults(circle) == ["includes in a circle: model/a, model/b"], faults(circle)
    scripts = sound | {"reports/web/a.js": "import { b } from './view/b.js';\n",
                       "reports/web/view/b.js": "import {\n  a,\n} from '../a.js';\n"}
    assert faults(scripts) == ["includes in a circle: reports/web/a, reports/web/view/b"], faults(scripts)
    against = sound | {"simulator/d.h": '#include "verifier/c.h"\n'}
    assert len(faults(against)) == 1 and "may not know verifier" in faults(against)[0]
    full = sound | {f"study/n{i}.h": "" for i in range(MOST_FILES + 1)}
    assert len(faults(full)) == 1 and "side by side" in faults(full)[0]


def main():
    planted()
    files = read_tree(pathlib.Path(sys.argv[1]))
    assert len(files) > 100, "this is no source tree of the project"
    found = faults(files)
    print("\n".join(found) or f"{len(files)} files in order")
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main())
