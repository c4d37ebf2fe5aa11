#!/usr/bin/env python3
# SPDX-License-Identifier: BSL-1.0
"""Adds a family, an invariant, a feature and a law in a copy of the sources, in the files that their pages name.

usage: adding_test.py SOURCE BUILD NINJA COMPILER WORK

A family, an invariant and a feature take one row each. The test compiles the row's file and links it with
listing.cpp, which must list the row. The law is only an enumerator: the compiler has to name the places that lack it,
and the page has to name their files.
"""
import pathlib
import re
import shlex
import shutil
import subprocess
import sys

SOURCE, BUILD, NINJA, COMPILER, WORK = *sys.argv[1:5], pathlib.Path(sys.argv[5])
TREE = WORK / "tree"
PAGES = pathlib.Path(SOURCE) / "docs/internals"

# (page, its words for the file, file, [(anchor, text to insert before the anchor)], other files to compile, the line
# that the program must print)
ROWS = [
    ("contributing.md", "row in `family.cpp`", "properties/families/family.cpp",
     [("constexpr std::array families{", "Case at_rest(Stream& stream) {\n  Case result = generic(stream);\n"
       "  result.collision.a.velocity.setZero();\n  return result;\n}\n\n"),
      ("    Family{\"invalid\",", "    Family{\"at_rest\", \"A does not move\", at_rest},\n")],
     [], "family at_rest"),
    ("adding-an-invariant.md", "`one_answer.cpp`", "properties/invariants/one_answer.cpp",
     [("std::vector<Invariant> answer_invariants() {",
       "Verdict check_nothing(const Collision&, const ExactAnswer&, Law) { return {}; }\n\n"),
      ("Invariant{\"invalid_refused\"", "Invariant{\"nothing\", \"Nothing is asked.\", \"\", \"\", \"\", every_law(),\n"
       "          AboutAnswer{true, check_nothing}},\n          ")],
     ["properties/invariants/invariant.cpp"], "invariant nothing"),
    ("contributing.md", "row in one of the files of `properties/features`", "properties/features/inertia.cpp",
     [("      {\"immovable\",", "      {\"mass_three\", special, \"the mass is 3\", \"no power of two\", true,\n"
       "       [](const Collision&, const Body& b) { return b.mass == 3; },\n"
       "       [](Stream&, Collision&, Body& b) { set_mass(b, 3); }},\n")],
     ["properties/features/feature.cpp"], "feature b.mass_three"),
]
LAW = ("src/collision/law.hpp", [("  any, ", "  slippery,\n"), ("Law::any};", "Law::slippery, "),
                                   ("    case Law::any:", "    case Law::slippery:\n      return \"slippery\";\n")])


def run(command, **options):
    return subprocess.run(command, cwd=BUILD, capture_output=True, text=True, **options)


def checked(command):
    result = run(command)
    if result.returncode != 0:
        sys.exit(f"{shlex.join(map(str, command))}\n{result.stdout}{result.stderr}")
    return result.stdout


def change(path, insertions):
    text = (TREE / path).read_text()
    for anchor, insertion in insertions:
        if text.count(anchor) != 1:
            sys.exit(f"{path} has {text.count(anchor)} times {anchor!r}")
        text = text.replace(anchor, insertion + anchor)
    (TREE / path).write_text(text)


def arguments(line):
    """The arguments of one call of the compiler. No other command runs here, because some commands of the build delete
    files.
    """
    words = shlex.split(line)
    if COMPILER not in words or any(word in ("&&", "||", ";", "|") for word in words):
        sys.exit(f"no call of {COMPILER} alone: {line}")
    return words[words.index(COMPILER) + 1:]


