# SPDX-License-Identifier: BSL-1.0
"""package_test.py FOLDER-OF-PACKAGES WORK SOURCE: installs the packages into a bare Debian, and uses them. The exit
status is 77 if this machine cannot make a bare Debian.
"""

import pathlib
import sys
import time

from bare_debian import SKIPPED, BareDebian, Unavailable

EXAMPLE = "/usr/share/carom/examples/solver.py"
PAGES = "/usr/share/doc/carom"


class Failure(Exception):
    """The test's result is not as expected."""


class System:
    """A bare Debian that checks the exit status and the output of each command."""

    def __init__(self, work, packages):
        self.log_file = work / "log"
        self.debian = BareDebian(work / "base", work / "root")
        self.debian.binds["/packages"] = packages

    def expect(self, command, *texts, status=0):
        """Runs a line of shell. The output must contain all texts."""
        began = time.monotonic()
        with open(self.log_file, "w", encoding="utf-8") as log:
            ended = self.debian.run(["/bin/sh", "-ec", command], log=log)
        output = self.log_file.read_text(encoding="utf-8", errors="replace")
        missing = [text for text in texts if text not in output]
        if ended != status or missing:
            raise Failure(f"{command}\nended in {ended}, not {status}; not in its output: {missing}\n{output[-4000:]}")
        print(f"{time.monotonic() - began:6.1f} s  {command}", flush=True)


def check_program(system):
    system.expect("apt-get update && apt-get install -y --no-install-recommends /packages/carom_*.deb")
    system.expect("carom --version", "0.1.0")
    system.expect("ldd /usr/bin/carom | grep -c 'not found'", status=1)
    system.expect("carom gate frictionless-double --cases 50", "sound")
    # The output names what an engine lacks, and the command that installs it.
    system.expect("carom gate --engines --cases 2 --families generic || test $? -lt 3", "bullet-double", "bullet-float ",
                  "jolt-physics is not installed: npm ci --prefix /usr/share/carom/npm")
    system.expect("su nobody -s /bin/sh -c 'carom subjects'",
                  "is not installed: cp -r /usr/share/carom/npm ~/carom-engines && npm ci --prefix ~/carom-engines && "
                  "export CAROM_ENGINES=~/carom-engines")
    system.expect("apt-get install -y --no-install-recommends gnuplot-nox python3")
    system.expect("carom scene x", "carom-scene is not in the directory of this program", status=2)
    system.expect("apt-get install -y --no-install-recommends /packages/carom-scene_*.deb")
    system.expect("carom scene /usr/share/carom/examples/scenes/cradle.json --out /tmp/scene && ls /tmp/scene", "report.html")
    system.expect("carom gate frictionless-double --cases 5 --out /tmp/report && test -s /tmp/report/report.json", "sound")
    system.expect(f"carom gate 'exec:python3 {EXAMPLE}' --cases 50", "sound")
    # The links of the pages work, except for those to the sources.
    system.expect(f"test -e {PAGES}/docs/examples/solver.py && test -e {PAGES}/docs/reference/schemas/report.schema.json")
    for page in ("README.md", "copyright", "licences/BSL-1.0.txt", "licences/README.md", "docs/guide/ci.md"):
        system.expect(f"test -s {PAGES}/{page}")
    system.expect("apt-get purge -y carom carom-scene && ! find / -xdev -path /packages -prune -o -name '*carom*' -print | grep /usr", status=0)


def check_libraries(system):
    system.expect("apt-get install -y --no-install-recommends /packages/libcarom-*-dev_*.deb g++ cmake ninja-build")
    system.expect("cmake -S /source/tests/consumer -B /tmp/consumer -G Ninja -DCMAKE_BUILD_TYPE=Debug && cmake --build /tmp/consumer")
    for program in ("solve", "batch", "judge", "report", "builtin", "scene"):
        system.expect(f"/tmp/consumer/{program}")


def main(packages, work, source):
    if not list(packages.glob("carom_*.deb")):
        print(f"package_test: there is no package in {packages}; `bash src/bootstrap.sh package` writes them", file=sys.stderr)
        return 2
    try:
        system = System(work, packages)
    except Unavailable as why:
        print(f"package_test: skipped: {why}", file=sys.stderr)
        return SKIPPED
    try:
        check_program(system)
        system.debian.binds["/source"] = source
        check_libraries(system)
    except Failure as failure:
        print(f"package_test: {failure}", file=sys.stderr)
        return 1
    finally:
        system.debian.remove()
    print("package_test: the packages install into a bare Debian 12, and do what they should")
    return 0


if __name__ == "__main__":
    if len(sys.argv) != 4:
        sys.exit(__doc__)
    sys.exit(main(*(pathlib.Path(word).resolve() for word in sys.argv[1:])))
