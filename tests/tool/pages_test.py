#!/usr/bin/env python3
# SPDX-License-Identifier: BSL-1.0
"""Compares numbers and lists of the pages with the program's output: pages_test.py CAROM"""

import json
import pathlib
import re
import subprocess
import sys
import unittest

TOP = pathlib.Path(__file__).resolve().parents[2]
CAROM = sys.argv[1]
PAGES = {str(file.relative_to(TOP)): file.read_text(encoding="utf-8")
         for file in [TOP / "README.md", *sorted((TOP / "docs").rglob("*.md"))]}
# These pages describe the current version. The other pages may describe an earlier run.
OF_TODAY = [page for page in PAGES if re.match("README|docs/(guide|reference)/|docs/[A-Za-z]*.md", page)
            and page != "docs/CHANGELOG.md"]
WORDS = ["none", "one", "two", "three", "four", "five", "six", "seven", "eight", "nine", "ten", "eleven", "twelve"]
OPTION = re.compile(r"(?<![\w-])--[a-z][a-z-]*")


def printed(*words):
    return subprocess.run([CAROM, *words], capture_output=True, text=True, check=False).stdout


def listed(command):
    return json.loads(printed(command, "--format", "json"))


HELP = printed("--help")
COMMANDS = dict(re.findall(r"^  (\w+)  +(.*)$", HELP[HELP.index("Subcommands:"):], re.M))
OPTIONS = {command: set(OPTION.findall(printed(command, "--help"))) for command in COMMANDS}


def paragraph(page, begin):
    """The text from `begin` to the end of its item or paragraph."""
    text = PAGES[page]
    return re.split(r"\n\n|\n[-\d|]", text[text.index(begin):])[0]


