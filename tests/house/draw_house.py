#!/usr/bin/env python3
# SPDX-License-Identifier: BSL-1.0
"""draw_house.py SOURCE [--check]: draws docs/internals/house.svg, the folders of the sources and the includes between
them. With --check it only ends with status 1 if the picture is out of date."""

import pathlib
import re
import sys

# The colour of each part, and the middle of its column.
PARTS = {"src/collision": ("#dfe8f5", 450), "src/impulse": ("#d5ead7", 235), "src/scene": ("#fbe6c4", 80),
         "oracles": ("#f2d9e6", 450), "properties": ("#e2daf4", 760), "src/report": ("#cfe9ea", 1010),
         "src/subjects": ("#eae6cf", 1210), "src/web": ("#f5dcd2", 1060), "src/tool": ("#e2e2e2", 760)}
WIDTH, BOX, HEIGHT, ROW = 1370, 140, 44, 76
INCLUDE = re.compile(r'^#include (?:<carom/([\w/]+)\.hpp>|"([\w/]+)\.hpp")', re.M)


def part_of(folder):
    return next(part for part in PARTS if folder == part or folder.startswith(part + "/"))


def included_folders(source):
    """Each folder, and the folders whose headers its files include."""
    files = [path for top in ("src", "oracles", "properties") for path in (source / top).rglob("*.?pp")
             if "node_modules" not in path.parts]
    folders = {str(path.parent.relative_to(source)) for path in files} - {"properties", "src/tool"}
    below = {folder: set() for folder in folders}
    for path in files:
        folder = str(path.parent.relative_to(source))
        for angled, quoted in INCLUDE.findall(path.read_text(encoding="utf-8")):
            name = angled or "tool/" + quoted
            found = next((f for f in (str(pathlib.PurePath(name).parent), "src/" + str(pathlib.PurePath(name).parent))
                          if f in folders), None)
            if folder in folders and found and found != folder:
                below[folder].add(found)
    return below


def reached(below, folder):
    """All folders that a folder includes, directly or through other folders."""
    found, left = set(), list(below[folder])
    while left:
        one = left.pop()
        if one not in found:
            found.add(one)
            left += below[one]
    return found


def rows_of(below):
    """The folders in rows. Each folder is above all folders that it includes."""
    heights = {}

    def height(folder):
        if folder not in heights:
            heights[folder] = 1 + max((height(one) for one in below[folder]), default=-1)
        return heights[folder]

    rows = {}
    for folder in sorted(below, key=lambda one: (list(PARTS).index(part_of(one)), one)):
        rows.setdefault(height(folder), []).append(folder)
    return [rows[key] for key in sorted(rows, reverse=True)]


def drawn(below):
    rows = rows_of(below)
    place = {}
    for y, row in enumerate(rows):
        for folder in row:
            beside = [one for one in row if PARTS[part_of(one)][1] == PARTS[part_of(folder)][1]]
            shift = (beside.index(folder) - (len(beside) - 1) / 2) * (BOX + 6)
            place[folder] = (PARTS[part_of(folder)][1] + shift, 20 + ROW * y)
    height = 20 + ROW * len(rows)
    lines, boxes = [], []
    for folder, names in sorted(below.items()):
        x, y = place[folder]
        for one in sorted(names):
            if any(one in reached(below, other) for other in names - {one}):
                continue  # another arrow leads there already
            to_x, to_y = place[one]
            lines.append(f'<path d="M{x:.0f} {y + HEIGHT}C{x:.0f} {y + HEIGHT + 26} {to_x:.0f} {to_y - 26} {to_x:.0f} {to_y}"/>')
        boxes.append(f'<rect x="{x - BOX / 2:.0f}" y="{y}" width="{BOX}" height="{HEIGHT}" rx="5" fill="{PARTS[part_of(folder)][0]}"/>')
        words = folder.removeprefix("src/").split("/")
        words = words[:1] + words[1:][-1:]  # the part and the folder
        for i, word in enumerate(words):
            boxes.append(f'<text x="{x:.0f}" y="{y + 28 + 18 * i - 9 * (len(words) - 1)}">{word}</text>')
    return "\n".join([f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {WIDTH} {height}" font-family="sans-serif" '
                      'font-size="16" text-anchor="middle">',
                      "<style>@media (prefers-color-scheme: dark) { svg { filter: invert(0.93) hue-rotate(180deg) } }</style>",
                      "<title>The folders of the sources: each includes headers of those that its lines lead down to</title>",
                      f'<rect width="{WIDTH}" height="{height}" fill="#ffffff"/>',
                      '<g fill="none" stroke="#7a8793" stroke-width="1.2">', *lines, "</g>",
                      '<g stroke="#5b6670" stroke-width="0">', *boxes, "</g>", "</svg>", ""])


def main():
    source = pathlib.Path(sys.argv[1])
    picture = source / "docs/internals/house.svg"
    new = drawn(included_folders(source))
    if sys.argv[2:] != ["--check"]:
        picture.write_text(new, encoding="utf-8")
    elif picture.read_text(encoding="utf-8") != new:
        sys.exit(f"{picture} is not of these sources: python3 tests/house/draw_house.py . draws it")


main()
