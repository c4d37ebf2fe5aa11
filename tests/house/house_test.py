#!/usr/bin/env python3
# SPDX-License-Identifier: BSL-1.0
"""Checks the rules of the source tree: house_test.py SOURCE [BUILD NINJA]. Prints one line for each offence.

With a build directory of Ninja, it also checks the licences of the headers of CGAL that were compiled. First, each
check must find the offences of PLANTED.
"""
import os
import pathlib
import re
import subprocess
import sys

# A folder or file may include the standard library, and names with these beginnings. `*` is everything, and `-` takes
# away. The longest place that fits a file applies. A name in quotes below src/tool counts as tool/NAME.
TOOL = "carom/ CLI/ libfccp/ fmt/ nlohmann/ pugixml benchmark/ boost/ Eigen/ nlopt unistd.h sys/ signal.h fcntl.h poll.h"
EXACT = "carom/collision/ carom/oracles/laws/ carom/oracles/exact/"
JUDGE = "carom/collision/ carom/oracles/"
KIT = "fmt/ Eigen/ gtest/ rapidcheck"
DRAW = "carom/collision/ carom/oracles/laws/kinematics.hpp carom/properties/draws/ fmt/ Eigen/"
MAY_INCLUDE = {place: names for place, *names in map(str.split, f"""
src/collision/              carom/collision/ Eigen/
src/collision/json/         carom/collision/ Eigen/ nlohmann/
src/impulse/                carom/collision/ carom/impulse/ Eigen/ experimental/simd
src/scene/                  carom/collision/ carom/impulse/ carom/scene/ Eigen/
src/scene/exact_time.cpp    carom/collision/ carom/scene/ CGAL/
src/scene/json/             carom/collision/ carom/scene/ Eigen/ nlohmann/
src/scene/polyhedra/        carom/collision/ carom/impulse/ carom/scene/ Eigen/ fcl/ gmpxx.h
src/subjects/               * -carom/oracles/ -carom/properties/ -carom/report/ -carom/tool/ -CGAL/
src/report/
src/report/pictures/        {JUDGE} carom/report/pictures/ carom/report/results/ fmt/ nlohmann/ pugixml Eigen/
src/report/results/         {JUDGE} carom/properties/ carom/report/results/ fmt/ nlohmann/
src/report/pages/           {JUDGE} carom/properties/ carom/report/ fmt/ nlohmann/ pugixml
src/tool/                   {TOOL} tool/io/ tool/commands/
src/tool/io/                {TOOL} tool/io/
src/tool/scene/             {TOOL} tool/io/ tool/scene/
src/tool/commands/          {TOOL} tool/
oracles/
oracles/laws/               carom/collision/ carom/oracles/laws/ Eigen/
oracles/exact/              {EXACT} Eigen/
oracles/exact/gmpq.hpp      {EXACT} CGAL/Gmpq.h
oracles/exact/radical.cpp   {EXACT} CGAL/Sqrt_extension.h
oracles/exact/roots.cpp     {EXACT} CGAL/Algebraic_kernel_d_1.h CGAL/Gmpz.h CGAL/Polynomial.h
oracles/bounds/             {EXACT} carom/oracles/bounds/ Eigen/
oracles/motion/             {EXACT} carom/oracles/bounds/ carom/oracles/motion/ Eigen/
oracles/truths/             {EXACT} carom/oracles/bounds/ carom/oracles/truths/ Eigen/
oracles/judge/              {JUDGE} Eigen/
properties/                 {JUDGE} carom/properties/ -carom/properties/scenes/ fmt/ Eigen/
properties/draws/           carom/collision/ carom/properties/draws/ Eigen/
properties/cases/           {DRAW} carom/oracles/exact/rational.hpp carom/properties/cases/ carom/properties/features/
properties/features/        {DRAW} carom/properties/features/
properties/kit/             {JUDGE} carom/properties/ carom/conformance.hpp carom/rapidcheck.hpp carom/impulse/contact.hpp {KIT}
properties/phenomena/       carom/collision/ carom/oracles/laws/kinematics.hpp carom/oracles/motion/ carom/properties/phenomena/ carom/properties/gate/by_name.hpp fmt/
properties/scenes/          {JUDGE} carom/properties/ carom/scene/ fmt/ Eigen/ boost/numeric/
""".strip().splitlines())}
MAY_INCLUDE[""] = ["*", "-carom/tool/", "-CGAL/"]
DRAWN = ("properties/cases/", "properties/cases/", "properties/features/")
# Exact; a value of a quantity, which is rounded to few bits; only printed
NOT_DRAWN = ("properties/cases/polyhedron.cpp", "properties/cases/draw_within.cpp", "properties/features/quantities.cpp")
# These start no process or thread, and touch no file.
INSIDE = ("oracles/", "properties/", "src/collision/", "src/impulse/", "src/report/")
OUTSIDE = {"csignal", "filesystem", "fstream", "future", "thread"}
TOP = {"CMakeLists.txt", "CMakePresets.json", "README.md", "docs", "oracles", "properties", "src", "tests"}
INCLUDE = re.compile(r'^[ \t]*#[ \t]*include[ \t]*([<"])([^>"\n]+)[>"]', re.M)


