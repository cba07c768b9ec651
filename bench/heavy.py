#!/usr/bin/env python3
"""The heaviest small files: families of mechanisms that grow, up to 40 kB, through every command.

heavy.py [PROGRAM] prints, as Markdown, for every family and command the processor time and the memory of the size that
takes the most: a family is measured at several sizes, since a large one may be refused while a smaller one is solved.
Status 1 where one takes more than 3 s of processor time or 300 MB.
"""

import json
import math
import os
import pathlib
import resource
import subprocess
import sys
import tempfile

MOST_BYTES, MOST_SECONDS, MOST_MEGABYTES = 40_000, 3, 300
GIVE_UP = 20  # seconds


def zigzag(n):
    return {f"P{i}": [round(1.1 * i + 0.3 * math.sin(7 * i), 3), round(math.sin(3 * i), 3)] for i in range(n + 1)}


def pin(at, *bodies):
    return {"revolute": at, "bodies": list(bodies)}


def open_chain(n):
    """A robot of n links, a driver at each."""
    return {
        "points": zigzag(n),
        "bodies": {str(i): [f"P{i - 1}", f"P{i}"] for i in range(1, n + 1)},
        "joints": [pin(f"P{i - 1}", str(i - 1), str(i)) for i in range(1, n + 1)],
        "drivers": [{"body": str(i), "omega": 1} for i in range(1, n + 1)],
    }


def star(n):
    """n cranks about one pin."""
    return {
        "points": {"O": [0, 0]} | {f"E{i}": [round(5 * math.cos(i), 3), round(5 * math.sin(i), 3)] for i in range(n)},
        "bodies": {f"c{i}": ["O", f"E{i}"] for i in range(n)},
        "joints": [pin("O", "0", *(f"c{i}" for i in range(n)))],
        "drivers": [{"body": f"c{i}", "omega": i + 1} for i in range(n)],
    }


def ladder(n):
    """n parallelograms side by side, driven by the first crank."""
    return {
        "points": {f"A{i}": [2 * i, 0] for i in range(n + 1)} | {f"B{i}": [2 * i + 0.7, 1.9] for i in range(n + 1)},
        "bodies": {f"k{i}": [f"A{i}", f"B{i}"] for i in range(n + 1)}
        | {f"c{i}": [f"B{i}", f"B{i + 1}"] for i in range(n)},
        "joints": [pin(f"A{i}", "0", f"k{i}") for i in range(n + 1)]
        + [pin(f"B{i}", f"k{i}", *(f"c{j}" for j in (i - 1, i) if 0 <= j < n)) for i in range(n + 1)],
        "drivers": [{"body": "k0", "omega": 1}],
    }


def four_bars(n):
    """n four-bars in series, the rocker of each the crank of the next."""
    points, bodies, joints = {"O0": [0, 0], "A0": [0.3, 1]}, {"k0": ["O0", "A0"]}, [pin("O0", "0", "k0")]
    for i in range(1, n + 1):
        points |= {f"O{i}": [3 * i, 0.1 * (i % 3)], f"A{i}": [round(3 * i + 0.4 + 0.1 * math.sin(i), 3), 1.5]}
        bodies |= {f"c{i}": [f"A{i - 1}", f"A{i}"], f"k{i}": [f"O{i}", f"A{i}"]}
        joints += [pin(f"O{i}", "0", f"k{i}"), pin(f"A{i - 1}", f"k{i - 1}", f"c{i}"), pin(f"A{i}", f"c{i}", f"k{i}")]
    return {"points": points, "bodies": bodies, "joints": joints, "drivers": [{"body": "k0", "omega": 1}]}


def loaded_four_bars(n):
    """The same with a weight on every body and an unknown moment on the first crank."""
    file = four_bars(n)
    loads = [
        {"force": f"W{body}", "body": body, "at": pins[1], "value": [0, -10]} for body, pins in file["bodies"].items()
    ]
    find = ["velocity", "acceleration", "forces"]
    return file | {"loads": loads, "effort": {"couple": "M", "body": "k0"}, "find": find}


def scissors(n):
    points = {f"{side}{i}": [x, 300 * i] for side, x in (("L", 0), ("R", 400)) for i in range(n + 1)}
    points |= {f"M{i}": [200, 300 * i + 150] for i in range(n)}
    bodies, joints = {}, []
    for i in range(n):
        bodies |= {f"a{i}": [f"L{i}", f"M{i}", f"R{i + 1}"], f"b{i}": [f"R{i}", f"M{i}", f"L{i + 1}"]}
        joints.append(pin(f"M{i}", f"a{i}", f"b{i}"))
        if i > 0:
            joints += [pin(f"L{i}", f"b{i - 1}", f"a{i}"), pin(f"R{i}", f"a{i - 1}", f"b{i}")]
    joints += [pin("L0", "0", "a0"), {"pin-slot": "R0", "bodies": ["b0", "0"], "along": 0}]
    loads = [{"force": "W", "body": f"b{n - 1}", "at": f"L{n}", "value": [0, -500]}]
    return {
        "units": {"length": "mm", "velocity": "mm/s"},
        "points": points,
        "bodies": bodies,
        "joints": joints,
        "drivers": [{"joint": "R0", "speed": -10}],
        "loads": loads,
        "effort": {"force": "P", "body": "b0", "at": "R0", "along": 180},
        "find": ["velocity", "acceleration", "forces"],
    }


