#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""A false law makes a proof fail, and the one that speaks of it.

usage: false_laws_test.py PROOFS BUILD
"""

import pathlib
import re
import sys
import unittest

import coq

# (what is false, what stands in laws.v, what is put in its place, the file that fails, the theorem or lemma at which)
FALSE_LAWS = [
    ("ε for 1 + ε", "scaled (- ((1 + restitution c) * approach c) / normal_compliance c) (normal c)",
     "scaled (- (restitution c * approach c) / normal_compliance c) (normal c)", "laws_of_impulse",
     "frictionless_approach"),
    ("λ twice", "matrix_sum (uniform (inverse_masses c))\n", "matrix_sum (uniform (inverse_masses c + inverse_masses c))\n",
     "collision_matrix", "collision_matrix_applied"),
    ("the impulse on B is that on A", "(pushed (body_b c) (point c) (negated f))", "(pushed (body_b c) (point c) f)",
     "collision_matrix", "velocity_change"),
    ("the reaction forgets to turn", "(sum (spin b) (applied (inverse_inertia b) (cross (lever_arm b p) f)))", "(spin b)",
     "collision_matrix", "velocity_change"),
    ("reflection divides by ‖N‖", "/ dot (normal c) (normal c))\n           (solved", "/ 1)\n           (solved",
     "laws_of_impulse", "reflection_changes"),
    ("sticking forgets the rebound", "(scaled (restitution c * approach c / dot (normal c) (normal c)) (normal c))",
     "null", "laws_of_impulse", "sticking_changes"),
    ("the cone is as wide as its opposite", "negb (less push 0) && ", "", "friction", "in_cone_true"),
    ("κ on the cone without its own share", "push / rest * d, push / rest", "push / rest, push / rest", "friction",
     "kappa_is_textbook"),
    ("contacts that part are pushed as well", "less 0 (inverse_masses c) && less (approach c) 0", "less 0 (inverse_masses c)",
     "reals", "is_colliding_true"),
]


class FalseLaws(unittest.TestCase):
    def test_make_the_proof_fail_that_speaks_of_them(self):
        text = (proofs / "laws.v").read_text()
        for what, right, wrong, file, theorem in FALSE_LAWS:
            with self.subTest(what):
                self.assertEqual(text.count(right), 1, "the law is not written so any more")
                changed = coq.copied(proofs, build)
                (changed / "laws.v").write_text(text.replace(right, wrong))
                status, said = coq.compiled(changed, [f"{file}.vo"], jobs=1)
                self.assertNotEqual(status, 0, "nothing fails")
                place = re.search(r'File "\./(\w+)\.v", line (\d+)', said)
                self.assertIsNotNone(place, said[-2000:])
                lines = (changed / f"{place[1]}.v").read_text().splitlines()[: int(place[2])]
                begun = [re.match(r"\s*(?:Theorem|Lemma|Corollary)\s+([\w']+)", line) for line in lines]
                last = [name[1] for name in begun if name]
                self.assertEqual((place[1], last[-1]), (file, theorem))

    def test_none_makes_none_fail(self):
        status, said = coq.compiled(coq.copied(proofs, build), ["friction.vo"])
        self.assertEqual(status, 0, said[-2000:])


if __name__ == "__main__":
    if len(sys.argv) < 3:
        sys.exit(__doc__)
    build = pathlib.Path(sys.argv.pop())
    proofs = pathlib.Path(sys.argv.pop())
    unittest.main()
