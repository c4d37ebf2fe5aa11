#!/usr/bin/env python3
# SPDX-License-Identifier: BSL-1.0
"""Draws the figures of pages that `carom chart` does not draw: figures.py CAROM OUT

`carom replay` computes the outcomes, and gnuplot draws."""

import csv
import json
import math
import pathlib
import subprocess
import sys

TOP = pathlib.Path(__file__).resolve().parents[2]
CAROM, OUT = sys.argv[1], pathlib.Path(sys.argv[2])
BLUE, GREEN, SKY, GREY, PURPLE, RED, BLACK = ("#0072b2", "#009e73", "#2b7fae", "#757575", "#a9508a", "#b84f00", "#000000")
DARK = "<style>@media (prefers-color-scheme: dark) { svg { filter: invert(0.93) hue-rotate(180deg) } }</style>\n"


def collision(velocity, **fields):
    """A ball of mass 1 hits a fixed plane through the origin."""
    still = {"position": [0, 0, 0], "velocity": [0, 0, 0], "angular_velocity": [0, 0, 0]}
    body = {"mass": 1, "principal_inertia": [1, 1, 1], "orientation": [1, 0, 0, 0], "position": [-1, 1, 0],
            "velocity": velocity, "angular_velocity": [0, 0, 0], **fields.pop("a", {})}
    return {"a": body, "b": {"immovable": True, **still}, "point": [0, 0, 0], "normal": [0, 1, 0], **fields}


def velocities(collisions, law):
    """The velocities of A after each collision under the law."""
    lines = "".join(json.dumps(each) + "\n" for each in collisions) + "\n"
    run = subprocess.run([CAROM, "replay", "/dev/stdin", "--format", "json"], input=lines, capture_output=True,
                         text=True, check=True)
    records = map(json.loads, run.stdout.splitlines())
    return [(each["answers"]["coulomb"][0] if law == "coulomb" else each["truth"][law])["nearest"]["a"]
            for each in records]


def draw(name, title, axes, ranges, curves, texts, commands=""):
    """A curve has points and a style of gnuplot, and a text has its place and its colour."""
    script = (f"set terminal svg size 900,620 dynamic noenhanced font 'Helvetica,16' background rgb 'white'\n"
              f"set output '{OUT / name}.svg'\nset encoding utf8\nset key off\nset tics nomirror\nset border 3\n"
              f"set grid lc rgb '#e4e4e4' lw 1\nset title \"{title}\"\nset xlabel \"{axes[0]}\"\n"
              f"set ylabel \"{axes[1]}\"\nset xrange [{ranges[0]}]\nset yrange [{ranges[1]}]\n{commands}\n")
    for text, x, y, colour in texts:
        script += f"set label \"{text}\" at {x},{y} front tc rgb '{colour}'\n"
    for number, (points, _) in enumerate(curves):
        script += f"$data{number} << END\n" + "".join(" ".join(map(str, each)) + "\n" for each in points) + "END\n"
    script += "plot " + ", ".join(f"$data{number} {style}" for number, (_, style) in enumerate(curves)) + "\n"
    subprocess.run(["gnuplot"], input=script, text=True, check=True)
    file = OUT / f"{name}.svg"
    drawn = file.read_text(encoding="utf-8")
    begin = drawn.index("<g ")
    file.write_text(drawn[:begin] + DARK + drawn[begin:], encoding="utf-8")


def line(colour, width=3, dash=1):
    return f"using 1:2 with lines lw {width} dt {dash} lc rgb '{colour}'"


def impulse_space():
    """The laws in impulse space (docs/guide/laws.md). The contact is planar, and K is (2, 1; 1, 2)."""
    def impulses(law, **each):
        count = len(next(iter(each.values())))
        settings = [dict({"restitution": 0.5, "friction": 1}, **{key: of[i] for key, of in each.items()})
                    for i in range(count)]
        return [(v["velocity"][0] - 3, v["velocity"][1] + 4)
                for v in velocities([collision([3, -4, 0], **one) for one in settings], law)]

    steps = [i / 16 for i in range(1, 17)]
    stops_approach, = impulses("frictionless", restitution=[0])
    stops_point, = impulses("sticking", restitution=[0])
    first, = impulses("frictionless", restitution=[0.5])
    paths = {"frictionless": impulses("frictionless", restitution=[0, 0.5]),
             "reflection": impulses("reflection", restitution=[0, 0.5]),
             "sticking": impulses("sticking", restitution=[0, 0.5]),
             "rough": [first, *impulses("rough", friction=[1])],
             "coulomb": [first, *impulses("coulomb", friction=steps)]}
    titles = {"frictionless": "along N, (1+ε) P_I", "reflection": "the tangential velocity is kept",
              "sticking": "P_II, and on by ε", "rough": "(1+ε) P_I, then along P_II − P_I",
              "coulomb": "as friction grows, until the point sticks"}
    for law, path in paths.items():
        answer = path[-1]
        curves = [([(-6, 6), (0, 0), (3, 3)], line(GREY, 2)), ([(-6, 6), (3, 1.5)], line(GREEN, 1.5, 2)),
                  ([(-6, 5), (3, 0.5)], line(SKY, 1.5, 2)), ([(0, 0), *path], line(RED)),
                  ([stops_approach, stops_point], f"using 1:2 with points pt 7 ps 0.9 lc rgb '{BLACK}'"),
                  ([answer], f"using 1:2 with points pt 7 ps 1.3 lc rgb '{RED}'")]
        texts = [("cone, μ = 1", 1.9, 3.4, GREY), ("N·V⁺ = −ε N·V⁻", -5.9, 6.4, GREEN), ("N·V⁺ = 0", -5.9, 4.4, SKY),
                 ("P_I", stops_approach[0] + 0.15, stops_approach[1] - 0.2, BLACK),
                 ("P_II", stops_point[0] + 0.15, stops_point[1] + 0.2, BLACK),
                 ("F", answer[0] + 0.2, answer[1] + 0.3, RED)]
        if law in ("rough", "coulomb"):
            on_cone, = impulses(law, friction=[0.5])
            curves += [([(-3.5, 7), (0, 0), (3, 6)], line(PURPLE, 1.5, 3)),
                       ([on_cone], f"using 1:2 with points pt 7 ps 0.9 lc rgb '{PURPLE}'")]
            texts += [("cone, μ = 1/2", 1.1, 6.3, PURPLE), ("F at μ = 1/2", on_cone[0] + 0.2, on_cone[1] + 0.3, PURPLE)]
        draw(f"impulse-space-{law}", f"{law}: {titles[law]}",
             ("tangential component of F [N s]", "normal component of F [N s]"), ("-6:3", "-0.5:7"), curves, texts)


