# SPDX-License-Identifier: BSL-1.0
"""batch_systems_test.py CAROM NAME: runs the scripts of docs/guide/scale.md with few cases. NAME is page (parses every
file), openmpi (two ranks) or slurm (a local Slurm; one task is requeued). The merged report must be that of a run
without shards. The exit status is 77 if this machine lacks the batch system.
"""

import json
import os
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile
import time

import yaml

import github_steps
import local_slurm
from bare_debian import SKIPPED
from ci_test import blocks_of

PAGE = (pathlib.Path(__file__).resolve().parents[2] / "docs/guide/scale.md").read_text(encoding="utf-8")
COMMAND = "carom gate 'exec:./my-solver' --cases 1700000 "
SUBJECT = "reflection-in-basis-double"
PATIENCE = 300  # seconds until a job must end


def expect(condition, what):
    if not condition:
        sys.exit(f"batch_systems_test: {what}")


def shell_blocks():
    script, job = blocks_of(PAGE, "sh")
    expect(script.count(COMMAND) == 1, f"the script of the page has no command {COMMAND}")
    return script, job


class Run:
    """A folder with shard.sh, and a `carom` in the PATH."""

    def __init__(self, carom, work, arguments):
        self.carom = str(carom)
        self.work = pathlib.Path(work)
        self.arguments = [SUBJECT, *arguments]
        (self.work / "bin").mkdir()
        (self.work / "bin/carom").symlink_to(self.carom)
        self.path = f"{self.work / 'bin'}{os.pathsep}{local_slurm.search_path()}"
        script = shell_blocks()[0].replace(COMMAND, f"carom gate {' '.join(self.arguments)} ")
        (self.work / "shard.sh").write_text(script, encoding="utf-8")

    def gate(self, *more):
        return subprocess.run([self.carom, "gate", *self.arguments, *more], cwd=self.work, capture_output=True, text=True,
                              check=False)

    def expect_whole_report(self, shards):
        """Merges the shards as the page does, and compares the report with that of a run without shards."""
        folders = sorted(path.name for path in (self.work / "shards").iterdir())
        expect(folders == [f"shard-{i}-of-{shards}" for i in range(1, shards + 1)], f"the shards are {folders}")
        (merge,) = re.findall(r"^    (carom merge .*)$", PAGE, re.MULTILINE)
        merged = subprocess.run(["sh", "-c", merge], cwd=self.work, env={**os.environ, "PATH": self.path},
                                capture_output=True, text=True, check=False)
        expect(merged.returncode == 1, f"merge ends with {merged.returncode}: {merged.stderr}")
        expect(self.gate("--out", "whole").returncode == 1, "the run without shards finds no violation")
        expect(self.report("report") == self.report("whole"), "the merged report is not that of the run without shards")

    def report(self, folder):
        report = json.loads((self.work / folder / "report.json").read_text(encoding="utf-8"))
        del report["environment"]["date"]
        for subject in report["subjects"]:
            del subject["nanoseconds_per_solve"]
            for violation in subject["violations"]:  # each shard chooses its own witnesses
                del violation["case"], violation["family"]
        return report


def test_page(_):
    """Each file has the variables that `--shard auto` reads."""
    script, job = shell_blocks()
    for option in ("--shard auto", "--out shards"):
        expect(option in script, f"shard.sh has no {option}")
    expect(re.search(r"^#SBATCH .*--array=1-10 .*--ntasks=10 ", job, re.MULTILINE), "the job of Slurm has no array")
    kubernetes, github, gitlab = [github_steps.read_yaml(block) for block in blocks_of(PAGE, "yaml")]
    job = kubernetes["spec"]
    (container,) = job["template"]["spec"]["containers"]
    expect(job["completionMode"] == "Indexed", "the job of Kubernetes is not indexed")
    expect(container["env"] == [{"name": "JOB_COMPLETIONS", "value": str(job["completions"])}],
           "JOB_COMPLETIONS is not the number of completions")
    job = github["jobs"]["shard"]
    expect(job["env"] == {"STRATEGY_JOB_INDEX": "${{ strategy.job-index }}", "STRATEGY_JOB_TOTAL": "${{ strategy.job-total }}"},
           "the job of GitHub does not set its variables")
    matrix = job["strategy"]["matrix"]
    jobs = 1
    for values in matrix.values():
        jobs *= len(set(values))
    expect(jobs == job_count(kubernetes, gitlab) == 100, "the jobs are not 100")
    commands = [*container["command"], *[step.get("run") for step in job["steps"]], gitlab["shard"]["script"]]
    expect(commands.count("sh shard.sh") == 2 and "shard.sh" in commands, "a job does not run shard.sh")


