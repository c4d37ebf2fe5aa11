#!/usr/bin/env python3
# SPDX-License-Identifier: BSL-1.0
"""A false law makes the proof of the theorem about this law fail. So does a false statement.

usage: false_laws_test.py PROOFS BUILD
"""

import pathlib
import re
import sys
import unittest

import coq

# (the error, its file, the original text, the replacement, the file that fails, the theorem or lemma that fails)
FALSE_LAWS = [
    ("ε for 1 + ε", "laws", "scaled (- ((1 + restitution c) * approach c) / normal_compliance c) (normal c)",
     "scaled (- (restitution c * approach c) / normal_compliance c) (normal c)", "laws_of_impulse",
     "frictionless_approach"),
    ("λ twice", "laws", "matrix_sum (uniform (inverse_masses c))\n",
     "matrix_sum (uniform (inverse_masses c + inverse_masses c))\n", "collision_matrix", "collision_matrix_applied"),
    ("the impulse on B is that on A", "laws", "(pushed (body_b c) (point c) (negated f))", "(pushed (body_b c) (point c) f)",
     "collision_matrix", "velocity_change"),
    ("the reaction forgets to turn", "laws",
     "(sum (spin b) (applied (inverse_inertia b) (cross (lever_arm b p) f)))", "(spin b)", "collision_matrix",
     "velocity_change"),
    ("the lever arm points to the centre", "laws", "difference p (centre b)", "difference (centre b) p", "momentum",
     "angular_momentum_pushed"),
    ("r × ω for ω × r", "laws", "(cross (spin b) (lever_arm b p))", "(cross (lever_arm b p) (spin b))",
     "collision_matrix", "velocity_change"),
    ("reflection divides by ‖N‖", "laws", "/ dot (normal c) (normal c))\n           (solved", "/ 1)\n           (solved",
     "laws_of_impulse", "reflection_changes"),
    ("sticking forgets the rebound", "laws",
     "(scaled (restitution c * approach c / dot (normal c) (normal c)) (normal c))", "null", "laws_of_impulse",
     "sticking_changes"),
    ("the cone is as wide as its opposite", "laws", "negb (less push 0) && ", "", "friction", "in_cone_true"),
    ("rough tries e_t for 1 + e_t", "laws", "in_cone c (rough_with c (1 + tangential_restitution c))",
     "in_cone c (rough_with c (tangential_restitution c))", "friction", "rough_without_friction"),
    ("rough sticks with e_t for 1 + e_t", "laws", "then (1 + tangential_restitution c, 0)",
     "then (tangential_restitution c, 0)", "friction", "kappa_in_cone"),
    ("κ on the cone without its own share", "laws", "push / rest * d, push / rest", "push / rest, push / rest", "friction",
     "kappa_is_textbook"),
    ("contacts that part are pushed as well", "laws", "less 0 (inverse_masses c) && less (approach c) 0",
     "less 0 (inverse_masses c)", "reals", "is_colliding_true"),
    ("ε above 1", "reals", "0 <= restitution c <= 1", "0 <= restitution c", "laws_of_impulse", "parts_no_faster"),
    ("of rough's root, B goes where A does", "answers", "(scaled (inverse_mass (body_b c)) (negated f))",
     "(scaled (inverse_mass (body_b c)) f)", "answers_compute", "response_adds"),
    ("an orientation that shears", "described_bodies", "two * (x * y - w * z)", "two * (x * y + w * z)",
     "described_bodies", "rotation_applied"),
    ("friction along the slip", "every_law", "scaled (- (friction c * dot (normal c) f)) slip",
     "scaled (friction c * dot (normal c) f) slip", "impulse_bound", "impulse_bound_of_coulomb"),
    ("a bound that forgets the rebound", "impulse_bound",
     "square (frictionless_impulse c) * square N <= squared ((1 + epsilon) * approach c)",
     "square (frictionless_impulse c) * square N <= squared (approach c)", "impulse_bound",
     "impulse_bound_of_frictionless"),
    ("a bound that forgets e_t", "impulse_bound", "1 + Rmax (restitution c) (tangential_restitution c)",
     "1 + restitution c", "impulse_bound", "at_most_largest_factor"),
]
# The same law, written differently.
TRUE_LAW = ("laws", "inverse_mass (body_a c) + inverse_mass (body_b c)", "inverse_mass (body_b c) + inverse_mass (body_a c)")


class FalseLaws(unittest.TestCase):
    def compiled_with(self, file, right, wrong, *targets):
        """Replaces one text in a file, and checks the proofs of the targets. Returns the exit status and the output."""
        changed = coq.copied(proofs, build)
        text = (changed / f"{file}.v").read_text()
        self.assertEqual(text.count(right), 1, "it is not written so any more")
        (changed / f"{file}.v").write_text(text.replace(right, wrong))
        return coq.compiled(changed, [f"{target}.vok" for target in targets], jobs=1)  # checks only the statements of other files, not their proofs

    def test_make_the_proof_fail_that_speaks_of_them(self):
        for what, place, right, wrong, file, theorem in FALSE_LAWS:
            with self.subTest(what):
                status, said = self.compiled_with(place, right, wrong, file)
                self.assertNotEqual(status, 0, "nothing fails")
                failed = re.search(r'File "\./(\w+)\.v", line (\d+)', said)
                self.assertIsNotNone(failed, said[-2000:])
                lines = (build / f"{failed[1]}.v").read_text().splitlines()[: int(failed[2])]
                begun = [re.match(r"\s*(?:Theorem|Lemma|Corollary)\s+([\w']+)", line) for line in lines]
                last = [name[1] for name in begun if name]
                self.assertEqual((failed[1], last[-1]), (file, theorem))

    def test_a_true_law_makes_none_fail(self):
        status, said = self.compiled_with(*TRUE_LAW, *dict.fromkeys(file for *_, file, _ in FALSE_LAWS))
        self.assertEqual(status, 0, said[-2000:])


if __name__ == "__main__":
    if len(sys.argv) < 3:
        sys.exit(__doc__)
    build = pathlib.Path(sys.argv.pop())
    proofs = pathlib.Path(sys.argv.pop())
    unittest.main()
