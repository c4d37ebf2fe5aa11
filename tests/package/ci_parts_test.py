# SPDX-License-Identifier: BSL-1.0
"""Tests of the action's scripts, and of the parts of the workflows that need no bare Debian."""

import os
import pathlib
import subprocess
import tempfile
import unittest

import ci_test
import containerfile
import github_steps

TOP = pathlib.Path(__file__).resolve().parents[2]
ACTION = TOP / github_steps.ACTION
ACTION_FILE = github_steps.read_yaml((ACTION / "action.yml").read_text(encoding="utf-8"))
PAGE = (TOP / ci_test.PAGE).read_text(encoding="utf-8")


class Steps(unittest.TestCase):
    STEPS = [{"uses": "actions/checkout@v4"}, {"run": "one"}, {"run": "two", "if": github_steps.CACHE_MISS},
             {"uses": "actions/cache/save@v4", "with": {"path": "kept"}}, {"run": "three", "shell": "bash"}]

    def test_have_commands(self):
        last = ["bash", "--noprofile", "--norc", "-eo", "pipefail", "-c", "three"]
        self.assertEqual(github_steps.commands_of(self.STEPS, False), [["sh", "-e", "-c", "one"], ["sh", "-e", "-c", "two"], last])
        self.assertEqual(github_steps.commands_of(self.STEPS, True), [["sh", "-e", "-c", "one"], last])

    def test_have_a_folder_that_is_cached(self):
        self.assertEqual(github_steps.cached_folder(self.STEPS), "kept")

    def test_print_no_annotations_between_stop_and_its_token(self):
        text = "::notice title=a::1\n::stop-commands::t\n ::error::2\n::t::\n  ::error title=b::3\n"
        self.assertEqual(github_steps.annotations_in(text), [("notice", "1"), ("error", "3")])


class Page(unittest.TestCase):
    def workflows(self):
        return [github_steps.read_yaml(block) for block in ci_test.blocks_of(PAGE, "yaml") if "jobs:" in block]

    def all_steps(self):
        return [*(step for workflow in self.workflows() for step in self.steps_of(workflow)), *ACTION_FILE["runs"]["steps"]]

    def steps_of(self, workflow):
        (job,) = workflow["jobs"].values()
        return job["steps"]

    def test_workflows_have_triggers_and_one_job_in_debian(self):
        self.assertEqual(len(self.workflows()), 2)
        for workflow in self.workflows():
            self.assertTrue(workflow["on"])
            (job,) = workflow["jobs"].values()
            self.assertEqual(job["container"], "debian:12")

    def test_the_package_is_kept_before_anything_is_judged(self):
        (steps,) = [self.steps_of(workflow) for workflow in self.workflows() if "env" in workflow]
        for judging, of in (("carom gate", steps), ("gate.sh", ACTION_FILE["runs"]["steps"])):
            names = [step.get("uses") or step["run"] for step in of]
            save = names.index("actions/cache/save@v4")
            self.assertLess(save, [judging in name for name in names].index(True))
            self.assertEqual(of[save]["with"], of[names.index("actions/cache/restore@v4")]["with"])

    def test_scripts_need_nothing_that_github_fills_in(self):
        for step in self.all_steps():
            self.assertNotIn("${{", step.get("run", ""))
            conditions = {None, github_steps.CACHE_MISS} if "run" in step else {None, github_steps.CACHE_MISS, github_steps.ALWAYS}
            self.assertIn(step.get("if"), conditions)

    def test_variables_come_by_the_environment(self):
        (workflow,) = [workflow for workflow in self.workflows() if "env" in workflow]
        self.assertEqual(workflow["env"], {name: f"${{{{ vars.{name} }}}}" for name in ("CAROM_URL", "CAROM_REVISION")})
        (judging,) = [step for step in ACTION_FILE["runs"]["steps"] if "gate.sh" in step.get("run", "")]
        inputs = set(ACTION_FILE["inputs"]) - {"artifact"}
        self.assertEqual(judging["env"], {f"CAROM_{name.upper()}": f"${{{{ inputs.{name} }}}}" for name in inputs})

    def test_names_the_inputs_of_the_action(self):
        for name in ACTION_FILE["inputs"]:
            self.assertIn(f"`{name}`", PAGE)
        (use,) = [step for step in self.all_steps() if github_steps.is_action(step)]
        self.assertLessEqual(set(use["with"]), set(ACTION_FILE["inputs"]))

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
        """The arguments with which gate.sh calls carom, one per line, and its exit status."""
        program = self.folder / "carom"
        program.write_text(f'#!/bin/sh\nprintf "%s\\n" "$@"\nexit {status}\n', encoding="utf-8")
        program.chmod(0o755)
        environment = {"PATH": f"{self.folder}:{os.environ['PATH']}", "CAROM_SUBJECTS": "", "CAROM_SEED": "1",
                       "CAROM_CASES": "1000", "CAROM_WITHIN": "", "CAROM_DIGITS": "",
                       "CAROM_BASELINE": "", "CAROM_ARGUMENTS": "", "CAROM_OUT": "out",
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
        self.assertEqual(self.judge(CAROM_WITHIN="size=1:2", CAROM_DIGITS="4")[0][-4:],
                         ["--within", "size=1:2", "--digits", "4"])

    def test_end_as_the_gate(self):
        self.assertEqual(self.judge(status=1)[1], 1)

    def test_name_another_key_where_a_source_differs(self):
        for name in ("CMakeLists.txt", "src/a.cpp", "oracles/b", "properties/c", "docs/d"):
            (self.folder / name).parent.mkdir(exist_ok=True)
            (self.folder / name).write_text("1", encoding="utf-8")
        script = self.folder / github_steps.ACTION / "key.sh"
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
