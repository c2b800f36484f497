#!/usr/bin/env python3
"""The program in pipelines: GNU parallel, xargs, a Slurm array job."""
import os
import shutil
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
        self.assertEqual(self.shell("cat runs.piece-*.csv"), self.whole)

    def test_the_slurm_array_job_fails_with_the_program(self):
        shutil.copy(EXAMPLES / "slurm-array.sh", self.folder)
        env = {"SLURM_ARRAY_TASK_ID": "1", "SLURM_ARRAY_TASK_COUNT": "2"}
        self.assertEqual(self.shell("bash slurm-array.sh none.csv; echo $?", env), "4\n")
        self.assertEqual([name for name in self.names() if "piece" in name], [])


main()
