#!/usr/bin/env python3
# SPDX-License-Identifier: BSL-1.0
"""Builds the oracle whose specification is proved: BUILD/proved.

usage: build_bridge.py PROOFS BUILD
"""

import pathlib
import shutil
import subprocess
import sys

import coq


def main(proofs, build):
    proofs, build = pathlib.Path(proofs), coq.copied(pathlib.Path(proofs), pathlib.Path(build))
    status, said = coq.compiled(build, ["extraction.vo"])
    if status != 0:
        print(said[-4000:])
        return 1
    parts = ["json_collision.ml", "proved.ml"]
    for part in parts:
        shutil.copyfile(proofs / "bridge" / part, build / part)
    command = ["ocamlfind", "ocamlopt", "-package", "zarith,yojson", "-linkpkg", "answers.mli", "answers.ml", *parts]
    return subprocess.run([*command, "-o", "proved"], cwd=build).returncode


if __name__ == "__main__":
    if len(sys.argv) != 3:
        sys.exit(__doc__)
    sys.exit(main(sys.argv[1], sys.argv[2]))
