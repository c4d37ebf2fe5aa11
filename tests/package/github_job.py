# SPDX-License-Identifier: BSL-1.0
"""Plays a job of a GitHub workflow in a bare Debian. What `run` says is run as it stands; checkout, cache, upload-artifact
and Carom's own action are played here, any other action is an error."""

import pathlib
import re
import shutil

import yaml

from github_expressions import filled_in, is_to_run

WORKSPACE = "/__w/project"
ACTION = ".github/actions/carom"
TREE = "/__w/_actions/carom"
FILES = "/__w/_temp"


def read_yaml(text):
    """YAML 1.1 takes `on` for true; workflows do not."""
    document = yaml.safe_load(text)
    if True in document:
        document["on"] = document.pop(True)
    return document


class Job:
    """One run of the one job that a workflow has. `store` outlives it: what was cached, and what was kept as artefact."""

    def __init__(self, workflow, debian, project, tree, store, variables):
        if not workflow.get("on"):
            raise ValueError("the workflow has no `on`")
        (self.job,) = workflow["jobs"].values()
        if self.job["container"] != "debian:12":
            raise ValueError("the job is not in debian:12")
        self.debian = debian
        self.store = store
        self.root = debian.root
        self.contexts = {"vars": variables, "env": {}, "steps": {}, "runner": {"os": "Linux"}}
        self.contexts["env"] = {name: filled_in(text, self.contexts) for name, text in workflow.get("env", {}).items()}
        self.project = project
        self.tree = tree
        debian.binds[TREE] = tree
        for folder in (WORKSPACE, FILES):
            (self.root / folder.lstrip("/")).mkdir(parents=True)
        self.summary = self.inside(FILES + "/summary")
        for name in ("summary", "output"):
            self.inside(f"{FILES}/{name}").touch()

    def inside(self, path):
        """A path of the bare system, as this machine sees it."""
        return self.root / path.lstrip("/")

    def play(self, log):
        """Whether all steps ended well."""
        return not self.play_steps(self.job["steps"], self.contexts, log, False, None)

    def play_steps(self, steps, contexts, log, failed, shell):
        for step in steps:
            if not is_to_run(step.get("if", "success()"), contexts, failed):
                continue
            log.write(f"\n=== {step.get('uses') or step['run'].splitlines()[0]}\n".encode())
            log.flush()
            outputs, ended_well = self.play_step(step, contexts, log, shell)
            failed = failed or not ended_well
            if "id" in step:
                contexts["steps"][step["id"]] = {"outputs": outputs}
        return failed

    def play_step(self, step, contexts, log, shell):
        if "run" in step:
            return self.run(step, contexts, log, shell)
        given = {name: filled_in(text, contexts) for name, text in step.get("with", {}).items()}
        action = re.sub(r"@.*$", "", step["uses"])
        if action.endswith(ACTION):
            return {}, self.play_action(given, log)
        played = {"actions/checkout": self.checkout, "actions/cache/restore": self.restore, "actions/cache/save": self.save,
                  "actions/upload-artifact": self.upload}
        if action not in played:
            raise ValueError(f"no stand-in for {step['uses']}")
        return played[action](**given)

    def run(self, step, contexts, log, shell):
        """In a container it is sh that runs a step; those of an action say which shell does."""
        words = {"bash": ["bash", "--noprofile", "--norc", "-eo", "pipefail"], None: ["sh", "-e"]}[step.get("shell", shell)]
        self.inside(FILES + "/step").write_text(filled_in(step["run"], contexts), encoding="utf-8")
        self.inside(FILES + "/output").write_text("", encoding="utf-8")
        environment = {"CI": "true", "GITHUB_ACTIONS": "true", "GITHUB_WORKSPACE": WORKSPACE,
                       "GITHUB_OUTPUT": FILES + "/output", "GITHUB_STEP_SUMMARY": FILES + "/summary",
                       "GITHUB_ACTION_PATH": f"{TREE}/{ACTION}"}
        for source in (contexts["env"], step.get("env", {})):
            environment |= {name: filled_in(text, contexts) for name, text in source.items()}
        status = self.debian.run([*words, FILES + "/step"], environment, WORKSPACE, log)
        lines = self.inside(FILES + "/output").read_text(encoding="utf-8").splitlines()
        return dict(line.split("=", 1) for line in lines if line), status == 0

    def play_action(self, given, log):
        action = read_yaml((self.tree / ACTION / "action.yml").read_text(encoding="utf-8"))
        unknown = set(given) - set(action["inputs"])
        if unknown:
            raise ValueError(f"the action has no input {', '.join(sorted(unknown))}")
        inputs = {name: given.get(name, declared.get("default", "")) for name, declared in action["inputs"].items()}
        contexts = {"inputs": inputs, "env": {}, "steps": {}, "runner": self.contexts["runner"]}
        if any("run" in step and "shell" not in step for step in action["runs"]["steps"]):
            raise ValueError("a step of an action that runs something names its shell")
        return not self.play_steps(action["runs"]["steps"], contexts, log, False, None)

    def checkout(self):
        shutil.copytree(self.project, self.inside(WORKSPACE), dirs_exist_ok=True)
        return {}, True

    def kept(self, key):
        if not re.fullmatch(r"[\w.-]*[0-9a-f]{16}[\w.-]*", key):
            raise ValueError(f"the key '{key}' names no revision")
        return self.store / "cache" / key

    def restore(self, path, key):
        if not self.kept(key).exists():
            return {"cache-hit": ""}, True
        shutil.copytree(self.kept(key), self.inside(f"{WORKSPACE}/{path}"))
        return {"cache-hit": "true"}, True

    def save(self, path, key):
        shutil.copytree(self.inside(f"{WORKSPACE}/{path}"), self.kept(key))
        return {}, True

    def upload(self, name, path):
        """An artefact that is not there is an error here; GitHub would warn."""
        source = self.inside(f"{WORKSPACE}/{path}")
        target = self.store / "artefacts" / name
        shutil.rmtree(target, ignore_errors=True)
        if source.exists():
            shutil.copytree(source, target)
        return {}, source.exists()


def annotations_in(log):
    """The errors and notices that GitHub would show of a log."""
    found, token = [], None
    for line in pathlib.Path(log).read_text(encoding="utf-8", errors="replace").splitlines():
        command = re.match(r"\s*::([\w-]+)(?: ([^:]*))?::(.*)$", line)
        if token:
            token = None if line.strip() == f"::{token}::" else token
        elif command and command[1] == "stop-commands":
            token = command[3]
        elif command:
            found.append((command[1], command[3]))
    return found
