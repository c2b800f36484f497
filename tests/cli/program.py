"""The real program, called as a user calls it; each test file is run as `FILE PROGRAM EXAMPLES`."""
import os
import shutil
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

PROGRAM = Path(sys.argv[1]).resolve() if len(sys.argv) > 2 else None
EXAMPLES = Path(sys.argv[2]).resolve() if len(sys.argv) > 2 else None
SKIPPED = 77


def need(*programs):
    """Ends the test as skipped where a program it stands on is not installed."""
    for program in programs:
        if shutil.which(program) is None:
            print(f"skipped: {program} is not installed")
            sys.exit(SKIPPED)


def ink_named(name):
    """An ink as a user writes one down."""
    parameters = {"eta0": (10, "Pa.s"), "time_constant": (0.05, "s"), "alpha": (0.75, "1")}
    return {
        "name": name,
        "parameters": {key: {"value": value, "unit": unit} for key, (value, unit) in parameters.items()},
        "source": "me",
        "grade": "B",
    }


class Case(unittest.TestCase):
    """Every test in an empty folder of its own."""

    def setUp(self):
        self.folder = Path(tempfile.mkdtemp())
        self.addCleanup(shutil.rmtree, self.folder, ignore_errors=True)

    def call(self, *arguments, status=0, env=None, stdin=""):
        done = subprocess.run([PROGRAM, *arguments], cwd=self.folder, input=stdin.encode(), capture_output=True,
                              env={**os.environ, **(env or {})}, timeout=120, check=False)
        err = done.stderr.decode("utf-8", "replace")
        self.assertEqual(done.returncode, status, err)
        self.out, self.err = done.stdout, err
        return done.stdout.decode("utf-8", "replace")

    def read(self, name):
        return (self.folder / name).read_bytes()

    def write(self, name, text):
        (self.folder / name).write_bytes(text if isinstance(text, bytes) else text.encode())

    def names(self):
        return sorted(path.name for path in self.folder.iterdir())


def main():
    unittest.main(argv=sys.argv[:1], verbosity=1)
