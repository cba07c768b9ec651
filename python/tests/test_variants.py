"""Variants are those of the program, and so is their key."""

import itertools

import pandas
import pytest

import kinegraph


def test_key_and_sheets_are_the_programs(examples, program, tmp_path):
    file = examples / "variants/four_bar.json"
    (tmp_path / "roster.csv").write_text("name\nAda\nBeppe\nChloé\n")
    program("variants", file, "--count", 3, "--seed", 7, "--roster", tmp_path / "roster.csv", "--format", "svg", "-o",
            tmp_path, stderr=-3)
    key = kinegraph.Key()
    for variant, name in zip(kinegraph.load(file).variants(seed=7), ["Ada", "Beppe", "Chloé"]):
        key.add(variant, name)
        theirs = (tmp_path / f"{variant.number}-question.svg").read_text()
        assert variant.solution.svg(sheet="question", author=name) == theirs
        assert variant.text == (tmp_path / f"{variant.number}.json").read_text()
        assert variant.mechanism.solve()["omega 3"] == pytest.approx(variant.solution["omega 3"], rel=1e-12)
    assert key.csv() == (tmp_path / "key.csv").read_text()
    frame = key.to_frame()
    assert isinstance(frame, pandas.DataFrame) and list(frame.index) == ["001", "002", "003"]
    assert list(frame["name"]) == ["Ada", "Beppe", "Chloé"]
    (path,) = key.save(tmp_path / "ours.pdf", "Four-bar linkage")
    assert path.read_bytes().startswith(b"%PDF")


def test_a_seed_gives_the_same_variants_and_another_gives_others(examples):
    mechanism = kinegraph.load(examples / "variants/slider_crank.json")

    def values(seed):
        return [tuple(variant.values.values()) for variant in itertools.islice(mechanism.variants(seed=seed), 5)]

    assert values(7) == values(7) != values(8)
    assert len(set(values(7))) == 5


def test_the_iterator_ends_and_says_why():
    exercise = kinegraph.load({
        "kinegraph": 1, "parameters": {"w": 1}, "points": {"O": [0, 0], "A": [1, 0]}, "bodies": {"2": ["O", "A"]},
        "joints": [{"revolute": "O", "bodies": [0, 2]}], "drivers": [{"body": 2, "omega": "= w"}],
        "ask": ["omega 2"], "vary": {"w": {"choose": [1, 2, 3, 4]}}, "require": ["omega 2 > 1.5"]})
    variants = exercise.variants()
    assert sorted(variant.asked["omega 2"].value for variant in variants) == [2, 3, 4]
    assert variants.combinations == variants.looked_at == 4 and sum(variants.rejections().values()) == 1
    with pytest.raises(kinegraph.Error):
        kinegraph.load({**exercise.to_dict(), "vary": {"v": {"choose": [1, 2]}}})


def test_question_banks(examples):
    variants = kinegraph.load(examples / "variants/truss.json").variants(seed=1)
    bank = kinegraph.QuestionBank("Truss", seed=1, lang="it", dpi=72)
    for variant in itertools.islice(variants, 2):
        bank.add(variant)
    assert bank.moodle().count("<question type=\"cloze\"") == 2
    assert bank.qti()[:2] == b"PK" and bank.csv().count("\n") == 3
