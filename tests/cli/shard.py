#!/usr/bin/env python3
"""`--shard K/N`: the pieces of a batch or sweep, joined in order, are the whole, byte for byte."""
from program import Case, main


class Shard(Case):
    def joined(self, pieces, *arguments, status=0):
        whole = self.call("-q", *arguments, status=status)
        joined = b""
        for k in range(1, pieces + 1):
            # Each piece reports its own rows only; a failed row of the whole fails one piece.
            done = self.run_piece(f"{k}/{pieces}", *arguments, allowed=(0, status))
            joined += done
        self.assertEqual(joined.decode(), whole)

    def run_piece(self, shard, *arguments, allowed=(0,)):
        import subprocess

        from program import PROGRAM

        done = subprocess.run([PROGRAM, "-q", *arguments, "--shard", shard], cwd=self.folder, capture_output=True, check=False)
        self.assertIn(done.returncode, allowed, done.stderr)
        return done.stdout

    def csv(self, rows, end="\n", last="\n"):
        lines = ["name,radius [um],note"] + [f"r{i},{40 + i % 50},\"a\n b\"" if i % 7 == 3 else f"r{i},{40 + i % 50}," for i in range(rows)]
        return end.join(lines) + last

    def test_sweeps_in_every_form_that_can_be_joined(self):
        sweep = ["--alpha", "0:0.9:0.1", "--velocity", "1mm/s,5mm/s"]
        for form in (["--format", "csv"], ["--format", "jsonl"], ["--get", "nozzle.stress_max", "--get", "input.radius"]):
            for pieces in (1, 2, 3, 7, 25):
                self.joined(pieces, *sweep, *form)

    def test_a_csv_of_more_rows_than_are_held_at_once(self):
        self.write("runs.csv", self.csv(5000))
        self.joined(3, "--batch", "runs.csv", "--model", "steady", "--offset", "0")

    def test_a_csv_with_blank_lines_crlf_and_no_last_line_end(self):
        text = self.csv(20, "\r\n", "")
        self.write("runs.csv", text.replace("r5", "\r\nr5").replace("r11", "\r\n\r\nr11"))
        for pieces in (1, 2, 5, 40):
            self.joined(pieces, "--batch", "runs.csv")

    def test_a_semicolon_csv_with_a_preamble(self):
        self.write("runs.csv", "\ufeffsep=;\nradius;alpha\n" + "".join(f"{50 + i}um;0,{i}\n" for i in range(9)))
        self.joined(4, "--batch", "runs.csv")

    def test_rows_that_fail(self):
        self.write("runs.csv", "radius,alpha\n50um,0.7\n5s,0.7\n50um,1.2\n60um,0.7\n50um,0.7,8,9\n")
        self.joined(2, "--batch", "runs.csv", status=6)
        self.assertEqual(self.run_piece("1/5", "--batch", "runs.csv").count(b"\n"), 2)

    def test_rows_that_choose_their_positions_keep_the_columns_of_the_first(self):
        self.write("runs.csv", 'radius,offset\n50um,"0,10um,20um"\n50um,0\n50um,"0,5um"\n')
        self.joined(3, "--batch", "runs.csv")

    def test_json_lines(self):
        self.write("q.jsonl", "".join('{"radius": "%dum"}\n' % (40 + i) for i in range(11)) + '\n{"radius": "5s"}')
        for pieces in (1, 2, 4, 30):
            self.joined(pieces, "--batch", "q.jsonl", status=6)
        self.joined(3, "--batch", "q.jsonl", "--format", "csv", status=6)

    def test_an_empty_batch(self):
        self.write("runs.csv", "radius\n")
        self.joined(3, "--batch", "runs.csv")

    def test_what_cannot_be_joined_is_refused(self):
        self.write("runs.csv", "radius\n50um\n")
        for arguments, words in (
            (["--batch", "runs.csv", "--shard", "0/3"], "1/N to N/N"),
            (["--batch", "runs.csv", "--shard", "4/3"], "'4/3'"),
            (["--batch", "runs.csv", "--shard", "1/3x"], "1/N to N/N"),
            (["--batch", "runs.csv", "--shard", "-1/3"], "1/N to N/N"),
            (["--batch", "runs.csv", "--shard", "1/2", "--format", "json"], "jsonl"),
            (["--alpha", "0,1", "--shard", "1/2"], "csv or jsonl"),
            (["--shard", "1/2"], "no pieces"),
            (["--batch", "-", "--shard", "1/2"], "give a file"),
        ):  # fmt: skip
            self.call("-q", *arguments, status=2)
            self.assertIn(words, self.err)
            self.assertEqual(len(self.err.splitlines()), 1, self.err)


main()
