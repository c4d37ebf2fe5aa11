#!/usr/bin/env python3
# SPDX-License-Identifier: BSL-1.0
"""Changes one operator, sign, number, comparison or term of the judge at a time, and checks that a test fails.

docs/internals/mutation.md explains the method, and when the exit status is 1.
"""
import argparse
import collections
import concurrent.futures
import hashlib
import json
import os
import pathlib
import re
import subprocess
import sys
import time

ROOT = pathlib.Path(__file__).resolve().parents[2]
WORK = ROOT / "build-mutation"  # a copy of this tree, and its build
PAGE = "docs/internals/mutation.md"
MUTATED = [*(f"oracles/{one}" for one in ("laws", "exact", "judge", "bounds", "truths")), "properties/invariants"]
TESTS = [line.split() for line in (ROOT / "tests/mutation/tests.txt").read_text().splitlines() if line[0] != "#"]
LEAST_NOTICED, MOST_DROPPED = 0.92, 0.05
LIMITS = ["timeout", "1800", "prlimit", "--cpu=120", "--as=8589934592"]  # seconds, seconds of processor time, bytes
# INSTEAD: the replacements of each operator. CARRIER: the operator of the same precedence in the new form.
INSTEAD = {"+": ["-", "left", "right"], "-": ["+", "left"], "*": ["/"], "/": ["*"], "%": ["/"], "<": ["<=", ">="],
           "<=": ["<", ">"], ">": [">=", "<="], ">=": [">", "<"], "==": ["!="], "!=": ["=="], "&&": ["||"],
           "||": ["&&"], "+=": ["-=", "left"], "-=": ["+=", "left"], "*=": ["/="], "/=": ["*="]}
CARRIER = {**dict.fromkeys("+-", "+"), **dict.fromkeys("*/%", "%"), **dict.fromkeys(["==", "!="], "!="),
           **dict.fromkeys(["<", "<=", ">", ">="], "<"), **dict.fromkeys(["+=", "-=", "*=", "/="], "+=")}
TOKEN = re.compile(r"""(?P<skip>//[^\n]*|/\*.*?\*/|^[ \t]*\#(?:[^\n]*\\\n)*[^\n]*|\s+)
    |(?P<text>R"\(.*?\)"|"(?:\\.|[^"\\])*"|'(?:\\.|[^'\\])')
    |(?P<number>(?:0[xX][\da-fA-F.']+(?:[pP][+-]?\d+)?|\d[\d.']*(?:[eE][+-]?\d+)?)[uUlLfF]*)
    |(?P<word>[A-Za-z_]\w*)|(?P<sign><=>|->\*?|&&|\|\||\+\+|--|::|<<|[-+*/%<>=!&|^]=|\S)""", re.S | re.M | re.X)
Token = collections.namedtuple("Token", "kind text start end before after angle")  # angle: in or around template arguments
Place = collections.namedtuple("Place", "path i token instead lines name")  # one change of the token with index i


def tokens_of(text):
    """The tokens of a C++ text. `before`, `after`: whether a blank is there. Only binary operators have both blanks."""
    tokens, angles = [], 0
    for match in TOKEN.finditer(text):
        word, start, end, last = match.group(), match.start(), match.end(), tokens[-1].text if tokens else ""
        before, after = text[start - 1:start].isspace(), text[end:end + 1].isspace()
        opens = word == "<" and last != "operator" and (last == "template" or not before)
        if match.lastgroup != "skip":
            tokens.append(Token(match.lastgroup, word, start, end, before, after, opens or angles > 0))
            angles += opens - (word == ">" and angles > 0 and not before)
    return tokens


def regions(tokens):
    """Tokens evaluated only at compile time, tokens in constexpr functions, and tokens in constexpr variables."""
    def closing(i):  # the bracket that closes the one at i; i if there is none
        depth = int(tokens[i].text in "([{")
        while depth > 0:
            i += 1
            depth += (tokens[i].text in "([{") - (tokens[i].text in ")]}")
        return i

    first = lambda i, words: next(j for j in range(i, len(tokens)) if tokens[j].text in words and not tokens[j].angle)
    compiled, function, variable = set(), set(), {}
    for i, token in enumerate(tokens):
        if token.angle:
            compiled.add(i)
        elif token.text == "constexpr" and tokens[i - 1].text == "if":
            compiled.update(range(i, closing(i + 1)))
        elif token.text in ("static_assert", "enum", "consteval", "concept"):
            compiled.update(range(i, closing(first(i, "{;" if token.text == "consteval" else "({;"))))
        elif token.text == "constexpr":
            opens = first(i, "({=")
            if tokens[opens].text == "(":
                function.update(range(i, closing(first(closing(opens), "{;"))))
            else:
                variable.update((j, i) for j in range(i, first(opens, ";")))
    return compiled, function, variable


