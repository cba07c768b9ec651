"""Files written in code, by methods made from the schema."""

import json
import pathlib
from decimal import Decimal
from fractions import Fraction

import numpy
import pytest

import kinegraph
from kinegraph import Mechanism, _builder, _stub, circle


def four_bar() -> Mechanism:
    return (Mechanism()
            .title(en="Four-bar linkage", it="Quadrilatero articolato", fr="Quadrilatère articulé",
                   de="Gelenkviereck", es="Cuadrilátero articulado")
            .units(length="mm").frame(1)
            .point("O2", 0, 0)
            .point("A", from_="O2", distance=40, angle=60)
            .point("O4", [150, 0])
            .point("B", meet=[circle("A", 150), circle("O4", 80)], side="left")
            .link("2", "O2", "A").link(3, ["A", "B"]).body("4", "O4", "B")
            .revolute("O2", 1, 2).revolute("A", [2, 3]).revolute("B", bodies=[3, 4]).joint(revolute="O4", bodies=[1, 4])
            .driver(body=2, omega="-120 rpm")
            .find("instant centres", "velocity", "acceleration"))


def test_the_builder_writes_the_file(examples):
    assert four_bar().to_dict() == json.loads((examples / "four_bar.json").read_text())
    assert four_bar().solve().json() == kinegraph.load(examples / "four_bar.json").solve().json()


def test_every_section_and_kind_of_the_schema_has_a_method():
    sections = set(kinegraph.schema()["properties"]) - {"$schema"}
    assert {each.section for each in _builder.methods()} == sections
    joints = [each.leading for each in _builder.methods() if each.section == "joints" and each.leading]
    assert len(joints) == len(list(_builder.forms(kinegraph.schema()["definitions"]["joint"]))) >= 7
    for each in _builder.methods():
        assert callable(getattr(Mechanism, each.name)) and getattr(Mechanism, each.name).__doc__, each.name


def test_every_key_of_every_form_is_a_keyword_of_a_method():
    seen = 0
    for method in _builder.methods():
        for key in method.keys:
            data: dict = {}
            name = () if method.holds != "map" else ("N",)
            leading = ("L",) if method.leading else ()
            _builder._add(data, method, name + leading, {_builder.python_name(key): 0})
            entry = data[method.section]
            entry = entry[0] if method.holds == "list" else entry["N"] if method.holds == "map" else entry
            assert entry[key] == 0
            seen += 1
    assert seen > 100


@pytest.mark.parametrize("name", ["slider_crank", "truss_roof_wind", "watt_six_bar", "oldham_coupling",
                                  "engine_inertia_gas", "planetary_train", "moving_frame"])
def test_an_example_is_built_again_from_its_parts(examples, name):
    contents = json.loads((examples / f"{name}.json").read_text(), parse_float=Decimal)
    by_section = {each.section: each for each in _builder.methods() if not each.leading}
    built = Mechanism()
    for section, value in contents.items():
        if section == "$schema":
            continue
        method = getattr(built, by_section[section].name)
        if by_section[section].holds == "map":
            for key, entry in value.items():
                method(key, entry)
        elif by_section[section].holds == "list":
            method(*(value if isinstance(value, list) else [value]))
        else:
            method(value)
    assert built.solve().json(exact=True) == kinegraph.load(examples / f"{name}.json").solve().json(exact=True)


def test_unknown_keys_are_refused_at_once():
    with pytest.raises(TypeError, match="prismatic.*no key 'anlog'.*along"):
        Mechanism().prismatic("B", 4, 1, anlog=0)
    with pytest.raises(AttributeError):
        Mechanism().revolt("A", 1, 2)
    with pytest.raises(TypeError, match="wants a name"):
        Mechanism().point()


def test_numbers_keep_their_digits():
    loaded = kinegraph.parse('{"kinegraph": 1, "points": {"A": [0, 0], "B": [0.1000000000000000000001, 1]},'
                             '"bodies": {"2": ["A", "B"]}, "joints": [{"revolute": "A", "bodies": [0, 2]}],'
                             '"drivers": [{"body": 2, "omega": 1}], "precision": 0}')
    assert loaded.solve().exact("x B") == Fraction("0.1000000000000000000001")
    loaded.title("the same")  # now it is written anew
    assert loaded.solve().exact("x B") == Fraction("0.1000000000000000000001")
    built = loaded.copy().point("B", Fraction(1, 3), numpy.float64(0.5)).point("A", *numpy.array([0, 0]))
    assert built.solve().exact("x B") == Fraction(1, 3) and built.solve().exact("y B") == Fraction(1, 2)
    assert loaded.solve().exact("x B") != Fraction(1, 3)


@pytest.mark.parametrize("wrong", [float("nan"), float("inf"), Decimal("NaN")])
def test_what_is_no_number_is_refused(wrong):
    with pytest.raises(ValueError):
        Mechanism().point("A", wrong, 0).text


def test_a_faulty_dict_names_its_places():
    with pytest.raises(kinegraph.Error) as caught:
        kinegraph.load({"kinegraph": 1, "points": {"A": ["x", 0]}, "bodies": {}, "joints": []})
    assert caught.value.faults[0].place == "/points/A/0"


def test_the_stub_is_that_of_the_schema(root: pathlib.Path):
    assert (root / "python/kinegraph/_builder.pyi").read_text() == _stub.stub()
