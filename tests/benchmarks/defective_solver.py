# SPDX-License-Identifier: BSL-1.0
"""docs/examples/solver.py with a planted defect: it counts the restitution twice. Measures how soon the gate finds
it.

build/tests/benchmarks/first_violation 'exec:python3 tests/benchmarks/defective_solver.py'
"""
import pathlib

EXAMPLE = pathlib.Path(__file__).resolve().parents[2] / "docs" / "examples" / "solver.py"
RIGHT = '(1 + record["restitution"])'
WRONG = '(1 + 2 * record["restitution"])'

text = EXAMPLE.read_text(encoding="utf-8")
if RIGHT not in text:
    raise SystemExit(f"{EXAMPLE} no longer has {RIGHT}")
exec(compile(text.replace(RIGHT, WRONG), str(EXAMPLE), "exec"))