def includes(path, text):
    """Only code under src/tool and tests, which installs no header, names a file in quotes."""
    rule = MAY_INCLUDE[max((place for place in MAY_INCLUDE if path.startswith(place)), key=len)]
    for mark, spelt in INCLUDE.findall(text):
        tool = mark == '"' and path.startswith("src/tool/")
        name = "tool/" + spelt if tool else spelt
        permitted = any(one == "*" or name.startswith(one) for one in rule) or re.fullmatch("[a-z0-9_]+", name)
        forbidden = any(one[0] == "-" and name.startswith(one[1:]) for one in rule)
        if mark == '"' and not tool:
            permitted, forbidden = path.startswith("tests/"), False
        leaves = ".." in name or (name in OUTSIDE and path.startswith(INSIDE))
        leaves = leaves or (name.endswith("/gmpq.hpp") and not path.startswith("oracles/exact/"))  # it is not installed
        if leaves or forbidden or not permitted:
            yield f"{path}: includes {spelt}"


def cycles(texts):
    """The folders that include each other. <carom/NAME> means src/NAME or NAME."""
    below = {}
    for path, text in texts.items():
        folder = os.path.dirname(path)
        for _, spelt in INCLUDE.findall(text):
            name = spelt.removeprefix("carom/")
            roots = (folder + "/", "src/", "", "src/tool/", "tests/")
            target = next((root + name for root in roots if root + name in texts), path)
            below.setdefault(folder, set()).add(os.path.dirname(target))

    def reached(folder):
        found, left = set(), [folder]
        while left:
            new = below.get(left.pop(), set()) - found
            found |= new
            left += new
        return found

    above = {folder: reached(folder) for folder in below}
    for folder in sorted(below):
        if around := [one for one in above[folder] if one != folder and folder in above.get(one, ())]:
            yield f"{folder}: includes {', '.join(sorted(around))}, and is included by it"


def licence(path, text):
    comment = "//" if path.endswith("pp") else "#"
    lines = text.splitlines() + ["", ""]
    if lines[1 if lines[0].startswith("#!") else 0] != comment + " SPDX-License-Identifier: BSL-1.0":
        yield f"{path}: does not begin with the licence BSL-1.0"


