# SPDX-License-Identifier: BSL-1.0
"""Checks copies of the proofs, in a directory outside the sources."""

import os
import pathlib
import re
import shutil
import subprocess


def copied(proofs, build):
    """Copies the sources to `build`. Keeps compiled files whose source text did not change."""
    build.mkdir(parents=True, exist_ok=True)
    for source in sorted(proofs.glob("*.v")):
        target = build / source.name
        if not target.exists() or target.read_bytes() != source.read_bytes():
            shutil.copyfile(source, target)
    return build


def compiled(build, targets=(), jobs=None):
    """The exit status and the output of `make` for these .vo files, or for all files if there are none."""
    files = sorted(path.name for path in build.glob("*.v"))
    subprocess.run(["coq_makefile", "-Q", ".", "Carom", *files, "-o", "Makefile"], cwd=build, check=True,
                   stdout=subprocess.DEVNULL)
    jobs = jobs or os.cpu_count() or 1
    done = subprocess.run(["make", f"-j{jobs}", "--no-print-directory", *targets], cwd=build, capture_output=True,
                          text=True, timeout=1200)
    return done.returncode, done.stdout + done.stderr


def assumptions(build, groups):
    """The sorted axioms that each group of theorems depends on. A theorem is a pair (file, name). A group takes half a
    second.
    """
    lines = [f"Require Carom.{file}." for file in dict.fromkeys(file for group in groups for file, _ in group)]
    for number, group in enumerate(groups):
        all_of_them = ", ".join(f"@Carom.{file}.{name}" for file, name in group)
        lines += [f"Definition group_{number} := ({all_of_them}).",
                  f'Goal True. idtac "group {number}". Abort.', f"Print Assumptions group_{number}."]
    query = build / "query_of_assumptions.v"
    query.write_text("\n".join(lines) + "\n")
    try:
        said = subprocess.run(["coqc", "-Q", ".", "Carom", query.name], cwd=build, capture_output=True, text=True,
                              timeout=600)
    finally:
        for path in build.glob("*query_of_assumptions*"):
            path.unlink()
    if said.returncode != 0:
        raise RuntimeError(said.stderr)
    if unguarded := re.findall(r"^.* is assumed to be .*$", said.stdout, flags=re.MULTILINE):
        raise RuntimeError("\n".join(unguarded))
    found = {}
    for part in re.split(r"^group ", said.stdout, flags=re.MULTILINE)[1:]:
        number, _, rest = part.partition("\n")
        found[int(number)] = sorted(set(re.findall(r"^([\w.']+)\s*:", rest, flags=re.MULTILINE)) - {"Axioms"})
    return [[axiom.split(".")[-1] for axiom in found[number]] for number in range(len(groups))]


def rechecked(build):
    """The sorted axioms that Coq's separate checker finds in all compiled files, and its other assumptions. Takes a
    minute.
    """
    files = sorted(path.stem for path in build.glob("*.vo"))
    said = subprocess.run(["coqchk", "-silent", "-o", "-Q", ".", "Carom", *(f"Carom.{file}" for file in files)], cwd=build,
                          stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, timeout=1200)
    if said.returncode != 0:
        raise RuntimeError(said.stdout)
    found = {}
    for part in re.split(r"^\* ", said.stdout, flags=re.MULTILINE)[1:]:
        what, _, rest = part.partition(":")
        found[what] = [word for word in rest.split() if word != "<none>"]
    axioms = [axiom.split(".")[-1] for axiom in found.pop("Axioms")]
    if found.pop("Theory") != "Set is predicative".split():
        raise RuntimeError(said.stdout)
    return sorted(axioms), [f"{what}: {', '.join(names)}" for what, names in found.items() if names]


def sources(proofs):
    return {path.stem: path.read_text() for path in sorted(pathlib.Path(proofs).glob("*.v"))}
