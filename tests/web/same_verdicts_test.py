# SPDX-License-Identifier: BSL-1.0
"""The judge in WebAssembly gives the verdicts of the native judge: same_verdicts_test.py RECORD REPLAY_JS CASES

RECORD judges the built-in solvers and all mutants on cases of every family, and records their answers. REPLAY_JS judges
the recorded answers in WebAssembly. Both judges must ask the same questions. Statuses, counts and witnesses must be
equal, and figures must agree to three digits. The exit status is 77 if REPLAY_JS does not exist.
"""
import json
import pathlib
import subprocess
import sys
import tempfile

FIGURES = {"worst", "residual", "allowed", "digits"}


def lines_of(command):
    output = subprocess.run(command, check=True, stdout=subprocess.PIPE, text=True).stdout
    return [json.loads(line) for line in output.splitlines()]


def agree_to_three_digits(x, y):
    # Both are rounded to three digits, so equal figures may differ by one unit of the third digit: at most 1 %.
    x, y = float(x), float(y)
    return x == y or abs(x - y) <= 0.0101 * max(abs(x), abs(y))


def differences(native, wasm, place):
    if isinstance(native, dict) and isinstance(wasm, dict):
        for name in sorted(native.keys() | wasm.keys()):
            if name not in native or name not in wasm:
                yield f"{place}/{name}: only in {'native' if name in native else 'WebAssembly'}"
            elif name in FIGURES:
                if not agree_to_three_digits(native[name], wasm[name]):
                    yield f"{place}/{name}: {native[name]} natively, {wasm[name]} in WebAssembly"
            else:
                yield from differences(native[name], wasm[name], f"{place}/{name}")
    elif native != wasm:
        yield f"{place}: {native} natively, {wasm} in WebAssembly"


def main(record, replay, cases):
    if not pathlib.Path(replay).exists():
        print(f"{replay} does not exist: bash src/bootstrap.sh wasm")
        return 77
    with tempfile.TemporaryDirectory() as folder:
        answers = f"{folder}/answers"
        natively = lines_of([record, answers, cases])
        in_wasm = lines_of(["node", "--no-experimental-fetch", replay, answers, cases])
    assert len(natively) > 100, f"only {len(natively)} subjects"
    assert any(not one["sound"] for one in natively) and any(one["sound"] for one in natively)
    wrong = [f"{len(natively)} subjects natively, {len(in_wasm)} in WebAssembly"] if len(natively) != len(in_wasm) else []
    for one, other in zip(natively, in_wasm):
        wrong += differences(one, other, one["subject"])
    witnesses = sum(len(one["witnesses"]) for one in natively)
    print(f"{len(natively)} subjects, {witnesses} witnesses, {len(wrong)} differences")
    for line in wrong[:40]:
        print(line)
    return 1 if wrong else 0


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]))