def job_count(kubernetes, gitlab):
    expect(kubernetes["spec"]["completions"] == gitlab["shard"]["parallel"], "the jobs differ in number")
    return gitlab["shard"]["parallel"]


def test_openmpi(carom):
    if shutil.which("mpirun") is None:
        return "there is no mpirun"
    (command,) = re.findall(r"^    (mpirun .*)$", PAGE, re.MULTILINE)
    expect(command == "mpirun -np 100 --hostfile hosts sh shard.sh", f"the page has another command: {command}")
    with tempfile.TemporaryDirectory() as work:
        run = Run(carom, work, ["--families", "head_on,structured", "--cases", "60"])
        (run.work / "hosts").write_text("localhost slots=2\n", encoding="utf-8")
        # mpirun refuses to run as root without these variables.
        environment = {**os.environ, "PATH": run.path, "OMPI_ALLOW_RUN_AS_ROOT": "1", "OMPI_ALLOW_RUN_AS_ROOT_CONFIRM": "1"}
        ended = subprocess.run(command.replace("100", "2").split(), cwd=work, env=environment, capture_output=True,
                               text=True, timeout=PATIENCE, check=False)
        expect(ended.returncode == 0, f"mpirun ends with {ended.returncode}:\n{ended.stdout}{ended.stderr}")
        run.expect_whole_report(2)
    return None


def test_slurm(carom):
    missing = local_slurm.missing_programs()
    if missing:
        return f"there is no {', '.join(missing)}"
    job = shell_blocks()[1].replace("--array=1-10 --ntasks=10 ", "--array=1-2 --ntasks=2 ")
    with tempfile.TemporaryDirectory() as work, local_slurm.LocalSlurm(pathlib.Path(work) / "slurm") as slurm:
        run = Run(carom, work, ["--families", "elastic", "--cases", "32000"])
        slurm.environment["PATH"] = run.path
        (run.work / "job.sh").write_text(job, encoding="utf-8")
        number = slurm.run("sbatch", "--parsable", "job.sh", cwd=work).stdout.strip()
        expect(number.isdigit(), f"sbatch gives no number of a job:\n{slurm.logs()}")
        shards = run.work / "shards"
        wait_until((shards / "shard-1-of-4/.carom-lock").exists, slurm)
        requeued = slurm.run("scontrol", "requeue", f"{number}_1")
        expect(requeued.returncode == 0, f"scontrol requeue: {requeued.stderr}")
        # Slurm would wait for two minutes.
        wait_until(lambda: "PENDING" in slurm.run("squeue", "--noheader", f"--jobs={number}_1", "--format=%T").stdout, slurm)
        slurm.run("scontrol", "update", f"JobId={number}_1", "StartTime=now")
        wait_until(lambda: not slurm.run("squeue", "--noheader").stdout.strip(), slurm)
        run.expect_whole_report(4)
    return None


def wait_until(condition, slurm):
    end = time.monotonic() + PATIENCE
    while not condition():
        expect(time.monotonic() < end, f"a job takes too long:\n{slurm.run('squeue').stdout}{slurm.logs()}")
        time.sleep(0.1)


TESTS = {"page": test_page, "openmpi": test_openmpi, "slurm": test_slurm}


def main(carom, name):
    why = TESTS[name](pathlib.Path(carom).resolve())
    if why:
        print(f"batch_systems_test: skipped: {why}", file=sys.stderr)
        return SKIPPED
    return 0


if __name__ == "__main__":
    if len(sys.argv) != 3 or sys.argv[2] not in TESTS:
        sys.exit(__doc__)
    sys.exit(main(sys.argv[1], sys.argv[2]))
