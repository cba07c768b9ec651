"""Sweeps and cams as arrays: the numbers of the program's CSV."""

import csv
import io
import math
import subprocess
import sys

import numpy
import pandas
import pytest

import conftest
import kinegraph


def columns_of(text: str) -> dict[str, list[str]]:
    rows = list(csv.reader(io.StringIO(text)))
    return {name: [row[place] for row in rows[1:]] for place, name in enumerate(rows[0])}


@pytest.mark.parametrize("name", ["four_bar", "quick_return", "engine_inertia_gas", "sluice_gate_travel"])
def test_columns_are_the_programs(examples, program, name):
    theirs = columns_of(program("sweep", examples / f"{name}.json", "--steps", "72").decode())
    sweep = kinegraph.load(examples / f"{name}.json").sweep(steps=72)
    assert len(theirs) == len(sweep.names) > 10
    for written, ours in zip(theirs, sweep.names):
        cells = numpy.array([float(cell) if cell else math.nan for cell in theirs[written]])
        assert written.startswith(ours)
        assert numpy.allclose(sweep[ours], cells, rtol=1e-9, atol=1e-12, equal_nan=True), written
    assert sweep.csv() == program("sweep", examples / f"{name}.json", "--steps", "72").decode()


def test_angular_velocity_is_the_derivative_of_the_angle(examples):
    sweep = kinegraph.load(examples / "four_bar.json").sweep(steps=3600)
    ratio = numpy.gradient(numpy.unwrap(sweep["angle 4"]), sweep["turn"])
    # Central differences are off by the step squared times the third derivative over six.
    assert numpy.allclose(ratio[1:-1], (sweep["omega 4 / omega 2"])[1:-1], atol=1e-5)


def test_expressions_and_frames(examples):
    sweep = kinegraph.load(examples / "four_bar.json").sweep(steps=36)
    assert numpy.allclose(sweep["omega 4 / omega 2"], sweep["omega 4"] / sweep["omega 2"])
    frame = sweep.to_frame()
    assert isinstance(frame, pandas.DataFrame) and list(frame.columns) == sweep.names
    assert frame.attrs["units"]["omega 4"] == "rad/s"
    assert (frame["omega 4"].to_numpy() == sweep["omega 4"]).all()
    with pytest.raises(ValueError):
        sweep["omega 4"][0] = 0
    with pytest.raises(kinegraph.Error):
        sweep["omega 99"]
    with pytest.raises(ValueError, match="more than one"):
        sweep["omega 3, omega 4"]


def test_the_first_arrays_are_made_in_several_threads(root):
    """Once they waited for each other, each importing NumPy."""
    code = ("import kinegraph, concurrent.futures as f\n"
            f"m = kinegraph.load({str(root / 'examples/four_bar.json')!r})\n"
            "with f.ThreadPoolExecutor(4) as p: print(len(list(p.map(lambda n: m.sweep(steps=n)['turn'], [9] * 8))))")
    said = subprocess.run([sys.executable, "-c", code], check=True, cwd=conftest.BUILD / "python", timeout=120,
                          stdout=subprocess.PIPE)
    assert said.stdout == b"8\n"


def test_travel_and_parameters(examples):
    mechanism = kinegraph.load(examples / "four_bar.json")
    part = mechanism.sweep(steps=10, start="0°", stop="30°")
    assert len(part) == 11 and part["turn"][-1] == pytest.approx(math.pi / 6)
    over = kinegraph.load(examples / "variants/four_bar.json").sweep(4, over="r", start="35 mm", stop="55 mm")
    assert over.names[0] == "r" and len(over) == 5
    assert part.limits() == (None, None) and part.summary("it")


def test_limits_and_poles(examples):
    sweep = kinegraph.load(examples / "sluice_gate_travel.json").sweep(steps=72)
    first, last = sweep.limits()
    assert first == pytest.approx(-24.7236, abs=1e-4) and last == pytest.approx(15.95731, abs=1e-4)
    assert {pole.at for pole in sweep.poles()} >= {first, last}
    assert sweep.largest_difference() < 1e-9


def test_files_of_a_sweep(examples, tmp_path):
    sweep = kinegraph.load(examples / "quick_return.json").sweep(steps=36, traces=["C"], poses=4)
    for ending in ("csv", "json", "svg", "pdf"):
        for path in sweep.save(tmp_path / f"cycle.{ending}"):
            assert path.stat().st_size > 500


def test_cams(examples):
    cam = kinegraph.load_cam(examples / "cams/disc_cam.json")
    profile = cam.profile(180)
    assert profile.shape[1] == 2 and len(profile) >= 180
    assert cam.at(0.0).curvature != 0 and math.isfinite(cam.at(1.0).pressure_angle)
    cycle = cam.cycle("60°", steps=36)
    assert cycle.facts("de") and cycle.draw().pages >= 1 and cycle.csv().count("\n") >= 37
    kinegraph.parse(cam.mechanism_text(1.0)).solve()
