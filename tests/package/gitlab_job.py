# SPDX-License-Identifier: BSL-1.0
"""Runs a job of GitLab in a bare Debian, with unchanged lines, a cache and artefacts."""

import re
import shutil

FOLDER = "/builds/project"
KNOWN = {"image", "cache", "script", "artifacts"}


class Job:
    """One run. `store` keeps the cache and the artefacts."""

    def __init__(self, job, debian, project, store, variables):
        if set(job) - KNOWN or job["image"] != "debian:12":
            raise ValueError(f"a job of debian:12 with {', '.join(sorted(KNOWN))} can be played, and no other")
        self.job = job
        self.debian = debian
        self.variables = variables
        self.folder = debian.root / FOLDER.lstrip("/")
        self.store = store
        shutil.copytree(project, self.folder)
        key = re.sub(r"\$(\w+)", lambda found: variables[found[1]], job["cache"]["key"])
        self.cache = store / "cache" / key

    def play(self, log):
        (cached,) = self.job["cache"]["paths"]
        if self.cache.exists():
            shutil.copytree(self.cache, self.folder / cached)
        script = "set -eo pipefail\n" + "\n".join(self.job["script"]) + "\n"
        (self.folder.parent / "script").write_text(script, encoding="utf-8")
        ended_well = self.debian.run(["bash", "/builds/script"], self.variables | {"CI": "true"}, FOLDER, log) == 0
        if (ended_well or self.job["cache"].get("when") == "always") and not self.cache.exists():
            shutil.copytree(self.folder / cached, self.cache)
        if ended_well or self.job["artifacts"].get("when") == "always":
            self.keep_artefacts()
        return ended_well

    def keep_artefacts(self):
        for path in [*self.job["artifacts"]["paths"], *self.job["artifacts"]["reports"].values()]:
            source = self.folder / path
            if not source.exists():
                raise ValueError(f"the artefact {path} is not there")
            target = self.store / "artefacts" / path
            if source.is_dir():
                shutil.rmtree(target, ignore_errors=True)
                shutil.copytree(source, target)