def truss(n):
    """A parallel-chord truss of n panels under a load at each lower node."""
    points = {f"A{i}": [4 * i, 0] for i in range(n + 1)} | {f"B{i}": [4 * i, 3] for i in range(n + 1)}
    bars = [(f"A{i}", f"B{i}") for i in range(n + 1)]
    for i in range(n):
        bars += [(f"A{i}", f"A{i + 1}"), (f"B{i}", f"B{i + 1}"), (f"A{i}", f"B{i + 1}")]
    bodies = {str(i + 2): list(bar) for i, bar in enumerate(bars)}
    at = {node: [name for name, bar in bodies.items() if node in bar] for node in points}
    joints = [pin(node, *(["1"] if node == "A0" else []), *names) for node, names in at.items()]
    joints.append({"contact": f"A{n}", "bodies": [at[f"A{n}"][0], "1"], "tangent": [1, 0], "pushes": [0, 1]})
    loads = [{"force": f"F{i}", "pin": f"A{i}", "value": [0, -1 - i % 3]} for i in range(1, n)]
    return {"frame": 1, "points": points, "bodies": bodies, "joints": joints, "loads": loads, "find": ["forces"]}


def loads_on_one(n):
    """One body under n loads that lean each its own way."""
    points = {"O": [0, 0], "R": [10, 0]} | {f"L{i}": [round(10 * (i + 1) / (n + 1), 3), 0] for i in range(n)}
    return {
        "points": points,
        "bodies": {"2": ["O", "R"]},
        "joints": [pin("O", "0", "2"), {"contact": "R", "bodies": ["2", "0"], "tangent": [1, 0]}],
        "loads": [{"force": f"F{i}", "body": "2", "at": f"L{i}", "value": [i % 7 - 3, -1 - i % 5]} for i in range(n)],
        "find": ["forces"],
    }


def coupler_points(n):
    """A four-bar with n points on its coupler, whose velocities and accelerations are all asked for."""
    extra = {f"p{i}": [round(1 + 0.01 * i, 3), round(2 + 0.37 * i % 2, 3)] for i in range(n)}
    return {
        "points": {"O": [0, 0], "A": [1, 2], "B": [5, 3], "Q": [6, 0]} | extra,
        "bodies": {"2": ["O", "A"], "3": ["A", "B", *extra], "4": ["Q", "B"]},
        "joints": [pin("O", "0", "2"), pin("A", "2", "3"), pin("B", "3", "4"), pin("Q", "0", "4")],
        "drivers": [{"body": "2", "omega": 1, "alpha": 1}],
    }


def relative_motions(n):
    file = coupler_points(n)
    asked = [{"relative motion": f"p{i}", "observer": "2"} for i in range(n)]
    return file | {"find": ["velocity", "acceleration", *asked]}


def driver_laws(n):
    """A five-bar whose cranks turn by laws of n pieces."""
    file = {
        "points": {"O": [0, 0], "A": [-1, 2], "C": [1.5, 4], "B": [4, 2], "Q": [3, 0]},
        "bodies": {"2": ["O", "A"], "3": ["A", "C"], "4": ["C", "B"], "5": ["Q", "B"]},
        "joints": [pin("O", "0", "2"), pin("A", "2", "3"), pin("C", "3", "4"), pin("B", "4", "5"), pin("Q", "0", "5")],
    }
    forms = ("cycloidal", "3-4-5", "harmonic")
    pieces = [{"form": forms[i % 3], "turn": 2 * (-1) ** i, "time": 0.1} for i in range(n)]
    return file | {"drivers": [{"body": body, "law": pieces, "drawn at": 0.03} for body in ("2", "5")]}


def cam_laws(n):
    law = [{"form": "cycloidal", "rise": 0.01 * (-1) ** i, "turn": round(360 / n, 9)} for i in range(n - 1)]
    rest = {"form": "dwell", "turn": round(360 - sum(piece["turn"] for piece in law), 9)}
    follower = {"moves": "translating", "face": "roller", "radius": 0.1}
    return {"cam": {"omega": "120 rpm", "base radius": 1, "follower": follower, "law": [*law, rest]}}