def draws(path, text):
    """Every machine draws the same cases. C++ does not order the operands of a product or the arguments of a call, and
    Eigen orders the terms of a sum as it likes. Mathematical functions differ between libraries.
    """
    pair = (r"(stream\.\w+\([^()]*\)|\w+\(stream\b[^()]*\)|stream\.\w+\([^()]*\)[^;?{}()]*\})\)*\s*[-+*/,][^;?{}]*"
            r"(stream\.\w|\(stream\b)")
    operation = (r"\.(dot|norm|squaredNorm|stableNorm|lpNorm|normalized|normalize|sum|prod|mean|trace|cross|inverse"
                 r"|determinant|solve|partialPivLu|ldlt|llt)(<[^>]*>)?\(|\.(minCoeff|maxCoeff)\(&|std::(pow|exp|exp2"
                 r"|expm1|log|log2|log10|log1p|sin|cos|tan|asin|acos|atan|atan2|sinh|cosh|tanh|cbrt|hypot|erf|tgamma"
                 r"|lgamma)\b|[=(,?:{] ?-[a-z_.]*(normal|velocity|orientation|position|point)\b(?!\[)"
                 r"|oracles::(turned|relative_velocity|point_velocity|apply_inertia)")
    if path.startswith("properties/") and (found := re.search(pair, text)):
        yield f"{path}: two draws without an order: {found[0]}"
    if path.startswith(DRAWN) and path not in NOT_DRAWN and (found := re.search(operation, text)):
        yield f"{path}: the source does not determine the rounding of {found[0]}"


def without_code_blocks(text):
    return re.sub(r"^    .*$", "", re.sub(r"^```.*?^```.*?$", "", text, flags=re.M | re.S), flags=re.M)


def targets(text):
    found = re.findall(r'(?:\]\(|src(?:set)?=")([^()\s"]+)[)"]', re.sub("`[^`\n]*`", "", without_code_blocks(text)))
    return [one for one in found if "://" not in one and not one.startswith("mailto:")]


def links(top, page, text):
    for target in targets(text):
        name, _, anchor = target.partition("#")
        file = top / os.path.dirname(page) / name if name else top / page
        if not file.exists():
            yield f"{page}: {target} is not there"
        elif anchor and file.suffix == ".md":
            headings = re.findall(r"^#+ (.*)$", without_code_blocks(file.read_text()), re.M)
            if anchor not in {re.sub(r"[^\w-]", "", one.replace(" ", "-")).lower() for one in headings}:
                yield f"{page}: {target} is no heading"
    for path in re.findall(r"`((?:docs|oracles|properties|src|tests)/[\w./-]+)`", text):
        if not (top / path).exists() and not re.search("NAME|TARGET", path):
            yield f"{page}: there is no {path}"


def header_licences(build, ninja):
    """Code under BSL-1.0 includes headers of CGAL that are under the LGPL, and none that is under the GPL."""
    listing = subprocess.run([ninja, "-C", build, "-t", "deps"], capture_output=True, text=True, check=True).stdout
    headers = {build / line.strip() for line in listing.splitlines() if line[:1] == " " and "/CGAL/" in line}
    yield from [] if headers else ["Ninja knows no header of CGAL"]
    for header in sorted(headers):
        yield from gpl(str(header), header.read_text(errors="replace"))


def gpl(path, text):
    tags = re.findall(r"SPDX-License-Identifier:(.*)", text)
    if not tags or any(re.search(r"(?<![\w-])A?GPL", tag) for tag in tags):
        yield f"{path}: is not under the LGPL: {tags}"


# (check, path, text, whether the text is an offence)
PLANTED = [
    (includes, "src/impulse/contact.hpp", "  #  include   <CGAL/Gmpq.h>  // why", True),
    (includes, "oracles/truths/coulomb.cpp", "#include <carom/oracles/exact/gmpq.hpp>", True),
    (includes, "oracles/exact/radical.cpp", "#include <CGAL/Algebraic_kernel_d_1.h>", True),
    (includes, "oracles/flat.hpp", "#include <carom/oracles/laws/equations.hpp>", True),
    (includes, "properties/gate/gate.cpp", "#include <thread>", True),
    (includes, "properties/gate/gate.cpp", "#include <carom/properties/scenes/ledger.hpp>", True),
    (includes, "src/report/results/words.cpp", "#include <carom/report/pages/document.hpp>", True),
    (includes, "src/tool/io/progress.cpp", '#include "commands/clock.hpp"', True),
    (includes, "src/tool/main.cpp", '#include "../impulse/contact.hpp"', True),
    (includes, "tests/oracles/some_test.cpp", "#include <CGAL/Gmpq.h>", True),
    (includes, "src/tool/commands/clock.cpp", '#include "io/progress.hpp"\n// #include <CGAL/Gmpq.h>', False),
    (licence, "tests/x.sh", "#!/bin/sh\n# SPDX-License-Identifier: BSL-1.0\n", False),
    (licence, "oracles/x.cpp", "\n// SPDX-License-Identifier: BSL-1.0\n", True),
    (gpl, "Planted.h", "// SPDX-License-Identifier: (GPL-3.0-or-later OR LicenseRef-Commercial) AND MIT", True),
    (draws, "properties/x.cpp", "p = stream.vector() *\n    stream.unit();", True),
    (draws, "properties/x.cpp", "x = stream.chance(2) ? 1 : stream.unit();\nturn(stream, b);", False),
    (draws, "properties/cases/x.cpp", "y = std::pow(x, 3);", True),
    (draws, "properties/cases/x.cpp", "v = V(-c.normal);", True),
    (draws, "properties/cases/x.cpp", "w = cross(u, v); x = v.maxCoeff(); x = -c.normal[2]; y = std::sqrt(x);", False),
]