class Pages(unittest.TestCase):
    maxDiff = None

    def said(self, pattern, pages, least=1):
        """The matches of a pattern, each with its page."""
        found = [(match, f"{page}: {match[0]}") for page in pages for match in re.finditer(pattern, PAGES[page], re.M)]
        self.assertGreaterEqual(len(found), least, f"nothing says {pattern}")
        return found

    def test_count_families_and_cases(self):
        run = json.loads(printed("gate", "frictionless-double", "--cases", "1", "--format", "json"))
        each = int(re.search(r"--cases .*=(\d+)", printed("gate", "--help"))[1])
        for match, where in self.said(r"(?:Each of the|all) (\d+) families", OF_TODAY):
            self.assertEqual(int(match[1]), len(run["families"]), where)
        beyond = {family["name"] for family in listed("families") if family["beyond_domain"]}
        for match, where in self.said(r"(\w+) (?:more families|families more)", OF_TODAY, 2):
            self.assertEqual(WORDS.index(match[1].lower()), len(beyond), where)
        section = PAGES["docs/guide/reading-a-report.md"].split("## Beyond the claimed domain")[1].split("\n## ")[0]
        self.assertEqual(set(re.findall(r"^\| `(\w+)` \|", section, re.M)), beyond)
        for match, where in self.said(r"draws (\d+) collisions \(`--cases`\)", OF_TODAY):
            self.assertEqual(int(match[1]), each, where)

    def test_count_subjects(self):
        said = " ".join(printed("gate", "--cases", "1", "--families", "both_immovable").split("\n\n")[-1].split())
        expected = re.search(r"(\d+) subjects that count\b.* (\d+) more are kept", said)
        for match, where in self.said(r"All (\d+) subjects that count are sound; (\d+) more are kept", OF_TODAY):
            self.assertEqual(match.groups(), expected.groups(), where)

    def test_count_tests_of_a_conformance_suite(self):
        page = "docs/guide/conformance.md"
        further = re.findall(r"judged on\s+((?:`\w+`(?:, | and )?)+)", PAGES[page])
        further = set(re.findall(r"`(\w+)`", "".join(further)))
        claimed = {each["name"] for each in listed("invariants") if "frictionless" in each["models"]}
        self.assertLess(further, claimed)
        families = {each["name"] for each in listed("families") if not each["beyond_domain"]} - {"invalid"}
        for match, where in self.said(r"(\d+) tests\s+for `frictionless`", [page]):
            self.assertEqual(int(match[1]), len(claimed - further) * len(families), where)

    def test_count_features(self):
        for match, where in self.said(r"\((\d+) features", ["docs/findings/detection.md"]):
            self.assertEqual(int(match[1]), len(listed("features")), where)
        self.assertEqual(printed("features", "--format", "markdown"), PAGES["docs/reference/features.md"])

    def test_list_the_invariants_with_their_theorems(self):
        self.assertEqual(printed("invariants", "--format", "markdown"), PAGES["docs/reference/invariants.md"])
        proofs = TOP / "properties/proofs"
        proved = (proofs / "theorems.txt").read_text()
        invariants = listed("invariants")
        self.assertEqual(len({each["name"] for each in invariants}), len(invariants))
        theorems = [theorem for each in invariants for theorem in each["theorems"]]
        self.assertGreater(len(theorems), len(invariants))
        for theorem in theorems:
            text, name = (proofs / theorem["file"]).read_text(), theorem["name"]
            self.assertRegex(text, rf"(?m)^ *(Theorem|Lemma|Corollary) {name}(?![\w'])")
            self.assertIn(f"\n{theorem['file'].rsplit('.', 1)[0]} {name}\n", proved)
        for each in invariants:
            for field in ("statement", "formula", "source", "domain", "models"):
                self.assertTrue(each[field], f"{each['name']}: {field}")

    def test_name_subjects_that_exist(self):
        names = {subject["name"] for subject in listed("subjects")}
        pattern = r"(?<![\w./-])(?:frictionless|reflection|sticking|rough|coulomb)-[a-z-]*(?:float|double)(?![\w*…-])"
        for match, where in self.said(pattern, PAGES, 100):
            self.assertIn(match[0], names, where)

    def test_list_every_law(self):
        laws = {law for invariant in listed("invariants") for law in invariant["models"]} | {"any"}
        for page, begin in (("docs/guide/plug-in.md", "2. Set `name`"), ("docs/guide/conformance.md", "The models are"),
                            ("docs/reference/protocol.md", "`model` is the law")):
            named = set(re.findall(r"`(\w+)`", paragraph(page, begin)))
            self.assertEqual(laws - named, set(), page)
        said = paragraph("docs/vocabulary.md", "| law |")
        self.assertEqual([law for law in laws if law not in said], [], "docs/vocabulary.md")
        for match, where in self.said(r"(\w+) laws\b", ["docs/guide/laws.md", "docs/guide/scenes.md"]):
            if match[1] in WORDS:
                self.assertEqual(WORDS.index(match[1]), len(laws - {"any"}), where)

    def test_define_words_that_the_sources_declare(self):
        folders = ("src", "oracles", "properties")
        headers = [path.read_text() for folder in folders for path in TOP.glob(f"{folder}/**/*.hpp")]
        rows = [row.split(" | ") for row in PAGES["docs/vocabulary.md"].splitlines() if row.startswith("| ")][2:]
        names = [name for row in rows for name in re.findall(r"`([^`]+)`", row[-1])]
        self.assertGreater(len(names), 40)
        for name in names:
            with self.subTest(word=name):
                if "/" in name:
                    self.assertTrue((TOP / name).exists())
                    continue
                spaces = [part for part in name.split("::")[:-1] if part.islower()]
                declared, *members = name.split("::")[len(spaces):]
                declaration = re.compile(rf"\b(struct|class|using) {declared}\b|^[^/\n]*[\w>&] {declared}\(", re.M)
                found = [text for text in headers if declaration.search(text) and "::".join(["carom", *spaces]) in text]
                self.assertTrue(any(all(re.search(rf"\b{member}\b", text) for member in members) for text in found))

    def test_list_every_engine(self):
        names = {subject["name"] for subject in listed("subjects")}
        builds = {name.removesuffix("-coulomb") for name in names if name.endswith("-coulomb")}
        engines = {build.split("-")[0] for build in builds}
        pages = {page for page in PAGES if page.startswith("docs/reference/engines/")}
        self.assertEqual({pathlib.Path(page).stem for page in pages}, engines)
        for page in ("docs/README.md", "docs/findings/engines.md"):
            linked = set(re.findall(r"\((?:\.\./)?reference/engines/(\w+)\.md", PAGES[page]))
            self.assertEqual(linked, engines, page)
        friction = PAGES["docs/findings/engines.md"].split("## What their friction is")[1].split("\n## ")[0]
        for page in pages:
            title = PAGES[page].split("\n", 1)[0].removeprefix("# ")
            self.assertIn(f"| [{title}]", friction, "docs/findings/engines.md has the friction of each engine")
        for match, where in self.said(r"(\w+) builds of (\w+) engines", ["docs/findings/engines.md"]):
            self.assertEqual((WORDS.index(match[1]), WORDS.index(match[2])), (len(builds), len(engines)), where)

    def test_say_exit_statuses_as_the_program_does(self):
        section = PAGES["docs/guide/reading-a-report.md"].split("## Exit status")[1].split("\n## ")[0]
        self.assertEqual(re.findall(r"(?:^|\. )(\d): ", section, re.M), re.findall(r"\d", COMMANDS["gate"]))
        for status, of_program, of_page in ((0, "hold", "sound"), (1, "violated", "violates"), (2, "usage", "usage")):
            self.assertRegex(COMMANDS["gate"], rf"{status}[^\d]*{of_program}")
            self.assertRegex(section, rf"(?m)(?:^|\. ){status}: [^\d]*{of_page}")

    def test_name_options_that_exist(self):
        for page, text in PAGES.items():
            for match in re.finditer(r"\bcarom (\w+)\b([^`|\n]*)", re.sub(r"'exec:[^']*'", "", text)):
                if match[1] in COMMANDS:
                    self.assertEqual(set(OPTION.findall(match[2])) - OPTIONS[match[1]], set(), f"{page}: {match[0]}")
        known = set().union(*OPTIONS.values())
        for match, where in self.said(r"`(--[a-z][a-z-]*)", OF_TODAY, 20):
            self.assertIn(match[1], known, where)

    def test_name_every_option(self):
        named = {option for page in OF_TODAY for option in OPTION.findall(PAGES[page])}
        for command, options in OPTIONS.items():
            self.assertEqual(options - named, set(), command)

    def test_give_the_limit(self):
        limit = re.search(r"--limit-ulps \w+=(\d+)", printed("gate", "--help"))[1]
        pattern = r"(\d+) (?:is the limit )?\(`--limit-ulps`\)|at most (\d+) units in the last"
        for match, where in self.said(pattern, OF_TODAY, 3):
            self.assertEqual(match[1] or match[2], limit, where)

    def test_name_tests_that_exist(self):
        sources = "".join(file.read_text(encoding="utf-8") for file in sorted((TOP / "tests").rglob("*_test.cpp")))
        tests = set(re.findall(r"\bTEST(?:_F|_P)?\((\w+,\s*\w+)\)", sources))
        tests = {re.sub(r",\s*", ".", test) for test in tests}
        for match, where in self.said(r"(?<=\| )[A-Z]\w+\.[A-Z]\w+", ["docs/internals/bounds.md"], 15):
            self.assertIn(match[0], tests, where)
        for match, where in self.said(r"--gtest_filter='(\w+)\.\*'", PAGES):
            self.assertIn(match[1], {test.split(".")[0] for test in tests}, where)

    def test_give_the_reasons_why_a_case_is_not_judged(self):
        run = json.loads(printed("gate", "frictionless-float", "--cases", "1", "--format", "json"))
        table = PAGES["docs/reference/yardstick.md"].split("## What is not judged")[1]
        self.assertEqual(set(re.findall(r"\| `(\w+)` \|", table)), set(run["subjects"][0]["not_judged"]))

    def test_show_or_link_every_chart(self):
        named = {name for text in PAGES.values() for name in re.findall(r"charts/([\w./-]+\.(?:svg|csv))", text)}
        charts = TOP / "docs/charts"
        self.assertEqual({str(chart.relative_to(charts)) for chart in charts.rglob("*.*")}, named)


