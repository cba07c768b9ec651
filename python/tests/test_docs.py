"""Every example of docs/python.md, in its order; `# → …` is what its line gives."""

import json
import pathlib
import re
import shutil

import pytest

import kinegraph
from test_solution import SLIDER_CRANK

ROOT = pathlib.Path(__file__).resolve().parents[2]
MANUAL = (ROOT / "docs/python.md").read_text(encoding="utf-8")
BLOCKS = re.findall(r"```python\n(.*?)```", MANUAL, re.DOTALL)


def run(block: str, names: dict) -> int:
    """Runs a block; the number of its values that were compared."""
    compared, pending = 0, []
    for line in block.splitlines():
        shown = re.match(r"(\S.*?)\s+# → (.*)$", line)
        if shown is None:
            pending.append(line)
            continue
        exec("\n".join(pending), names)
        pending = []
        assert repr(eval(shown[1], names)) == shown[2], line
        compared += 1
    exec("\n".join(pending), names)
    return compared


def test_every_example_gives_what_it_says(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    (tmp_path / "slider_crank.json").write_text(json.dumps(SLIDER_CRANK))
    shutil.copytree(ROOT / "examples/variants", tmp_path / "variants")
    names: dict = {}
    assert len(BLOCKS) >= 8
    assert sum(run(block, names) for block in BLOCKS) > 25


def test_an_example_can_fail():
    with pytest.raises(AssertionError):
        run("1 + 1    # → 3", {})


def test_every_option_of_a_drawing_is_in_the_table():
    described = re.findall(r"`(\w+)", MANUAL[MANUAL.index("| option |"):MANUAL.index("The endings of `save`")])
    assert set(kinegraph.DrawingOptions.__annotations__) <= set(described)


def test_public_names_have_docstrings():
    for name in kinegraph.__all__:
        value = getattr(kinegraph, name)
        if callable(value):
            assert value.__doc__, name
            for part, member in vars(value).items() if isinstance(value, type) else ():
                if not part.startswith("_") and callable(member):
                    assert member.__doc__, f"{name}.{part}"