def oblique_impact():
    """Measured rebound angles compared with the laws (docs/findings/impacts.md). Prints the table of the page.

    A 5 mm sphere of aluminium oxide at 3.9 m/s, ε = 0.98, μ = 0.092. The angles do not depend on its mass."""
    radius = 0.0025

    def rebounds(angles, law, tangential=0.0):
        sphere = {"principal_inertia": [radius * radius * 2 / 5] * 3, "position": [0, radius, 0]}
        after = velocities([collision([3.9 * math.sin(math.radians(x)), -3.9 * math.cos(math.radians(x)), 0], a=sphere,
                                      restitution=0.98, friction=0.092, tangential_restitution=tangential)
                            for x in angles], law)
        return [math.degrees(math.atan2(v["velocity"][0] + radius * v["angular_velocity"][2], v["velocity"][1]))
                for v in after]

    with open(TOP / "docs/findings/data/oblique_impact.csv", encoding="utf-8") as file:
        rows = [row for row in csv.reader(file) if row and not row[0].startswith(("#", "incidence"))]
    measured = [(float(x), float(y)) for x, y in rows]
    angles = [x for x, _ in measured]
    print("| incidence | measured | rough, e_t = 0.34 | rough, e_t = 0 | coulomb |\n| ---: | ---: | ---: | ---: | ---: |")
    for row in zip(angles, [y for _, y in measured], rebounds(angles, "rough", 0.34), rebounds(angles, "rough"),
                   rebounds(angles, "coulomb")):
        print("| " + " | ".join(f"{angle:.1f}°" for angle in row) + " |")
    for tangential in (0.34, 0):
        most = max(abs(x - y) for x, (_, y) in zip(rebounds(angles, "rough", tangential), measured))
        print(f"largest difference with e_t = {tangential}: {most:.2f}°")
    shown = [x / 2 for x in range(1, 180)]
    curves = [(list(zip(shown, rebounds(shown, "rough", each))), line(colour))
              for each, colour in ((-1, GREY), (0, BLUE), (0.34, RED))]
    draw("oblique-impact", "A 5 mm sphere of aluminium oxide on glass at 3.9 m/s: ε = 0.98, μ = 0.092",
         ("angle of incidence of the contact patch [degrees]", "angle of its rebound [degrees]"), ("0:90", "-20:90"),
         curves + [(measured, f"using 1:2:(1) with yerrorbars pt 7 ps 0.8 lw 1.5 lc rgb '{BLACK}'")],
         [("rough, e_t = −1: no friction", 13, 49, GREY), ("rough, e_t = 0, which is coulomb here", 36, -1, BLUE),
          ("rough, e_t = 0.34", 28, -10, RED), ("measured, ± 1° (Gorham, Kharaz 2000)", 43, 10, BLACK)])


def scene_events():
    """Events per second by the number of spheres (docs/internals/performance.md), which tests/benchmarks measures."""
    with open(TOP / "docs/charts/scene-events.csv", encoding="utf-8") as file:
        rows = [[float(number) for number in row] for row in list(csv.reader(file))[1:]]
    points = [(row[0], *(number / 1000 for number in row[1:4])) for row in rows]
    most = max(row[3] for row in points)
    draw("scene-events", "A gas of elastic spheres at volume fraction 0.2",
         ("number of spheres", "events a second of a core [thousands]"), ("80:160000", f"0:{1.1 * most}"),
         [(points, line(BLUE)), (points, f"using 1:2:3:4 with yerrorbars pt 7 ps 0.8 lw 1.5 lc rgb '{BLUE}'")],
         [("median of the rounds, their least and most", 200, 0.4 * most, BLUE)], "set logscale x")


if __name__ == "__main__":
    OUT.mkdir(parents=True, exist_ok=True)
    impulse_space()
    oblique_impact()
    scene_events()
