"""Faulty files raise kinegraph.Error, with the place, the fault and the remedy."""

import pathlib

import pytest

import kinegraph

ROOT = pathlib.Path(__file__).resolve().parents[2]
BROKEN = sorted((ROOT / "tests/broken").glob("*.json"))


def test_there_are_broken_files():
    assert len(BROKEN) > 40


@pytest.mark.parametrize("path", BROKEN, ids=lambda path: path.stem)
def test_every_broken_file_raises_its_faults(path):
    with pytest.raises(kinegraph.Error) as caught:
        kinegraph.load(path).solve()
    expected = path.with_suffix(".txt").read_text(encoding="utf-8").rstrip("\n")
    said = "\n".join(f"{place}: {text['en']}" for _, place, text, _, _ in caught.value._raw)
    assert said == expected
    for lang in kinegraph.languages:
        assert len(caught.value.faults_in(lang)) == len(caught.value.faults)
        for (_, _, text, _, _), own, english in zip(caught.value._raw, caught.value.faults_in(lang),
                                                     caught.value.faults):
            assert own.message or own.remedy
            whole = text[lang].replace(" (", "").replace("(", "").replace(")", "")
            for part in (own.message, own.remedy):
                assert part.replace(" (", "").replace("(", "").replace(")", "") in whole
            assert bool(own.remedy) == bool(english.remedy), text


def test_remedies():
    with pytest.raises(kinegraph.Error) as caught:
        kinegraph.load(ROOT / "tests/broken/misspelt_keys.json")
    faults = caught.value.faults
    assert faults[0] == ("/drivres", 'unknown key "drivres"', 'did you mean "drivers"?', "bad input")
    assert faults[2].message == 'unknown key "wheels"' and faults[2].remedy.startswith("the keys of a mechanism are")
    with pytest.raises(kinegraph.Error) as caught:
        kinegraph.load(ROOT / "tests/broken/drivers.json")
    assert caught.value.faults[0][:3] == ("/drivers/0/body", "the frame does not move", "drive another body")
    assert caught.value.faults_in("it")[0].remedy not in ("", "drive another body")


def test_a_missing_file_is_an_os_error():
    with pytest.raises(FileNotFoundError):
        kinegraph.load("nowhere.json")