def commands_of_listing():
    """The commands that compile and link listing.cpp, with the include folders of the copy."""
    lines = checked([NINJA, "-t", "commands", "house_listing"]).strip().splitlines()
    compile_line, link_line = next(line for line in lines if line.endswith("listing.cpp")), lines[-1]
    flags, skip = [], False
    for word in arguments(compile_line):
        if skip or word in ("-MD", "-MT", "-MF", "-o", "-c"):
            skip = word in ("-MT", "-MF", "-o", "-c")
        elif found := re.fullmatch(r"-I(.*)/include/(\w+)", word):
            spelt = pathlib.Path(word[2:]) / "carom" / found[2]
            copy = TREE / spelt.resolve().relative_to(pathlib.Path(SOURCE).resolve())
            folder = WORK / "include" / found[2] / "carom"
            folder.mkdir(parents=True, exist_ok=True)
            (folder / found[2]).symlink_to(copy)
            flags.append(f"-I{folder.parent}")
        else:
            flags.append(word)
    return [COMPILER, *flags, "-O0"], [COMPILER, *arguments(re.sub(r"^: && | && :$", "", link_line))]


def adds_rows(compiler, link):
    objects = []
    for page, name, path, insertions, listed_by, _ in ROWS:
        if name not in (PAGES / page).read_text():
            sys.exit(f"{page} does not say {name!r}")
        change(path, insertions)
        for one in [path, *listed_by]:
            objects.append(WORK / (pathlib.Path(one).name + ".o"))
            checked([*compiler, "-c", TREE / one, "-o", objects[-1]])
    own = next(i for i, word in enumerate(link) if word.endswith("listing.cpp.o"))
    program = WORK / "listing"
    output = link.index("-o")
    link = link[:own + 1] + list(map(str, objects)) + link[own + 1:]
    link[link.index("-o") + 1] = str(program)
    # The libraries contain the original rows. The linker takes the first definition, which is the changed one.
    checked([*link[:output], "-Wl,--allow-multiple-definition", *link[output:]])
    listed = checked([program]).splitlines()
    for *_, line in ROWS:
        if line not in listed:
            sys.exit(f"{line!r} is not listed")
    of_families = [line for line in listed if line.startswith("family ")]
    if of_families[-1] != ROWS[0][-1]:
        sys.exit("a family without a turn does not come last")


def names_what_a_law_leaves(compiler):
    change(*LAW)
    folders = [TREE / name for name in ("src", "oracles", "properties")]
    switching = {path for folder in folders for path in folder.rglob("*.?pp") if "case Law::any:" in path.read_text()}
    switching.discard(TREE / LAW[0])
    units = [path for path in switching if path.suffix == ".cpp"]
    for extra in ("oracles/judge/exact_case.cpp", "oracles/judge/accuracy.cpp"):  # they instantiate code of headers
        units.append(TREE / extra)
    headers = WORK / "headers.cpp"
    headers.write_text("".join(f'#include "{path}"\n' for path in switching if path.suffix == ".hpp"))
    units.append(headers)
    left = set()
    for unit in units:
        words = [word for word in compiler if word != "-Werror"]
        said = run([*words, "-Wswitch", "-S", unit, "-o", "/dev/null"]).stderr
        left |= {pathlib.Path(match[1]).resolve() for match in re.finditer(
            r"^(\S+?):\d+:\d+: (?:warning|error): enumeration value .slippery. not handled", said, re.M)}
    page = (PAGES / "adding-a-law.md").read_text()
    for path in sorted(switching):
        if path.resolve() not in left:
            sys.exit(f"the compiler does not say that {path} leaves the law out")
    for path in sorted(left):
        if f"{path.name}`" not in page:
            sys.exit(f"adding-a-law.md does not name {path.name}")


def main():
    if WORK.name != "adding":
        sys.exit("WORK is a folder of its own, which is emptied: …/adding")
    shutil.rmtree(WORK, ignore_errors=True)
    for folder in ("src", "oracles", "properties"):
        shutil.copytree(pathlib.Path(SOURCE) / folder, TREE / folder, ignore=shutil.ignore_patterns("node_modules"))
    compiler, link = commands_of_listing()
    adds_rows(compiler, link)
    names_what_a_law_leaves(compiler)


main()