def extent(tokens, i, step):
    """The last token of the operand before or after a && or ||."""
    opening, closes = ("([{", ")]}")[::step]
    looser = {"&&": [["||"], ["||", "&&"]], "||": [[], ["||"]]}[tokens[i].text][step > 0]
    depth, j, stops = 0, i + step, {",", ";", "?", ":", "return", "=", "+=", "-=", *looser}
    while depth > 0 or (tokens[j].text not in closes and (tokens[j].text not in stops or tokens[j].angle)):
        depth += (tokens[j].text in opening) - (tokens[j].text in closes)
        j += step
    return tokens[j - step]


def edits(place, number, tokens, function, variable):
    """The edits of a change: (position, rank at this position, length to replace, new text)."""
    t, of, end = place.token, "::carom::mutation::", ", true>" if place.i in function else ">"
    if place.i in variable:
        before, keyword = tokens[variable[place.i] - 1:variable[place.i] + 1]
        yield keyword.start, 0, len("constexpr"), "inline const" if before.text == "static" else "const"
    if t.text in ("&&", "||"):
        start, stop = extent(tokens, place.i, -1).start, extent(tokens, place.i, 1).end
        yield start, -stop, 0, f'{of}joined<{number}, "{t.text}"{end}([&] {{ return bool('
        yield t.start, 0, 2, "); }, [&] { return bool("
        yield stop, start, 0, "); })"
    elif t.text in CARRIER and t.after:
        change = f'{of}Between<{number}, "{t.text}", "{place.instead}"{end}{{}}'
        yield t.start, 0, len(t.text), f"{CARRIER[t.text]} {change} {CARRIER[t.text]}"
    elif t.kind == "sign":
        yield t.start, 0, 1, f' {of}Before<{number}, "{t.text}"{end}{{}}->*'
    else:
        yield t.start, 0, len(t.text), f'({of}number<{number}, "{place.instead}"{end}({t.text}))'


def places_in(path, text):
    """All changes at each place."""
    tokens = tokens_of(text)
    compiled, _, variable = regions(tokens)
    for i, t in enumerate(tokens):
        if t.text in INSTEAD and t.before and t.after:
            changes = INSTEAD[t.text]
        elif t.kind == "number":
            changes = ["twice", "half"] if re.search("[.pP]", t.text) else ["+ 1"]
        else:
            changes = {"true": ["false"], "false": ["true"]}.get(t.text, [""] if t.text in "-!" and not t.after else [])
        if changes and i not in compiled and tokens[i - 1].text not in ("operator", "case"):
            start, end = text.rfind("\n", 0, t.start) + 1, (text + "\n").index("\n", t.end)
            lines = range(text.count("\n", 0, tokens[variable.get(i, i)].start) + 1, text.count("\n", 0, start) + 2)
            before, after = f"{path}: {text[start:t.start].lstrip()}«{t.text} → ", f"»{text[t.end:end]}"
            yield [Place(path, i, t, one, lines, before + one + after) for one in changes]


def drawn(seed, count):
    """The number of places, and a numbered sample, one change per place. An edited line redraws only its changes."""
    found, named, rank = [], collections.Counter(), lambda one: hashlib.sha256(f"{seed} {one.name}".encode()).digest()
    for path in sorted(path for folder in MUTATED for path in (ROOT / folder).glob("*.[ch]pp")):
        for changes in places_in(str(path.relative_to(ROOT)), path.read_text()):
            named.update(one.name for one in changes)
            one = min(changes, key=rank)
            found.append(one._replace(name=f"{one.name} [{named[one.name]}]"))
    sample = sorted(sorted(found, key=rank)[:count], key=lambda one: one[:2])
    return len(found), dict(enumerate(sample, 1))


def changed(text, places):
    """The text of a file with its changes behind switches. Each change is on its original line."""
    tokens = tokens_of(text)
    _, function, variable = regions(tokens)
    done = {edit for number, place in places.items() for edit in edits(place, number, tokens, function, variable)}
    for start, _, length, new in sorted(done, key=lambda one: one[:2], reverse=True):
        text = text[:start] + new + text[start + length:]
    return re.sub(r"\A.*", f'#include "{ROOT}/tests/mutation/change.hpp"', text)


def write_copy(places):
    """Copies the whole project. A file whose text does not change keeps its time."""
    for folder, folders, files in os.walk(ROOT):
        folders[:] = [one for one in folders if not re.match(r"\.git$|node_modules$|__pycache__$|build", one)]
        for path in (str((pathlib.Path(folder) / name).relative_to(ROOT)) for name in files):
            of_file = {number: place for number, place in places.items() if place.path == path}
            copy, new = WORK / path, (ROOT / path).read_bytes()
            new = changed(new.decode(), of_file).encode() if of_file else new
            if not copy.exists() or copy.read_bytes() != new:
                copy.parent.mkdir(parents=True, exist_ok=True)
                copy.write_bytes(new)


