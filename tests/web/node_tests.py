# SPDX-License-Identifier: BSL-1.0
"""Runs node's tests of a folder: node_tests.py FOLDER NEEDED. The exit status is 77 if the file NEEDED is missing."""
import pathlib
import subprocess
import sys

folder, needed = map(pathlib.Path, sys.argv[1:])
if not needed.exists():
    print(f"{needed} does not exist: bash src/bootstrap.sh wasm")
    sys.exit(77)
tests = sorted(map(str, folder.glob("*.test.mjs")))
assert tests, f"{folder} has no tests"
# The judge runs for seconds here, so that optimising its code takes longer than it saves.
sys.exit(subprocess.run(["node", "--liftoff-only", "--test", *tests]).returncode)
