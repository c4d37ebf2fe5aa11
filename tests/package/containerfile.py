# SPDX-License-Identifier: BSL-1.0
"""Builds a Containerfile without a container daemon. Each stage is a separate bare Debian."""

import glob
import json
import pathlib
import re
import shutil

IMAGES = ("debian:12", "debian:12-slim")


class Stage:
    def __init__(self, debian):
        self.debian = debian
        self.folder = "/"
        self.entry_point = None

    def outside(self, path):
        return self.debian.root / str(pathlib.PurePosixPath(self.folder, path)).lstrip("/")

    def copy(self, sources, target):
        """COPY, which copies the content of a folder."""
        into = self.outside(target)
        for source in sources:
            if source.is_dir():
                shutil.copytree(source, into, dirs_exist_ok=True, symlinks=True)
            else:
                into.mkdir(parents=True, exist_ok=True)
                shutil.copy2(source, into)


def instructions_of(text):
    lines = re.sub(r"\\\n", " ", text).splitlines()
    for line in lines:
        if line.strip() and not line.startswith("#"):
            yield line.split(maxsplit=1)


def build(text, context, new_debian, log):
    """Returns the last stage. `new_debian` makes a bare Debian with a given name."""
    stages = {}
    stage = None
    for word, rest in instructions_of(text):
        log.write(f"\n=== {word} {rest}\n".encode())
        log.flush()
        if word == "FROM":
            image, *name = rest.split(" AS ")
            if image not in IMAGES:
                raise ValueError(f"FROM {image}: not one of {', '.join(IMAGES)}")
            stage = Stage(new_debian(name[0] if name else "last"))
            stages[name[0] if name else "last"] = stage
        elif word == "WORKDIR":
            stage.folder = rest
            stage.outside(".").mkdir(parents=True, exist_ok=True)
        elif word == "COPY":
            *sources, target = rest.split()
            root = context
            if sources[0].startswith("--from="):
                root = stages[sources.pop(0).removeprefix("--from=")].debian.root
            found = [pathlib.Path(path) for source in sources for path in glob.glob(str(root / source.lstrip("/")))]
            if len(found) < len(sources):
                raise ValueError(f"COPY {rest}: something is not there")
            stage.copy(found, target)
        elif word == "RUN":
            if stage.debian.run(["/bin/sh", "-c", rest], folder=stage.folder, log=log) != 0:
                raise ValueError(f"RUN {rest}: failed")
        elif word == "ENTRYPOINT":
            stage.entry_point = json.loads(rest)
        else:
            raise ValueError(f"{word}: not known here")
    return stage