def broken(log, places):
    """The changes that the first error of each file names, by number, with this error. Later errors may follow."""
    found = {}
    for file in log.split("FAILED: ")[1:]:
        lines = [line for line in file.splitlines() if not re.match(r" *\d* \|", line)]
        errors = [i for i, line in enumerate(lines) if ": error: " in line] or [len(lines) - 1]
        notes = (line for line in lines[errors[0]:errors[1] if len(errors) > 1 else None] if ": note: " in line)
        said = "\n".join([*lines[:errors[0] + 1], *notes])
        numbers = {int(one) for one in re.findall(r"(?:(?:Between|Before|joined|number)<|\bId = )(\d+)", said)}
        for path, line in () if numbers else re.findall(r"(\S+?):(\d+):\d+: (?:error|note)", said):
            numbers |= {n for n, one in places.items() if path.endswith(one.path) and int(line) in one.lines}
        found.update((n, lines[errors[0]].split(": error: ")[-1]) for n in numbers if n in places)
    return found


def build(places, jobs):
    """Builds the tests with all changes. Returns the reason for each change that does not compile, by number."""
    known_file = WORK / "dropped.json"
    known = json.loads(known_file.read_text()) if known_file.exists() else {}
    while True:
        left = {n: place for n, place in places.items() if place.name not in known}
        write_copy(left)
        if not (WORK / "build/build.ninja").exists():
            subprocess.run(["cmake", "-S", WORK, "-B", WORK / "build", "--preset", "mutation", "-Wno-dev",
                            "--log-level=WARNING"], check=True, stdout=subprocess.DEVNULL)
        run = subprocess.run(["ninja", "-C", WORK / "build", "-j", str(jobs), "-k", "0",
                              *{program.split("/")[-1] for program, _ in TESTS}], text=True, stdout=subprocess.PIPE)
        if run.returncode == 0:
            return {n: known[place.name] for n, place in places.items() if n not in left}
        new = broken(run.stdout, left)
        if not new:
            sys.exit(f"mutate: the build fails, and no change explains it\n{run.stdout[-5000:]}")
        known.update((left[n].name, reason) for n, reason in new.items())
        known_file.write_text(json.dumps(known, indent=1))


def noticed_by(number):
    """The first test that detects the change; empty if none does."""
    environment = {**os.environ, "CAROM_MUTANT": str(number), "CAROM_EFFORT": "0.15"}  # as CTest samples (tests/CMakeLists.txt)
    for program, tests in TESTS:
        run = subprocess.run([*LIMITS, WORK / "build/tests" / program, f"--gtest_filter={tests}", "--gtest_fail_fast",
                              "--gtest_brief=1"], env=environment, text=True, errors="replace", capture_output=True)
        if run.returncode != 0:
            failed = re.search(r"\[  FAILED  \] ([^,\s]+)", run.stdout)
            return f"{program}: {failed.group(1) if failed else f'ends in {run.returncode}'}"
    return ""


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--seed", type=int, default=1, help="of the sample (default 1)")
    parser.add_argument("--count", type=int, default=150, help="how many changes to draw (default 150)")
    parser.add_argument("--jobs", type=int, default=os.cpu_count(), help="how many changes are tried at a time")
    parser.add_argument("--list", action="store_true", help="print what is drawn, and stop")
    parser.add_argument("--only", type=int, nargs="+", metavar="ID", help="try these of the sample")
    parser.add_argument("--share-alone", action="store_true", help="for a new sample: a survivor need not be named")
    options = parser.parse_args()
    found, places = drawn(options.seed, options.count)
    if unknown := set(options.only or []) - set(places):
        parser.error(f"--only: the sample has no change {', '.join(map(str, sorted(unknown)))}")
    if options.list:
        print("\n".join(f"{number:4} {place.lines[-1]:4} {place.name}" for number, place in places.items()))
        return 0
    dropped, start = build(places, options.jobs), time.monotonic()
    if failed := noticed_by(0):
        sys.exit(f"mutate: without a change, {failed} fails")
    print(f"built; without a change the tests take {time.monotonic() - start:.0f} s",
          *(f"{n:4} dropped: {reason}: {places[n].name}" for n, reason in dropped.items()), sep="\n", flush=True)
    tried, survivors = [n for n in places if n not in dropped and n in (options.only or places)], []
    with concurrent.futures.ThreadPoolExecutor(options.jobs) as pool:
        for number, by in zip(tried, pool.map(noticed_by, tried)):
            print(f"{number:4} {by or 'SURVIVES'}: {places[number].name}", flush=True)
            survivors += [] if by else [number]
    unlisted = [n for n in survivors if places[n].name not in (ROOT / PAGE).read_text()]
    noticed = len(tried) - len(survivors)
    print(f"{found} places found, {len(places)} drawn, {len(dropped)} dropped, {noticed} noticed "
          f"({100 * noticed / max(1, len(tried)):.1f} %), {len(survivors)} survived, of which {PAGE} does not name "
          f"{unlisted or 'none'}")
    enough = noticed >= LEAST_NOTICED * len(tried) and (options.share_alone or not unlisted)
    return int(not enough or len(dropped) > MOST_DROPPED * len(places))


if __name__ == "__main__":
    sys.exit(main())
