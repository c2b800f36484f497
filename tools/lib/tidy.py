#!/usr/bin/env python3
"""clang-tidy over the sources of a compile database, two at a time, skipping what has not changed since it last passed.

usage: tidy.py BUILD_DIR [FILE…]

A source that passed leaves a stamp in BUILD_DIR/tidy, named by a hash of everything the verdict depends on: the source and the
project's headers it includes, its compile command, .clang-tidy and the version of clang-tidy.

Of a room whose sources may be compiled together (they are, under the sanitizers), six are checked at once: most of the time goes
into the JSON library that each of them includes.
"""
import hashlib
import json
import os
import re
import shlex
import subprocess
import sys
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
TOGETHER = "/bioprint_io.dir/"  # in the objects of that room
AT_ONCE = 6


def compiler_arguments(entry):
    """Those of the compiler, without the header that only GCC has precompiled: a source must do without it."""
    arguments = entry.get("arguments") or shlex.split(entry["command"])
    plain = []
    for argument in arguments:
        if plain and plain[-1] == "-include" and "cmake_pch" in argument:
            plain.pop()
        elif argument != "-Winvalid-pch":
            plain.append(argument)
    return plain


def project_files(entry):
    """The source and every header of this repository that it includes, as the compiler sees them."""
    arguments = list(entry["arguments"])
    if "-o" in arguments:
        at = arguments.index("-o")
        del arguments[at : at + 2]
    rule = subprocess.run(
        [*arguments, "-MM", "-MT", "x"], cwd=entry["directory"], capture_output=True, text=True, check=True
    ).stdout
    names = shlex.split(rule.replace("\\\n", " ").split(":", 1)[1])
    return sorted({(Path(entry["directory"]) / name).resolve() for name in names})


def joined(entries, stamps):
    """The entries with those of the room above six at a time, each group as a source that includes them."""
    together = [e for e in entries if any(TOGETHER in a for a in e["arguments"])]
    units = [e for e in entries if e not in together]
    for begin in range(0, len(together), AT_ONCE):
        group = together[begin : begin + AT_ONCE]
        unit = stamps / f"group-{begin // AT_ONCE}.cpp"
        lines = "".join(f'#include "{entry["file"]}"  // NOLINT\n' for entry in group)
        if not unit.exists() or unit.read_text() != lines:
            unit.write_text(lines)
        arguments = [str(unit) if a == group[0]["file"] else a for a in group[0]["arguments"]]
        units.append({**group[0], "file": str(unit), "arguments": arguments})
    return units


def stamp_name(entry, common):
    digest = hashlib.sha256(common)
    digest.update(" ".join(entry["arguments"]).encode())
    for file in project_files(entry):
        digest.update(str(file).encode() + b"\0" + file.read_bytes() + b"\0")
    return digest.hexdigest()


def check(entry, stamps, common):
    """None when the file passes, else what clang-tidy says."""
    stamp = stamps / stamp_name(entry, common)
    if stamp.exists():
        return None
    done = subprocess.run(
        ["clang-tidy", "--quiet", "-p", str(stamps), entry["file"]], cwd=ROOT, capture_output=True, text=True
    )
    if done.returncode != 0:
        # "N warnings generated" on standard error counts suppressed ones of system headers too.
        return done.stdout + re.sub(r"^\d+ warnings? .*\n?", "", done.stderr, flags=re.M)
    stamp.touch()
    return None


def main():
    build = Path(sys.argv[1]).resolve()
    wanted = {Path(name).resolve() for name in sys.argv[2:]}
    stamps = build / "tidy"
    stamps.mkdir(exist_ok=True)
    version = subprocess.run(["clang-tidy", "--version"], capture_output=True, check=True).stdout
    common = version + (ROOT / ".clang-tidy").read_bytes()
    entries = {}
    for entry in json.loads((build / "compile_commands.json").read_text()):
        file = Path(entry["file"]).resolve()
        if file in wanted or (not wanted and ROOT / "src" in file.parents):
            entries[file] = {key: entry[key] for key in ("directory", "file")} | {
                "arguments": compiler_arguments(entry)
            }
    if not entries:
        sys.exit("tidy: no source found in the compile database")
    units = list(entries.values()) if wanted else joined(list(entries.values()), stamps)
    (stamps / "compile_commands.json").write_text(json.dumps(units))
    failed = 0
    with ThreadPoolExecutor(min(2, os.cpu_count() or 1)) as pool:
        for complaint in pool.map(lambda e: check(e, stamps, common), units):
            if complaint is not None:
                failed += 1
                print(complaint, flush=True)
    print(f"clang-tidy: {len(entries)} sources" + (f", findings in {failed} units" if failed else " are clean"))
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main())
