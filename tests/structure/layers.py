#!/usr/bin/env python3
"""Reads the #includes of src/ and include/ and names every one that breaks the map of the house.

usage: layers.py ROOT          exit 1 and one line a breach
       layers.py --self-test   the check itself: each kind of breach is found, and nothing else

Rules: a room includes only rooms on lower floors, and itself; a library has one room that may use it; what is installed
(include/) includes only the standard library and other installed headers.
"""
import re
import sys
import tempfile
from pathlib import Path

FLOORS = [
    ["numerics", "lattice", "solid"],
    ["rheology"],
    ["flow", "cell"],
    ["simulate"],
    ["predict"],
    ["io"],
    ["cli"],
]
FLOOR = {room: number for number, rooms in enumerate(FLOORS, 1) for room in rooms}
# first folder of the include → the one room that may write it
OWNER = {"gsl": "numerics", "nlohmann": "io", "CLI": "cli"}
INCLUDE = re.compile(r'^\s*#\s*include\s*([<"])([^>"]+)[>"]')
SUFFIXES = {".cpp", ".hpp", ".h", ".c"}


def room_of(parts):
    """The room a path below src/ or include/bioprint/ belongs to; None for a header of the whole house."""
    return parts[0] if len(parts) > 1 else None


def breaches(root):
    found = []
    for top in (root / "src", root / "include" / "bioprint"):
        public = top.name == "bioprint"
        for file in sorted(p for p in top.rglob("*") if p.suffix in SUFFIXES):
            room = room_of(file.relative_to(top).parts)
            where = file.relative_to(root)
            if room is not None and room not in FLOOR:
                found.append(f"{where}: there is no room {room} on the map")
                continue
            for number, line in enumerate(file.read_text(encoding="utf-8").splitlines(), 1):
                match = INCLUDE.match(line)
                if match:
                    reason = judge(room, public, match[1], match[2])
                    if reason:
                        found.append(f"{where}:{number}: {reason}")
    return found


def judge(room, public, bracket, name):
    """Why a file of `room` may not include `name`, or None."""
    parts = Path(name).parts
    ours_public = parts[0] == "bioprint"
    target = room_of(parts[1:]) if ours_public else parts[0]
    if ".." in parts:
        return f"{name} leaves its folder; name the room instead"
    if ours_public or target in FLOOR:
        if target is None:
            return None
        if target not in FLOOR:
            return f"{name}: there is no room {target} on the map"
        if public and not ours_public:
            return f"an installed header includes {name}, which is not installed"
        if room is None:
            return f"a header of the whole house includes {name}, a room's"
        if target != room and FLOOR[target] >= FLOOR[room]:
            return f"{room} (floor {FLOOR[room]}) includes {name} of {target} (floor {FLOOR[target]})"
        return None
    owner = OWNER.get(parts[0])
    if owner and owner != room:
        return f"{name} is for {owner} alone"
    if public and (bracket == '"' or "/" in name or name.endswith(".h")):
        return f"an installed header includes {name}: its users would need that too"
    return None


def self_test():
    cases = [
        # file, include, is a breach
        ("src/flow/a.cpp", '"bioprint/rheology/cross.hpp"', False),
        ("src/flow/a.cpp", '"flow/own.hpp"', False),
        ("src/flow/a.cpp", '"numerics/roots.hpp"', False),
        ("src/cell/a.cpp", "<cmath>", False),
        ("src/numerics/a.cpp", "<gsl/gsl_errno.h>", False),
        ("src/io/a.cpp", "<nlohmann/json.hpp>", False),
        ("src/cli/a.cpp", "<CLI/CLI.hpp>", False),
        ("src/cell/a.cpp", '"bioprint/errors.hpp"', False),
        ("include/bioprint/flow/a.hpp", '"bioprint/rheology/cross.hpp"', False),
        ("src/simulate/a.cpp", '"lattice/a.hpp"', False),
        ("src/flow/a.cpp", '"bioprint/cell/roscoe.hpp"', True),
        ("src/rheology/a.cpp", '"bioprint/flow/nozzle_flow.hpp"', True),
        ("src/numerics/a.cpp", '"bioprint/rheology/cross.hpp"', True),
        ("src/lattice/a.cpp", '"numerics/roots.hpp"', True),
        ("src/predict/a.cpp", '"bioprint/io/json.hpp"', True),
        ("src/flow/a.cpp", "<gsl/gsl_roots.h>", True),
        ("src/predict/a.cpp", "<nlohmann/json.hpp>", True),
        ("src/io/a.cpp", "<CLI/CLI.hpp>", True),
        ("src/kitchen/a.cpp", "<cmath>", True),
        ("src/flow/a.cpp", '"../cell/own.hpp"', True),
        ("src/flow/a.cpp", '"bioprint/kitchen/a.hpp"', True),
        ("include/bioprint/flow/a.hpp", '"flow/own.hpp"', True),
        ("include/bioprint/flow/a.hpp", "<Eigen/Dense>", True),
        ("include/bioprint/errors.hpp", '"bioprint/flow/a.hpp"', True),
    ]
    for file, include, is_breach in cases:
        with tempfile.TemporaryDirectory() as folder:
            path = Path(folder) / file
            path.parent.mkdir(parents=True)
            path.write_text(f"// a file\n#  include {include}\n", encoding="utf-8")
            found = breaches(Path(folder))
            if bool(found) != is_breach:
                sys.exit(f"{file} including {include}: expected {'a breach' if is_breach else 'none'}, found {found}")
    print(f"{len(cases)} cases judged right")


def main():
    if sys.argv[1:] == ["--self-test"]:
        return self_test()
    root = Path(sys.argv[1]).resolve()
    found = breaches(root)
    print("\n".join(found))
    files = sum(1 for top in ("src", "include") for p in (root / top).rglob("*") if p.suffix in SUFFIXES)
    if files == 0:
        sys.exit("no source found: is this the root of the project?")
    print(f"{files} files read, {len(found)} breaches")
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main())
