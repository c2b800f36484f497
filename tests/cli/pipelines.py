#!/usr/bin/env python3
"""The program in pipelines: GNU parallel, xargs, a Slurm array job."""
import os
import shutil
import socket
import subprocess

from program import EXAMPLES, PROGRAM, Case, main, need

need("parallel", "xargs", "shellcheck")


class Pipelines(Case):
    def setUp(self):
        super().setUp()
        (self.folder / "bin").mkdir()
        (self.folder / "bin" / "bioprint-predict").symlink_to(PROGRAM)
        rows = "".join(f"run {i},{40 + i}\n" for i in range(30))
        self.write("runs.csv", "name,radius [um]\n" + rows + "bad,-1\n")
        self.whole = self.call("-q", "--batch", "runs.csv", status=6)

    def shell(self, script, env=None):
        path = f"{self.folder / 'bin'}:/usr/bin:/bin"
        environment = {"PATH": path, "HOME": str(self.folder), "LC_ALL": "C.UTF-8", **(env or {})}
        for name in ("ASAN_OPTIONS", "UBSAN_OPTIONS"):
            if name in os.environ:
                environment[name] = os.environ[name]
        done = subprocess.run(["bash", "-c", script], cwd=self.folder, env=environment, capture_output=True, timeout=100, check=False)
        self.assertEqual(done.returncode, 0, done.stderr.decode())
        return done.stdout.decode()

    def test_a_line_on_standard_error_is_written_in_one_piece(self):
        """Where both outputs are one file the answer must not stand inside a line of a note."""
        self.write("curve.csv", "".join(f"{10 ** i} {5 / (1 + 10 ** i)}\n" for i in range(-2, 3)))
        for arguments in (["--get", "nozzle.stress_max"], ["--radius", "5s"], ["fit", "curve.csv", "--get", "fit.law"]):
            # A packet for each write.
            ours, theirs = socket.socketpair(socket.AF_UNIX, socket.SOCK_SEQPACKET)
            subprocess.run([PROGRAM, *arguments], cwd=self.folder, stdout=subprocess.DEVNULL, stderr=theirs, timeout=100, check=False)
            theirs.close()
            packets = []
            while packet := ours.recv(65536):
                packets.append(packet.decode())
            ours.close()
            self.assertGreater(len(packets), 0)
            for packet in packets:
                self.assertRegex(packet, r"\Abioprint-predict: .*\n\Z", arguments)

    def test_gnu_parallel_joins_pieces_in_order(self):
        text = self.shell("parallel --will-cite -k 'bioprint-predict -q --batch runs.csv --shard {}/4 || test $? = 6' ::: 1 2 3 4")
        self.assertEqual(text, self.whole)

    def test_xargs_asks_one_question_a_line(self):
        text = self.shell("printf '%s\\n' 0 0.3 0.75 | xargs -I{} bioprint-predict -q --alpha {} --get nozzle.stress_max")
        self.assertEqual(text, self.call("-q", "--alpha", "0,0.3,0.75", "--get", "nozzle.stress_max"))

    def test_the_slurm_array_job_gives_the_whole(self):
        shutil.copy(EXAMPLES / "slurm-array.sh", self.folder)
        self.shell("shellcheck slurm-array.sh")
        for task in range(1, 13):
            self.shell("bash slurm-array.sh runs.csv", {"SLURM_ARRAY_TASK_ID": str(task), "SLURM_ARRAY_TASK_COUNT": "12"})
        shutil.copy(EXAMPLES / "join-pieces.sh", self.folder)
        self.assertEqual(self.shell("bash join-pieces.sh runs.piece-*.csv"), self.whole)
        self.assertEqual(self.shell("cat $(ls -v runs.piece-*.csv)"), self.whole)

    def joined(self, script):
        """Status and complaint of the collector; it must not have written anything."""
        text = self.shell(script + " > joined 2> said; echo $?; wc -c < joined; cat said")
        status, size, said = text.split("\n", 2)
        self.assertEqual(size, "0")
        self.assertEqual(len(said.splitlines()), 1, said)
        return int(status), said

    def test_the_collector_refuses_what_is_not_the_whole(self):
        shutil.copy(EXAMPLES / "join-pieces.sh", self.folder)
        self.shell("shellcheck join-pieces.sh; mkdir p; for k in 1 2 3; do bioprint-predict -q --batch runs.csv --shard $k/3"
                   " -o p/r.piece-$k-of-3.csv || test $? = 6; done")  # fmt: skip
        join = "bash join-pieces.sh "
        self.assertEqual(self.shell(join + "p/r.piece-3-of-3.csv p/r.piece-1-of-3.csv p/r.piece-2-of-3.csv"), self.whole)
        status, said = self.joined(join + "p/r.piece-1-of-3.csv p/r.piece-3-of-3.csv")
        self.assertEqual(status, 4)
        self.assertIn("missing: 2; answer them again with --shard K/3", said)
        self.shell("mkdir twice; cp p/r.piece-2-of-3.csv twice")
        status, said = self.joined(join + "p/*.csv twice/*.csv")
        self.assertEqual(status, 4)
        self.assertIn("piece 2 is there twice", said)
        status, said = self.joined(join + "p/*.csv p/r.piece-2-of-3.csv")
        self.assertEqual(status, 4)
        self.shell("mkdir other; cp p/r.piece-2-of-3.csv other/r.piece-2-of-4.csv")
        self.assertIn("of a split in 4", self.joined(join + "p/*.csv other/*.csv")[1])
        self.shell("mkdir mixed; cp p/* mixed; mv mixed/r.piece-2-of-3.csv mixed/s.piece-2-of-3.csv")
        status, said = self.joined(join + "mixed/*.csv")
        self.assertEqual(status, 4)
        self.assertIn("of another batch", said)
        self.shell("mkdir cut; cp p/* cut; truncate -s -5 cut/r.piece-2-of-3.csv")
        self.assertIn("cut short", self.joined(join + "cut/*.csv")[1])
        self.shell("cp p/* cut; cp p/r.piece-1-of-3.csv cut/r.piece-2-of-3.csv")
        self.assertIn("begins with the head", self.joined(join + "cut/*.csv")[1])
        self.assertEqual(self.joined(join)[0], 2)
        self.assertEqual(self.joined(join + "runs.csv")[0], 2)
        self.assertEqual(self.joined(join + "p/*.csv none-4-of-3")[0], 2)
        self.assertEqual(self.joined(join + "p/r.piece-1-of-3.csv p/r.piece-2-of-3.csv none-3-of-3")[0], 4)

    def pieces_of(self, batch, n):
        """The pieces of a batch in the folder s, and its whole."""
        shutil.copy(EXAMPLES / "join-pieces.sh", self.folder)
        self.shell(f"rm -rf s; mkdir s; for k in $(seq {n}); do bioprint-predict -q --batch {batch} --shard $k/{n}"
                   f" -o s/r.piece-$k-of-{n}.out || test $? = 6; done")  # fmt: skip
        return self.shell(f"bioprint-predict -q --batch {batch} || test $? = 6")

    def test_the_collector_counts_the_rows(self):
        join = "bash join-pieces.sh "
        self.write("many.csv", "name,radius [um]\n" + "".join(f"run {i},{40 + i}\n" for i in range(59)))
        whole = self.pieces_of("many.csv", 4)
        for checked in ("", "--rows 59 ", "--batch many.csv "):
            self.assertEqual(self.shell(join + checked + "s/*"), whole)
            for spoil, words in (
                ("sed -i '$d' s/r.piece-2-of-4.out", "piece-2-of-4.out: holds 14"),
                (": > s/r.piece-2-of-4.out", "piece-2-of-4.out: holds 0"),
                (": > s/r.piece-4-of-4.out", "piece-4-of-4.out: holds 0"),
                ("sed -i '$d' s/r.piece-1-of-4.out", "piece-1-of-4.out: holds 14"),
                ("cp s/r.piece-3-of-4.out s/r.piece-2-of-4.out", "the same as piece 2"),
            ):  # fmt: skip
                self.shell("mkdir -p kept; cp s/* kept; " + spoil)
                status, said = self.joined(join + checked + "s/*")
                self.assertEqual(status, 4)
                self.assertIn(words, said)
                self.shell("cp kept/* s")
        self.shell("sed -i '$d' s/r.piece-3-of-4.out")  # as fair a sharing of 58 rows
        for checked in ("--rows 59 ", "--batch many.csv "):
            status, said = self.joined(join + checked + "s/*")
            self.assertEqual(status, 4)
            self.assertIn("piece-3-of-4.out: holds 14 rows where piece 3 of 4 has 15", said)

    def test_the_collector_counts_rows_of_every_form(self):
        join = "bash join-pieces.sh "
        self.write("odd.csv", 'sep=;\n"na\nme";radius [um]\n"a\n b";50\n\n"say ""x""";51\n5" pipe;52\n"";53\n;54\n"open;55\n56;')
        self.write("q.jsonl", "".join('{"radius": "%dum", "id": "a \\" b"}\n' % (40 + i) for i in range(11)) + "\n")
        self.write("twins.jsonl", '{"radius": "50um"}\n' * 6)
        for batch, n in (("odd.csv", 2), ("odd.csv", 3), ("odd.csv", 9), ("q.jsonl", 4), ("q.jsonl", 20)):
            whole = self.pieces_of(batch, n)
            self.assertEqual(self.shell(join + "s/*"), whole)
            self.assertEqual(self.shell(join + f"--batch {batch} s/*"), whole)
        whole = self.pieces_of("twins.jsonl", 3)
        self.assertIn("--repeats", self.joined(join + "s/*")[1])
        self.assertEqual(self.shell(join + "--repeats --batch twins.jsonl s/*"), whole)
        for call in ("--rows", "--rows x s/*", "--batch none s/*", "--batch q.jsonl --rows 3 s/*", "--other s/*"):
            self.assertEqual(self.joined(join + call)[0], 2)

    def test_the_slurm_array_job_fails_with_the_program(self):
        shutil.copy(EXAMPLES / "slurm-array.sh", self.folder)
        env = {"SLURM_ARRAY_TASK_ID": "1", "SLURM_ARRAY_TASK_COUNT": "2"}
        self.assertEqual(self.shell("bash slurm-array.sh none.csv; echo $?", env), "4\n")
        self.assertEqual([name for name in self.names() if "piece" in name], [])


main()