def many_parameters(n):
    file = coupler_points(1)
    parameters = {"q0": 1} | {f"q{i}": f"= q{i - 1} + {i % 7}/1000" for i in range(1, n)}
    return file | {"parameters": parameters, "drivers": [{"body": "2", "omega": f"= q{n - 1}"}]}


def long_numbers(n):
    file = {"kinegraph": 1} | coupler_points(1)
    file["points"]["A"] = [1, "long"]
    return json.dumps(file).replace('"long"', "2." + "3" * n)


FAMILIES = {
    family.__name__.replace("_", " "): family
    for family in (open_chain, star, ladder, four_bars, loaded_four_bars, scissors, truss, loads_on_one, coupler_points,
                   relative_motions, driver_laws, cam_laws, many_parameters, long_numbers)
}
COMMANDS = {
    "solve, svg": ["solve", "{file}", "-o", "out.svg"],
    "solve, pdf": ["solve", "{file}", "-o", "out.pdf"],
    "solve, html": ["solve", "{file}", "-o", "out.html"],
    "solve, json": ["solve", "{file}", "-o", "out.json"],
    "solve, brief": ["solve", "{file}", "--detail", "brief", "-o", "out.svg"],
    "solve, steps": ["solve", "{file}", "--steps", "-o", "out.pdf"],
    "sweep, csv": ["sweep", "{file}", "-o", "out.csv"],
    "sweep, svg": ["sweep", "{file}", "-o", "out.svg"],
    "check": ["check", "{file}"],
    "pairs": ["pairs", "{file}"],
    "equations": ["equations", "{file}", "-o", "out.svg"],
    "cam": ["cam", "{file}", "-o", "out.svg"],
}


def text_of(family, n):
    made = family(n)
    return made if isinstance(made, str) else json.dumps({"kinegraph": 1} | made, separators=(",", ":"))


def sizes(family):
    """Up to 40 kB: the largest, and smaller ones, each two thirds of the one before."""
    n = 2
    while n < 40_000 and len(text_of(family, 2 * n)) <= MOST_BYTES:
        n *= 2
    while n < 40_000 and len(text_of(family, n + max(1, n // 16))) <= MOST_BYTES:
        n += max(1, n // 16)
    while n >= 4:
        yield n
        n = 2 * n // 3


def measured(program, command, file, folder):
    """Processor seconds, megabytes, status."""
    process = subprocess.Popen(
        [program, *(word.format(file=file) for word in command)],
        cwd=folder,
        stdin=subprocess.DEVNULL,
        stdout=subprocess.DEVNULL,
        stderr=subprocess.PIPE,
        preexec_fn=lambda: resource.setrlimit(resource.RLIMIT_CPU, (GIVE_UP, GIVE_UP)),
    )
    message = process.stderr.read().decode(errors="replace")
    _, status, usage = os.wait4(process.pid, 0)
    process.returncode = os.waitstatus_to_exitcode(status)
    return usage.ru_utime + usage.ru_stime, usage.ru_maxrss / 1024, process.returncode, message.split("\n")[0]


def main():
    top = pathlib.Path(__file__).resolve().parent.parent
    program = str(pathlib.Path(sys.argv[1] if len(sys.argv) > 1 else top / "build/kinegraph").resolve())
    wanted = sys.argv[2:]
    beyond = 0
    print("| file | command | size | processor time | memory | status |\n| --- | --- | --- | --- | --- | --- |")
    with tempfile.TemporaryDirectory() as folder:
        file = pathlib.Path(folder) / "in.json"
        for name, family in FAMILIES.items():
            if wanted and name not in wanted:
                continue
            for title, command in COMMANDS.items():
                worst = (-1, 0, 0, 0, "")
                for n in sizes(family):
                    file.write_text(text_of(family, n))
                    seconds, megabytes, status, message = measured(program, command, file, folder)
                    if status < 0 or status == 70:
                        print(f"status {status}: {name} of {n}, {title}: {message}", file=sys.stderr)
                    worst = max(worst, (seconds, megabytes, n, status, message))
                    if seconds < 0.05 and status == 0 or seconds > GIVE_UP / 2:
                        break
                seconds, megabytes, n, status, message = worst
                too_much = seconds > MOST_SECONDS or megabytes > MOST_MEGABYTES
                beyond += too_much
                if too_much or seconds > 0.5 or "all" in os.environ.get("ROWS", ""):
                    mark = " **!**" if too_much else ""
                    print(f"| {name} | {title} | {n} | {seconds:.2f} s{mark} | {megabytes:.0f} MB | {status} |", flush=True)
    return 1 if beyond else 0


if __name__ == "__main__":
    sys.exit(main())
