# SPDX-License-Identifier: BSL-1.0
"""ci_test.py SOURCE WORK [NAME…]: runs the scripts of docs/guide/ci.md unchanged in a bare Debian, with the last
commit of Carom. Each job runs twice. The first run tests a solver with a defect: the job must fail and leave a
report. The second run tests a sound solver, and must build nothing. NAME is one of action, github, gitlab, script,
container; without NAME, all jobs run. The exit status is 77 if this machine cannot make a bare Debian.
"""

import os
import pathlib
import re
import shutil
import subprocess
import sys
import time

import yaml

import containerfile
import github_steps
import gitlab_job
from bare_debian import SKIPPED, BareDebian, Unavailable

COMPILED = "Building CXX object"
PAGE = "docs/guide/ci.md"


class Failure(Exception):
    """The test's result is not as expected."""


def blocks_of(page, language):
    return re.findall(rf"^```{language}\n(.*?)^```$", page, re.MULTILINE | re.DOTALL)


class Playground:
    """The folders that the runs share: Carom's repository, and a user's project with a sound and a defective solver.
    """

    def __init__(self, source, work):
        self.source = source
        self.work = work
        self.base = work.parent / "base"
        shutil.rmtree(work, ignore_errors=True)
        work.mkdir(parents=True)
        # The tree may belong to another user than root.
        (work / "gitconfig").write_text("[safe]\n\tdirectory = *\n", encoding="utf-8")
        os.environ["GIT_CONFIG_GLOBAL"] = str(work / "gitconfig")
        self.revision = subprocess.run(["git", "-C", str(source), "rev-parse", "HEAD"], check=True, capture_output=True,
                                       text=True).stdout.strip()
        subprocess.run(["git", "clone", "--quiet", "--bare", str(source), str(work / "origin/carom.git")], check=True)
        (work / "archives").mkdir()
        self.tree("carom")
        example = (source / "docs/examples/solver.py").read_text(encoding="utf-8")
        sign = "-(1 + "
        if example.count(sign) != 1:
            raise Failure(f"docs/examples/solver.py has no single '{sign}' to plant a defect in")
        for name, text in (("sound", example), ("defective", example.replace(sign, "-(1.001 + "))):
            (work / name).mkdir()
            solver = work / name / "my-solver"
            solver.write_text(text, encoding="utf-8")
            solver.chmod(0o755)
        self.page = (source / PAGE).read_text(encoding="utf-8")
        self.variables = {"CAROM_URL": "file:///origin/carom.git", "CAROM_REVISION": self.revision}

    def tree(self, name):
        """Carom's tree without its history."""
        subprocess.run(["git", "clone", "--quiet", "--depth", "1", f"file://{self.work}/origin/carom.git", str(self.work / name)],
                       check=True)
        return self.work / name

    def debian(self, name):
        debian = BareDebian(self.base, self.work / "roots" / name)
        debian.binds["/origin"] = self.work / "origin"
        # All systems share the downloaded packages.
        debian.binds["/var/cache/apt/archives"] = self.work / "archives"
        return debian

    def yaml_block(self, is_wanted):
        (found,) = [block for block in blocks_of(self.page, "yaml") if is_wanted(block)]
        return found


class Run:
    def __init__(self, playground, name, play):
        self.log = playground.work / f"{name}.log"
        began = time.monotonic()
        with open(self.log, "wb") as log:
            self.ended_well = play(log)
        self.text = self.log.read_text(encoding="utf-8", errors="replace")
        self.compiled = self.text.count(COMPILED)
        print(f"{time.monotonic() - began:7.1f} s  {name}: {'passed' if self.ended_well else 'failed'}, "
              f"{self.compiled} files compiled", flush=True)

    def expect(self, is_so, what):
        if not is_so:
            raise Failure(f"{what}; {self.log} ends in\n{self.text[-3000:]}")


def judge_twice(playground, name, play, keeps):
    """Judges a defective and then a sound solver. `play` runs the job and writes a log. `keeps` checks the artefacts.
    """
    first = Run(playground, f"{name}-1", lambda log: play(playground.work / "defective", log))
    first.expect(not first.ended_well, "a solver with a defect passed")
    first.expect(first.compiled > 0, "the first run built nothing")
    first.expect("violates" in first.text, "the first run says nothing of a violation")
    keeps(first, "violated")
    second = Run(playground, f"{name}-2", lambda log: play(playground.work / "sound", log))
    second.expect(second.ended_well, "a sound solver failed")
    second.expect(second.compiled == 0, "the second run built something")
    keeps(second, "sound")


def expect_report(run, folder, verdict):
    for file in ("report.html", "report.json", "junit.xml"):
        run.expect((folder / file).exists(), f"the artefact has no {file}")
    run.expect(f'"status": "{verdict}"' in (folder / "report.json").read_text(encoding="utf-8"), f"the report is not {verdict}")


def play_steps(playground, name, steps, report, environment):
    """Runs the scripts of a job for GitHub. The second run gets a copy of the cached folder of the first run.
    """
    package = github_steps.cached_folder(steps)
    kept = playground.work / name / "package"
    debian = None

    def play(project, log):
        nonlocal debian
        debian = playground.debian(name)
        debian.binds["/carom"] = playground.work / "carom"
        folder = debian.root / "home/project"
        shutil.copytree(project, folder)
        (debian.root / "home/summary").touch()
        has_package = kept.exists()
        if has_package:
            shutil.copytree(kept, folder / package)
        ended_well = all(debian.run(command, environment, "/home/project", log) == 0
                         for command in github_steps.commands_of(steps, has_package))
        if not has_package and (folder / package).exists():
            shutil.copytree(folder / package, kept)
        return ended_well

    def keeps(run, verdict):
        expect_report(run, debian.root / "home/project" / report, verdict)
        summary = (debian.root / "home/summary").read_text(encoding="utf-8")
        run.expect(verdict in summary, "the job's summary does not say the verdict")
        kinds = {kind for kind, _ in github_steps.annotations_in(run.text)}
        run.expect("notice" in kinds, "there is no notice with the verdict")
        run.expect(("error" in kinds) == (verdict == "violated"), "errors are not as the verdict")
        debian.remove()

    judge_twice(playground, name, play, keeps)


