#!/usr/bin/env python3
"""What a machine can do to a run: full disk, no place to write, closed pipe, two runs at once, a signal.

usage: faults.py PROGRAM

Every fault ends in its exit status and one clear line, leaves no part of a file, and is no obstacle to going on.
"""
import pathlib
import resource
import signal
import subprocess
import sys
import tempfile
import time
import unittest

PROGRAM = None
CALL_REFUSED, NOT_WRITTEN, INTERRUPTED = 2, 4, 130
ROWS = ["--radius", "40um:80um:0.02um", "--model", "steady"]
LONG = ["--simulate=exit", "--fidelity", "fine"]


def small_files():
    """As on a full disk: writing fails when a file grows past 100 kB."""
    signal.signal(signal.SIGXFSZ, signal.SIG_IGN)
    resource.setrlimit(resource.RLIMIT_FSIZE, (100_000, 100_000))


class Faults(unittest.TestCase):
    def setUp(self):
        scratch = tempfile.TemporaryDirectory(prefix="bioprint-faults-")
        self.addCleanup(scratch.cleanup)
        self.scratch = pathlib.Path(scratch.name)

    def run_of(self, *arguments, **how):
        return subprocess.run([PROGRAM, "-q", *map(str, arguments)], capture_output=True, text=True, **how)

    def check_refused(self, outcome, status, *parts):
        self.assertEqual(outcome.returncode, status, outcome.stderr)
        self.assertEqual(outcome.stderr.count("\n"), 1, outcome.stderr)
        self.assertTrue(outcome.stderr.startswith("bioprint-predict: "))
        for part in parts:
            self.assertIn(part, outcome.stderr)

    def test_a_batch_on_a_full_disk_goes_on_when_there_is_room(self):
        plain = self.scratch / "plain.csv"
        self.run_of(*ROWS, "--format", "csv", "-o", plain)
        directory = self.scratch / "run"
        full = self.run_of(*ROWS, "--out", directory, "--checkpoint-interval", "0s", preexec_fn=small_files)
        self.check_refused(full, NOT_WRITTEN, "answers.unfinished: cannot be written", "File too large")
        self.assertFalse((directory / "answers.csv").exists())
        self.assertEqual(self.run_of("--resume", directory).returncode, 0)
        self.assertEqual((directory / "answers.csv").read_bytes(), plain.read_bytes())

    def test_a_simulation_on_a_full_disk_keeps_what_it_had(self):
        directory = self.scratch / "run"
        full = self.run_of("--simulate=exit", "--fidelity", "draft", "--out", directory, "--checkpoint-interval",
                           "0s", preexec_fn=small_files)
        self.check_refused(full, NOT_WRITTEN, "cannot be written", "File too large")
        self.assertFalse((directory / "answer.json").exists())
        for path in directory.rglob("*"):
            self.assertNotEqual(path.suffix, ".part")
        self.assertEqual(self.run_of("--resume", directory).returncode, 0)
        self.assertTrue((directory / "answer.json").exists())

    def test_an_output_file_on_a_full_disk_is_not_there(self):
        output = self.scratch / "rows.csv"
        full = self.run_of(*ROWS, "--format", "csv", "-o", output, preexec_fn=small_files)
        self.check_refused(full, NOT_WRITTEN, "rows.csv: cannot be written")
        self.assertEqual(list(self.scratch.iterdir()), [])

    def test_a_limit_on_files_as_a_shell_sets_it_is_a_failed_write(self):
        script = f"ulimit -f 10; '{PROGRAM}' -q {' '.join(ROWS)} --format csv > '{self.scratch}/rows.csv'"
        limited = subprocess.run(["bash", "-c", script], capture_output=True, text=True, check=False,
                                 preexec_fn=lambda: signal.signal(signal.SIGXFSZ, signal.SIG_DFL))
        self.check_refused(limited, NOT_WRITTEN, "standard output: cannot be written", "File too large")

    def test_whatever_cannot_be_written_to_standard_output_says_why(self):
        for arguments in ([], ["--help"], ["--version"], ["fit", "--help"], ["--list", "inks"], ["--dry-run"]):
            with open("/dev/full", "w", encoding="utf-8") as full:
                outcome = subprocess.run([PROGRAM, *arguments], stdout=full, stderr=subprocess.PIPE, text=True, check=False)
            self.check_refused(outcome, NOT_WRITTEN, "standard output: cannot be written: No space left on device")

    def test_a_place_that_cannot_be_written_is_named(self):
        self.check_refused(self.run_of("--simulate", "--out", "/proc/run"), NOT_WRITTEN, "/proc/run: cannot be made")
        file = self.scratch / "file"
        file.touch()
        self.check_refused(self.run_of("--simulate", "--out", file), NOT_WRITTEN, "cannot be made")

    def test_a_preset_that_cannot_be_read_leaves_no_directory(self):
        directory = self.scratch / "run"
        self.check_refused(self.run_of("--simulate", "--ink", "/", "--out", directory), NOT_WRITTEN, "cannot be read")
        self.assertFalse(directory.exists())

    def test_a_closed_standard_output_leaves_the_answer_in_the_directory(self):
        directory = self.scratch / "run"
        call = f"'{PROGRAM}' -q --simulate=channel --fidelity draft --out '{directory}' >&-"
        outcome = subprocess.run(["sh", "-c", call], capture_output=True, text=True)
        self.check_refused(outcome, NOT_WRITTEN)
        self.assertTrue((directory / "answer.json").exists())

    def test_a_second_run_in_the_same_directory_is_refused_and_the_first_goes_on(self):
        directory = self.scratch / "run"
        first = subprocess.Popen([PROGRAM, "-q", *LONG, "--out", str(directory)], stdout=subprocess.DEVNULL,
                                 stderr=subprocess.PIPE, text=True)
        try:
            deadline = time.monotonic() + 60
            while not (directory / "question.json").exists() and time.monotonic() < deadline:
                time.sleep(0.01)
            for arguments in (["--resume", directory], [*LONG, "--out", directory]):
                self.check_refused(self.run_of(*arguments), NOT_WRITTEN, "another run is at work there")
            self.assertIsNone(first.poll())
            first.send_signal(signal.SIGTERM)
            _, complaint = first.communicate(timeout=60)
        finally:
            first.kill()
        self.assertEqual(first.returncode, INTERRUPTED)
        self.assertIn(f"--resume {directory}", complaint)
        self.assertTrue((directory / "checkpoint.cbor").exists())

    def test_a_directory_without_a_run_is_refused(self):
        self.check_refused(self.run_of("--resume", self.scratch), CALL_REFUSED, "holds no run")


if __name__ == "__main__":
    PROGRAM = sys.argv.pop(1)
    unittest.main()
