#!/usr/bin/env python3
"""Kills runs with SIGKILL at random moments, takes them up again, and compares with the run nobody killed.

usage: kills.py PROGRAM [--repeats N] [--seed S]

Each repeat begins a simulation or a batch with --out, kills it after a random part of the time it takes, kills
some of the resumed runs too, and lets the last one come to its end. Nothing may be lost or doubled: every file of
the directory has the bytes of the uninterrupted run, but for the time it took.
"""
import argparse
import json
import pathlib
import random
import shutil
import subprocess
import sys
import tempfile
import time

MOST_KILLS = 3  # of one run
NO_RUN = 2      # killed before the question was written: there is nothing to take up


def timeless(answer):
    """The bytes of an answer without what depends on how busy the machine is."""
    for name in ("wall_time", "updates_per_second"):
        answer.get("simulation", {}).pop(name, None)
    return json.dumps(answer)


def content(directory):
    """Every file that belongs to the result, by name."""
    files = {}
    for path in sorted(directory.rglob("*")):
        name = str(path.relative_to(directory))
        if not path.is_file() or name in ("lock", "question.json", "checkpoint.cbor"):
            continue
        files[name] = timeless(json.loads(path.read_text())) if name == "answer.json" else path.read_bytes()
    return files


class Kind:
    """One kind of run: what is asked, and what it gives when nobody interferes."""

    def __init__(self, program, name, options, scratch):
        self.program, self.name, self.options, self.scratch = program, name, options, scratch
        reference = scratch / f"{name}-reference"
        begin = time.monotonic()
        self.call("--out", reference)
        self.seconds = time.monotonic() - begin
        self.content = content(reference)

    def start(self, *arguments):
        return subprocess.Popen([self.program, "-q", "--checkpoint-interval", "0.02s", *map(str, arguments)],
                                stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, text=True)

    def call(self, verb, directory):
        run = self.start(*(self.options if verb == "--out" else []), verb, directory)
        _, complaint = run.communicate()
        return run.returncode, complaint

    def repeat(self, rng):
        """Returns how many kills met a run at work; raises when the end is not that of the reference."""
        directory = self.scratch / "run"
        shutil.rmtree(directory, ignore_errors=True)
        verb, kills = "--out", 0
        for _ in range(rng.randint(1, MOST_KILLS)):
            run = self.start(*(self.options if verb == "--out" else []), verb, directory)
            try:
                run.wait(rng.uniform(0.0, 1.1 * self.seconds))
            except subprocess.TimeoutExpired:
                run.kill()
                kills += 1
            run.communicate()
            verb = "--resume" if (directory / "question.json").exists() else "--out"
        status, complaint = self.call(verb, directory)
        if status != 0:
            raise AssertionError(f"{self.name}: {verb} ended with {status}: {complaint}")
        found = content(directory)
        for name in sorted(set(found) | set(self.content)):
            if found.get(name) != self.content.get(name):
                raise AssertionError(f"{self.name}: {name} is not that of the uninterrupted run")
        return kills


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("program")
    parser.add_argument("--repeats", type=int, default=6)
    parser.add_argument("--seed", type=int, default=1)
    given = parser.parse_args()
    rng = random.Random(given.seed)
    with tempfile.TemporaryDirectory(prefix="bioprint-kills-") as name:
        scratch = pathlib.Path(name)
        kinds = [Kind(given.program, "exit", ["--simulate=exit", "--resolution", "3"], scratch),
                 Kind(given.program, "exit-flow", ["--simulate=exit-flow", "--resolution", "4"], scratch),
                 Kind(given.program, "channel", ["--simulate=channel", "--resolution", "6"], scratch)]
        total = {kind.name: [0, 0] for kind in kinds}
        failures = []
        for i in range(given.repeats):
            kind = kinds[i % len(kinds)]
            try:
                total[kind.name][1] += kind.repeat(rng)
                total[kind.name][0] += 1
            except AssertionError as failure:
                failures.append(str(failure))
                print(failure, file=sys.stderr)
        for name, (runs, kills) in total.items():
            print(f"{name:10} {runs:4} runs, killed {kills:4} times, each ended in the same bytes")
        sys.exit(1 if failures else 0)


if __name__ == "__main__":
    main()
