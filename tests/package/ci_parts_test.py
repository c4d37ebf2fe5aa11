# SPDX-License-Identifier: BSL-1.0
"""What can be said of the workflows without running them, of the action's scripts, and of what plays them."""

import os
import pathlib
import subprocess
import tempfile
import unittest

import yaml

import ci_test
import containerfile
import github_job
from github_expressions import evaluated, filled_in, is_to_run

TOP = pathlib.Path(__file__).resolve().parents[2]
ACTION = TOP / github_job.ACTION
PAGE = (TOP / ci_test.PAGE).read_text(encoding="utf-8")


class Expressions(unittest.TestCase):
    CONTEXTS = {"env": {"A": "x"}, "steps": {"cache": {"outputs": {"cache-hit": "true"}}}}

    def test_are_read_as_github_reads_them(self):
        for expression, value in (("env.A", "x"), ("env.none", ""), ("'it''s'", "it's"), ("env.A == 'x'", True),
                                  ("steps.cache.outputs.cache-hit != 'true'", False), ("!always()", False),
                                  ("env.none || 'y'", "y"), ("env.A && (failure() || 'z')", "z")):
            self.assertEqual(evaluated(expression, self.CONTEXTS), value, expression)
        self.assertEqual(filled_in("a-${{ env.A }}-${{env.none}}", self.CONTEXTS), "a-x-")

    def test_that_are_not_known_are_errors(self):
        for expression in ("env.A ==", "env.A env.A", "(env.A", "env.A + 1"):
            with self.assertRaises(ValueError, msg=expression):
                evaluated(expression, self.CONTEXTS)
        with self.assertRaises(KeyError):
            evaluated("unknown()", self.CONTEXTS)

    def test_of_a_step_do_not_hold_after_a_failure_unless_they_say_so(self):
        for condition, after_success, after_failure in (("env.A == 'x'", True, False), ("always()", True, True),
                                                        ("failure()", False, True), ("${{ always() }}", True, True)):
            self.assertEqual(is_to_run(condition, self.CONTEXTS, False), after_success, condition)
            self.assertEqual(is_to_run(condition, self.CONTEXTS, True), after_failure, condition)


class Annotations(unittest.TestCase):
    def test_between_stop_and_its_token_are_none(self):
        with tempfile.TemporaryDirectory() as folder:
            log = pathlib.Path(folder, "log")
            log.write_text("::notice title=a::1\n::stop-commands::t\n ::error::2\n::t::\n  ::error title=b::3\n", encoding="utf-8")
            self.assertEqual(github_job.annotations_in(log), [("notice", "1"), ("error", "3")])


class Page(unittest.TestCase):
    def workflows(self):
        return [github_job.read_yaml(block) for block in ci_test.blocks_of(PAGE, "yaml") if "jobs:" in block]

    def test_workflows_have_triggers_and_one_job_in_debian(self):
        self.assertEqual(len(self.workflows()), 2)
        for workflow in self.workflows():
            self.assertTrue(workflow["on"])
            (job,) = workflow["jobs"].values()
            self.assertEqual(job["container"], "debian:12")

    def test_the_package_is_kept_before_anything_is_judged(self):
        (steps,) = [list(workflow["jobs"].values())[0]["steps"] for workflow in self.workflows() if "env" in workflow]
        action = yaml.safe_load((ACTION / "action.yml").read_text(encoding="utf-8"))
        for judging, of in (("carom gate", steps), ("gate.sh", action["runs"]["steps"])):
            names = [step.get("uses") or step["run"] for step in of]
            save = names.index("actions/cache/save@v4")
            self.assertLess(save, [judging in name for name in names].index(True))
            self.assertEqual(of[save]["with"], of[names.index("actions/cache/restore@v4")]["with"])

    def test_names_the_inputs_of_the_action(self):
        for name in yaml.safe_load((ACTION / "action.yml").read_text(encoding="utf-8"))["inputs"]:
            self.assertIn(f"`{name}`", PAGE)

    def test_the_containerfile_has_no_instruction_that_is_not_played(self):
        text = (TOP / "docs/examples/Containerfile").read_text(encoding="utf-8")
        words = [word for word, _ in containerfile.instructions_of(text)]
        self.assertEqual(set(words), {"FROM", "WORKDIR", "COPY", "RUN", "ENTRYPOINT"})
        for command in ("docker build --tag carom", "docker run --rm"):
            (line,) = [line for line in text.splitlines() if command in line]
            self.assertIn(line.removeprefix("#   "), PAGE)