def planted(top):
    for check, path, text, is_offence in PLANTED:
        if bool(list(check(path, text))) != is_offence:
            yield f"the check {check.__name__} judges wrongly: {path}: {text}"
    around = {"src/a/a.hpp": "<carom/b/b.hpp>", "src/b/b.hpp": "<carom/c/x/c.hpp>", "c/x/c.hpp": "<carom/a/a.hpp>"}
    if len(list(cycles({path: "#include " + name for path, name in around.items()}))) != 3:
        yield "the check of cycles finds none"
    page = "[a](no.md) [b](#no) ![c](docs/README.md) `[d](no.md)` `src/no`\n    [e](no.md)"
    if len(list(links(top, "README.md", page))) != 3:
        yield "the check of links does not find three"


def main():
    top = pathlib.Path(sys.argv[1]).resolve()
    texts, pages = {}, {}
    for folder, folders, names in os.walk(top):
        skipped = (".", "build") if folder == str(top) else (".",)
        folders[:] = sorted(one for one in folders if not one.startswith(skipped) and one != "node_modules")
        for name in names:
            path = pathlib.Path(folder, name)
            if path.suffix in (".cpp", ".hpp", ".sh", ".cmake", ".py", ".md") or name == "CMakeLists.txt":
                kind = pages if path.suffix == ".md" else texts
                kind[str(path.relative_to(top))] = path.read_text(encoding="utf-8")
    offences = [*planted(top), *cycles(texts)]
    places = (*MAY_INCLUDE, *DRAWN, *NOT_DRAWN, *INSIDE)
    offences += [f"{place} is not there" for place in places if not (top / place).exists()]
    for path, text in sorted(texts.items()):
        offences += [*licence(path, text), *draws(path, text)]
        if path.endswith("pp"):
            offences += includes(path, text)
        if path.startswith("tests/") and path.endswith("CMakeLists.txt") and "install(" in text:
            offences.append(f"{path}: a test installs something")
    linked = ["README.md", *targets(pages["docs/README.md"])]
    index = {os.path.normpath("docs/" + one.partition("#")[0]) for one in linked}
    for page, text in sorted(pages.items()):
        offences += links(top, page, text)
        if page.startswith("docs/") and page not in index:
            offences.append(f"docs/README.md does not lead to {page}")
    with_law = [path for path, text in texts.items() if "case Law::any:" in text and not path.startswith("tests/")]
    offences += [f"adding-a-law.md does not name {path}" for path in with_law
                 if f"{os.path.basename(path)}`" not in pages["docs/internals/adding-a-law.md"]]
    names = {one.name for one in top.iterdir() if not one.name.startswith((".", "build"))}
    offences += [f"{one}: should be at the top, and nothing else" for one in sorted(names ^ TOP)]
    if len(sys.argv) > 3:
        offences += header_licences(pathlib.Path(sys.argv[2]), sys.argv[3])
    print("\n".join(offences) or f"{len(texts)} sources and {len(pages)} pages keep the rules")
    sys.exit(1 if offences else 0)


main()
