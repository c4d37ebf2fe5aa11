#!/usr/bin/env python3
# SPDX-License-Identifier: BSL-1.0
"""Checks all proofs, and prints the theorems and the axioms that they depend on.

usage: check_proofs.py PROOFS BUILD [--each]

With --each, it prints the axioms of each theorem separately, instead of all axioms together. Then Coq's separate
checker also checks all compiled files again. This takes two minutes more.

The check fails if a proof fails or is omitted (Admitted). It also fails if properties/proofs/theorems.txt lacks a
theorem of the sources, lists something that is no theorem, or lacks an axiom that a theorem depends on.
"""

import pathlib
import re
import sys

import coq

LEFT_OUT = re.compile(r"\b(Admitted|Admit|admit|Axioms?|Parameters?|Conjectures?|bypass_check|Unset\s+\w+\s+Checking)\b"
                      r"|^(?:Variables?|Hypothes[ie]s|Context)\b", re.MULTILINE)  # allowed if indented in a section
STATED = re.compile(r"\b(?:Theorem|Corollary)\s+([\w']+)")


def listed(path):
    """The axioms, and the theorems as (file, name)."""
    axioms, theorems = [], []
    for line in path.read_text().splitlines():
        words = line.split("#")[0].split()
        if not words:
            continue
        if words[0] == "axiom":
            axioms.append(words[1])
        else:
            theorems.append((words[0], words[1]))
    return axioms, theorems


def without_comments(text):
    while True:
        shorter = re.sub(r"\(\*(?:(?!\(\*|\*\)).)*\*\)", "", text, flags=re.DOTALL)
        if shorter == text:
            return text
        text = shorter


def main(proofs, build, each):
    proofs, build = pathlib.Path(proofs), pathlib.Path(build)
    faults = []
    stated = []
    for name, text in coq.sources(proofs).items():
        text = without_comments(text)
        faults += [f"{name}.v: {found[0]}" for found in LEFT_OUT.finditer(text)]
        stated += [(name, theorem) for theorem in STATED.findall(text)]
    axioms, theorems = listed(proofs / "theorems.txt")
    faults += [f"theorems.txt: {name} of {file}.v is not listed" for file, name in stated if (file, name) not in theorems]
    faults += [f"theorems.txt: there is no theorem {name} in {file}.v" for file, name in theorems if (file, name) not in stated]
    status, said = coq.compiled(coq.copied(proofs, build))
    if status != 0:
        print(said[-4000:])
        faults.append("a proof fails")
    if not faults:
        used = set()
        groups = [[theorem] for theorem in theorems] if each else [theorems]
        for group, of_group in zip(groups, coq.assumptions(build, groups)):
            used.update(of_group)
            names = ", ".join(f"{file}.v: {name}" for file, name in group)
            if each:
                print(f"{names}: {', '.join(of_group) or 'no axiom'}")
            faults += [f"{names if each else 'a theorem'} rests on {axiom}, which is not listed" for axiom in of_group if axiom not in axioms]
        faults += [f"theorems.txt: nothing rests on {axiom}" for axiom in axioms if axiom not in used]
        if each and not faults:
            found, granted = coq.rechecked(build)
            faults += granted + [f"coqchk finds the axiom {axiom}, which is not listed" for axiom in found if axiom not in axioms]
            print(f"coqchk: {', '.join(found)}")
        print(f"{len(theorems)} theorems, checked; axioms: {', '.join(sorted(used))}")
    for fault in faults:
        print(fault)
    return 1 if faults else 0


if __name__ == "__main__":
    each = "--each" in sys.argv
    places = [argument for argument in sys.argv[1:] if argument != "--each"]
    if len(places) != 2:
        sys.exit(__doc__)
    sys.exit(main(*places, each))