class ActionScripts(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)

    def judge(self, status=0, **inputs):
        """What gate.sh calls carom with, one argument on each line, and how it ends."""
        program = self.folder / "carom"
        program.write_text(f'#!/bin/sh\nprintf "%s\\n" "$@"\nexit {status}\n', encoding="utf-8")
        program.chmod(0o755)
        environment = {"PATH": f"{self.folder}:{os.environ['PATH']}", "CAROM_SUBJECTS": "", "CAROM_SEED": "1",
                       "CAROM_CASES": "1000", "CAROM_BASELINE": "", "CAROM_ARGUMENTS": "", "CAROM_OUT": "out",
                       "GITHUB_STEP_SUMMARY": "summary"} | inputs
        ended = subprocess.run(["bash", str(ACTION / "gate.sh")], env=environment, cwd=self.folder, capture_output=True,
                               text=True, check=False)
        return ended.stdout.splitlines(), ended.returncode

    def test_pass_each_input_as_it_stands(self):
        arguments, status = self.judge(CAROM_SUBJECTS="exec:./my-solver --flag 'a b'\n\nexec:x; touch planted $(touch planted)\n",
                                       CAROM_ARGUMENTS="--families\nhead_on", CAROM_SEED="7; touch planted")
        self.assertEqual(arguments, ["gate", "exec:./my-solver --flag 'a b'", "exec:x; touch planted $(touch planted)",
                                     "--seed", "7; touch planted", "--cases", "1000", "--out", "out", "--annotations",
                                     "github", "--summary", "summary", "--families", "head_on"])
        self.assertEqual(status, 0)
        self.assertFalse((self.folder / "planted").exists())

    def test_pass_a_baseline_where_there_is_one(self):
        self.assertNotIn("--baseline", self.judge()[0])
        self.assertEqual(self.judge(CAROM_BASELINE="old report.json")[0][-2:], ["--baseline", "old report.json"])

    def test_end_as_the_gate_and_write_the_badge(self):
        (self.folder / "out").mkdir()
        (self.folder / "out/report.json").touch()
        arguments, status = self.judge(status=1)
        self.assertEqual(arguments[-4:], ["badge", "out/report.json", "--out", "out/badge.json"])
        self.assertEqual(status, 1)

    def test_name_another_key_where_a_source_differs(self):
        for name in ("CMakeLists.txt", "src/a.cpp", "oracles/b", "properties/c", "docs/d"):
            (self.folder / name).parent.mkdir(exist_ok=True)
            (self.folder / name).write_text("1", encoding="utf-8")
        script = self.folder / github_job.ACTION / "key.sh"
        script.parent.mkdir(parents=True)
        script.write_text((ACTION / "key.sh").read_text(encoding="utf-8"), encoding="utf-8")

        def key():
            return subprocess.run(["bash", str(script)], check=True, capture_output=True, text=True).stdout

        before = key()
        self.assertRegex(before, r"^key=carom-[\w.-]+-[0-9a-f]{32}\n$")
        (self.folder / "src/node_modules").mkdir()
        (self.folder / "src/node_modules/other").touch()
        (self.folder / "build").mkdir()
        (self.folder / "build/other").touch()
        self.assertEqual(key(), before)
        (self.folder / "src/a.cpp").write_text("2", encoding="utf-8")
        self.assertNotEqual(key(), before)


if __name__ == "__main__":
    unittest.main()
