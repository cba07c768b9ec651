"""Results by name: closed forms, the program's own results, languages."""

import json
from fractions import Fraction

import pytest

import kinegraph

# Slider-crank O(0,0), A(30,40), B(150,0) mm, ω₂ = 10 rad/s: v_A = (−0.4, 0.3) m/s; v_B lies along x, so
# ω₃ = −0.3/0.12 = −5/2 rad/s and v_B = −0.4 + ω₃·0.04 = −1/2 m/s.
SLIDER_CRANK = {
    "kinegraph": 1, "units": {"length": "mm"}, "frame": 1, "parameters": {"w": 10},
    "points": {"O": [0, 0], "A": [30, 40], "B": [150, 0]},
    "bodies": {"2": ["O", "A"], "3": ["A", "B"], "4": ["B"]},
    "joints": [{"revolute": "O", "bodies": [1, 2]}, {"revolute": "A", "bodies": [2, 3]},
               {"revolute": "B", "bodies": [3, 4]}, {"prismatic": "B", "bodies": [4, 1], "along": 0}],
    "drivers": [{"body": 2, "omega": "= w"}],
}


@pytest.fixture()
def solution():
    return kinegraph.load(SLIDER_CRANK).solve()


def test_values_are_si(solution):
    assert solution["omega 3"] == -2.5
    assert solution["vx B"] == -0.5
    assert solution.quantity("omega 3") == (-2.5, "rad/s", -2.5)
    assert solution.quantity("x A") == (30, "mm", 0.03)


def test_exact_values_are_fractions(solution):
    assert solution.exact("omega 3") == Fraction(-5, 2)
    assert solution.exact("x A") == Fraction(3, 100)
    with pytest.raises(ValueError, match="no exact value"):
        solution.exact("v A")  # a length takes a root


def test_expressions(solution):
    assert solution["omega 3 / omega 2"] == -0.25
    assert solution["|v A|"] == 0.5
    assert solution["vx B / w"] == -0.05  # w is a parameter
    assert solution["y A - y B"] == pytest.approx(0.04, rel=1e-15)


def test_vectors_are_arrays(solution):
    assert solution.vector("v A").tolist() == [-0.4, 0.3]
    assert solution.vector("v A").dtype == float


def test_is_a_mapping(solution):
    assert "omega 3" in solution and "omega 99" not in solution
    assert list(solution) == solution.names and len(solution) == len(solution.names) > 10
    assert dict(solution)["omega 3"] == solution["omega 3"]
    assert solution.get("omega 99") is None


def test_unknown_names_are_faults_with_the_nearest(solution):
    for wrong in (lambda: solution["omega  3"], lambda: solution.vector("w A"), lambda: solution["omega 3 / mega 2"]):
        with pytest.raises(kinegraph.Error):
            wrong()
    with pytest.raises(kinegraph.Error) as caught:
        solution["omga 3"]
    assert caught.value.faults[0].remedy.startswith('did you mean "omega 3"?; what is found')
    with pytest.raises(kinegraph.Error) as caught:
        solution["omega 3 / (omega 2 - omega 2)"]
    assert caught.value.faults[0].kind == "no unique answer"


def test_parameters(solution):
    mechanism = kinegraph.load(SLIDER_CRANK)
    twice = mechanism.with_parameters(w=20)
    assert twice.solve().exact("omega 3") == -5
    assert mechanism.solve().exact("omega 3") == Fraction(-5, 2)
    assert kinegraph.load(SLIDER_CRANK, set={"w": "60 rpm"}).solve()["omega 2"] == pytest.approx(6.283185307179586)
    assert mechanism.with_parameters({"w": Fraction(1, 3)}).solve().exact("omega 3") == Fraction(-1, 12)


def test_other_positions(examples):
    mechanism = kinegraph.load(examples / "four_bar.json")
    (turned,) = mechanism.solve_at("30°")
    assert turned["angle 2"] == pytest.approx(mechanism.solve()["angle 2"] + 3.141592653589793 / 6)
    assert mechanism.solve(at="30°")["omega 3"] == turned["omega 3"]
    assert len(mechanism.solve_at("every 90°")) >= 4
    with pytest.raises(ValueError, match="positions"):
        mechanism.solve(at="every 90°")


def test_sentences_in_every_language(solution):
    said = [tuple(solution.statements_in(lang)) for lang in kinegraph.languages]
    assert len(set(said)) == len(kinegraph.languages) == 5
    assert solution.statements == list(said[0]) and all(solution.statements)
    with pytest.raises(ValueError, match="there are en, it"):
        solution.statements_in("xx")


def test_what_is_not_determined_has_a_reason(examples):
    at_dead_point = kinegraph.load(examples / "slider_driven_dead_point.json").solve()
    assert at_dead_point.unsolved() and all(each.reason for each in at_dead_point.unsolved())


def test_results_of_every_example_are_the_programs(examples, program):
    files = sorted(path for folder in (examples, examples / "contact", examples / "motion", examples / "rotor")
                   for path in folder.glob("*.json") if path.name != "cam_from_law.json")
    assert len(files) > 70
    wanted = program("batch", "--jobs", "2", input="".join(
        json.dumps({"file": str(path), "exact": True}) + "\n" for path in files).encode())
    compared = 0
    for path, line in zip(files, wanted.splitlines()):
        answer = json.loads(line)
        if "result" not in answer:
            with pytest.raises(kinegraph.Error):
                kinegraph.load(path).solve()
            continue
        solution = kinegraph.load(path).solve()
        assert json.loads(solution.json(exact=True)) == answer["result"], path
        assert all(value == value for value in solution.values()), path
        compared += 1
    assert compared > 70


def test_checks_agree(examples):
    checks = kinegraph.load(examples / "watt_six_bar.json").solve().checks()
    assert len(checks) > 10
    largest = max(abs(each.numeric) for each in checks)
    assert all(abs(each.difference) < 1e-6 * largest for each in checks)


def test_equations_and_pairs(examples):
    mechanism = kinegraph.load(examples / "four_bar.json")
    equations = mechanism.equations()
    assert "\\documentclass" in equations.latex
    assert "\\[" in equations._repr_latex_() and "\\begin{document}" not in equations._repr_latex_()
    assert str(equations)
    assert json.loads(mechanism.pairs("json"))
    assert kinegraph.pair_catalogue("plain", "it")
