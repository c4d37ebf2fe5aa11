#!/usr/bin/env python3
# SPDX-License-Identifier: BSL-1.0
"""components_test.py WORK SOURCE [COMPONENT…]: builds and installs each component, or only those named, in a separate
bare Debian that has only the packages of src/package/needs.txt. Then an outside project uses the component. The exit
status is 77 if this machine cannot make a bare Debian.
"""

import pathlib
import re
import sys
import time

from bare_debian import SKIPPED, BareDebian, Unavailable

# For each component: the arguments of cmake, and the programs of tests/consumer that must exit with 0.
USES = {
    "impulse": ("-DCOMPONENTS=impulse", ["/tmp/consumer/solve", "/tmp/consumer/batch"]),
    "judge": ("-DCOMPONENTS=judge", ["/tmp/consumer/judge"]),
    "report": ("-DCOMPONENTS=report", ["/tmp/consumer/report"]),
    "kit": ("-DCOMPONENTS=kit", ["env 'RC_PARAMS=seed=1 max_success=10' /tmp/consumer/my_test"]),
    "program": ("-DCOMPONENTS=program", ["/tmp/consumer/builtin", "carom gate frictionless-double --cases 5",
                                         "carom scene x 2>&1 | grep carom-scene"]),
    "scenes": ("-DCOMPONENTS=scenes", ["/tmp/consumer/scene", "carom scene /source/docs/examples/scenes/cradle.json"]),
    "proofs": (None, ["carom-proved </dev/null"]),
}


def needs(source, component):
    """The Debian packages of the component and of the components that it needs (src/cmake/components.cmake)."""
    packages = set()
    rows = (source / "src/cmake/components.cmake").read_text(encoding="utf-8")
    below = re.search(rf"set\(carom_{component}_needs (.*)\)", rows)
    for part in below[1].split() if below else []:
        packages |= needs(source, part)
    for line in (source / "src/package/needs.txt").read_text(encoding="utf-8").splitlines():
        name, *rest = line.split()
        packages |= set(rest) if name == component else set()
    return packages


def try_component(work, source, component):
    """The error as a text, or None."""
    debian = BareDebian(work / "base", work / component)
    debian.binds["/source"] = source
    arguments, programs = USES[component]
    commands = [
        f"apt-get update && apt-get install -y --no-install-recommends g++ cmake ninja-build {' '.join(sorted(needs(source, component)))}",
        f"cmake -S /source -B /tmp/build -G Ninja -DCAROM_COMPONENTS={component} -DCAROM_UNITY=ON && cmake --build /tmp/build",
        "cmake --install /tmp/build --prefix /usr",
    ]
    if arguments is not None:
        commands.append(f"cmake -S /source/tests/consumer -B /tmp/consumer -G Ninja -DCMAKE_BUILD_TYPE=Debug {arguments} "
                        "&& cmake --build /tmp/consumer")
    commands += programs
    log_file = work / f"{component}.log"
    try:
        for command in commands:
            began = time.monotonic()
            with open(log_file, "w", encoding="utf-8") as log:
                status = debian.run(["/bin/sh", "-ec", command], log=log)
            if status != 0:
                return f"{command}\nended in {status}\n" + log_file.read_text(encoding="utf-8", errors="replace")[-3000:]
            print(f"{component}: {time.monotonic() - began:6.1f} s  {command}", flush=True)
    finally:
        debian.remove()
    return ""


def main(work, source, components):
    unknown = set(components) - set(USES)
    if unknown:
        print(f"components_test: there is no component {', '.join(unknown)}; there are {', '.join(USES)}", file=sys.stderr)
        return 2
    failures = 0
    for component in components or USES:
        try:
            wrong = try_component(work, source, component)
        except Unavailable as why:
            print(f"components_test: skipped: {why}", file=sys.stderr)
            return SKIPPED
        if wrong:
            print(f"components_test: {component}: {wrong}", file=sys.stderr)
            failures += 1
    return 1 if failures else 0


if __name__ == "__main__":
    if len(sys.argv) < 3:
        sys.exit(__doc__)
    sys.exit(main(*(pathlib.Path(word).resolve() for word in sys.argv[1:3]), sys.argv[3:]))
