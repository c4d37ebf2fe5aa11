# SPDX-License-Identifier: BSL-1.0
"""The shell scripts of a job for GitHub, and the annotations in their output. This file evaluates no GitHub
expression: ci_parts_test.py requires that scripts contain none, and that each condition is CACHE_MISS or ALWAYS.
"""

import re

import yaml

ACTION = ".github/actions/carom"
CACHE_MISS = "steps.cache.outputs.cache-hit != 'true'"
ALWAYS = "always()"


def read_yaml(text):
    """Restores the key `on` of workflows, which YAML 1.1 reads as true."""
    document = yaml.safe_load(text)
    if True in document:
        document["on"] = document.pop(True)
    return document


def is_action(step):
    return step.get("uses", "").split("@")[0].endswith(ACTION)


def cached_folder(steps):
    """The folder that the job keeps from run to run."""
    (save,) = [step for step in steps if step.get("uses", "").startswith("actions/cache/save@")]
    return save["with"]["path"]


def commands_of(steps, has_package):
    """The commands of the scripts, in order. If the package exists, steps for a cache miss are left out."""
    shells = {None: ["sh", "-e"], "bash": ["bash", "--noprofile", "--norc", "-eo", "pipefail"]}
    return [[*shells[step.get("shell")], "-c", step["run"]] for step in steps
            if "run" in step and not (has_package and step.get("if") == CACHE_MISS)]


def annotations_in(text):
    """The errors and notices that GitHub would show for this output."""
    found, token = [], None
    for line in text.splitlines():
        command = re.match(r"\s*::([\w-]+)(?: ([^:]*))?::(.*)$", line)
        if token:
            token = None if line.strip() == f"::{token}::" else token
        elif command and command[1] == "stop-commands":
            token = command[3]
        elif command:
            found.append((command[1], command[3]))
    return found