def workflow_steps(playground, has_action):
    """The steps of the workflow that uses Carom's action, or else of the workflow without the action."""
    block = playground.yaml_block(lambda text: "jobs:" in text and (github_steps.ACTION in text) == has_action)
    (job,) = github_steps.read_yaml(block)["jobs"].values()
    return job["steps"]


def play_action(playground):
    action = github_steps.read_yaml((playground.source / github_steps.ACTION / "action.yml").read_text(encoding="utf-8"))
    steps = workflow_steps(playground, True)
    (use,) = [step for step in steps if github_steps.is_action(step)]
    at = steps.index(use)
    inputs = {name: declared["default"] for name, declared in action["inputs"].items()} | use["with"]
    environment = {f"CAROM_{name.upper()}": str(value) for name, value in inputs.items()}
    environment |= {"GITHUB_ACTION_PATH": f"/carom/{github_steps.ACTION}", "GITHUB_OUTPUT": "/home/output",
                    "GITHUB_STEP_SUMMARY": "/home/summary"}
    play_steps(playground, "action", steps[:at] + action["runs"]["steps"] + steps[at + 1:], inputs["out"], environment)


def play_workflow(playground):
    environment = playground.variables | {"GITHUB_STEP_SUMMARY": "/home/summary"}
    play_steps(playground, "github", workflow_steps(playground, False), "report", environment)


def play_gitlab(playground):
    (job,) = yaml.safe_load(playground.yaml_block(lambda block: "jobs:" not in block)).values()
    store = playground.work / "gitlab"

    def play(project, log):
        debian = playground.debian("gitlab")
        ended_well = gitlab_job.Job(job, debian, project, store, playground.variables).play(log)
        debian.remove()
        return ended_well

    judge_twice(playground, "gitlab", play, lambda run, verdict: expect_report(run, store / "artefacts/report", verdict))


def play_script(playground):
    """Runs on a persistent machine, where the second run finds the files of the first."""
    (script,) = blocks_of(playground.page, "sh")
    debian = playground.debian("script")
    debian.binds["/carom"] = playground.tree("carom-of-the-script")
    for command in ("apt-get update -qq", "apt-get install -y -qq python3 >/dev/null"):
        if debian.run(["sh", "-c", command]) != 0:
            raise Failure(f"{command}: failed")
    folder = debian.root / "home/project"

    def play(project, log):
        shutil.rmtree(folder, ignore_errors=True)
        shutil.copytree(project, folder)
        (folder / "judge.sh").write_text(script, encoding="utf-8")
        return debian.run(["sh", "judge.sh", "exec:./my-solver"], {"CAROM": "/carom"}, "/home/project", log) == 0

    judge_twice(playground, "script", play, lambda run, verdict: expect_report(run, folder / "report", verdict))
    debian.remove()


def play_container(playground):
    """Builds an image once and runs it twice."""
    text = (playground.source / "docs/examples/Containerfile").read_text(encoding="utf-8")
    image = None
    entry_point = None

    def play(project, log):
        nonlocal image, entry_point
        if image is None:
            stage = containerfile.build(text, playground.work / "carom", lambda name: playground.debian(f"container-{name}"), log)
            image, entry_point = stage.debian, stage.entry_point
            # The example needs python3. A user's image would install it, too.
            image.run(["sh", "-c", "apt-get update -qq && apt-get install -y -qq --no-install-recommends python3"], log=log)
        image.binds["/work"] = project
        shutil.rmtree(project / "report", ignore_errors=True)
        return image.run([*entry_point, "gate", "exec:./my-solver", "--out", "report"], folder="/work", log=log) == 0

    def keeps(run, verdict):
        expect_report(run, playground.work / ("sound" if verdict == "sound" else "defective") / "report", verdict)

    judge_twice(playground, "container", play, keeps)
    image.remove()


PLAYS = {"action": play_action, "github": play_workflow, "gitlab": play_gitlab, "script": play_script,
         "container": play_container}


def main(source, work, names):
    unknown = set(names) - set(PLAYS)
    if unknown:
        print(f"ci_test: there is no {', '.join(sorted(unknown))}; there are {', '.join(PLAYS)}", file=sys.stderr)
        return 2
    try:
        playground = Playground(source, work)
        for name in names or PLAYS:
            PLAYS[name](playground)
            shutil.rmtree(work / "roots", ignore_errors=True)
    except Unavailable as why:
        print(f"ci_test: skipped: {why}", file=sys.stderr)
        return SKIPPED
    except (Failure, ValueError) as failure:
        print(f"ci_test: {failure}", file=sys.stderr)
        return 1
    print("ci_test: each of these does what it should, and the second time builds nothing")
    return 0


if __name__ == "__main__":
    if len(sys.argv) < 3:
        sys.exit(__doc__)
    sys.exit(main(pathlib.Path(sys.argv[1]).resolve(), pathlib.Path(sys.argv[2]).resolve(), sys.argv[3:]))
