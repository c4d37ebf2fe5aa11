#!/usr/bin/env python3
# SPDX-License-Identifier: BSL-1.0
"""pack.py FOLDER: prints each file of the folder as a line of corpora/TARGET.txt, the shortest first."""
import pathlib
import sys

inputs = sorted((path.read_bytes() for path in pathlib.Path(sys.argv[1]).iterdir()), key=lambda one: (len(one), one))
for one in inputs:
    print("".join(chr(byte) if 32 < byte < 127 and byte != ord("%") else f"%{byte:02X}" for byte in one))