class PlantedDefects(unittest.TestCase):
    TEXT = (TOP / "tests/mutants/catalogue.cpp").read_text(encoding="utf-8")
    ENTRIES = dict(re.findall(r'\{"(\w+)", \w+, "([\d, ]*)"', TEXT))

    def test_are_counted(self):
        for page, pattern in (("README.md", r"each of (\d+) planted defects"),
                              ("docs/findings/detection.md", r"^(\d+) solvers"),
                              ("docs/reference/failure-cases.md", r"of the (\d+) planted mutants stand for no entry")):
            found = re.search(pattern, PAGES[page], re.M)
            self.assertIsNotNone(found, page)
            self.assertEqual(int(found[1]), len(self.ENTRIES), f"{page}: {found[0]}")

    def test_stand_at_the_failures_that_they_are_of(self):
        page = PAGES["docs/reference/failure-cases.md"]
        rows = {number: set(re.findall(r"`(\w+)`", row))
                for number, row in re.findall(r"^\| (\d+) \| (.*) \|$", page, re.M)}
        of_catalogue = {number: set() for number in rows}
        for name, entries in self.ENTRIES.items():
            for number in re.findall(r"\d+", entries):
                of_catalogue[number].add(name)
        self.assertEqual(rows, of_catalogue)
        without = sum(1 for entries in self.ENTRIES.values() if not entries)
        self.assertIn(f"\n{without} of the", page)


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1] + sys.argv[2:])
