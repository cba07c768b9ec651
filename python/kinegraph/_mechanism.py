"""Mechanism files: loaded, or written in code."""

from __future__ import annotations

import copy
from collections.abc import Mapping
from pathlib import Path
from typing import Any, Self, Unpack

from . import _core
from ._builder import FileBuilder
from ._drawing import DrawingOptions, PathLike
from ._json import parsed, quantity, text_of
from ._motion import Sweep
from ._solution import Solution
from ._variants import Variants, variants_of


class Equations:
    """The closure equations, as LaTeX in a notebook and as text elsewhere."""

    def __init__(self, file: _core.MechanismFile, lang: str) -> None:
        self.text = file.equations("plain", lang)
        """For a terminal."""
        self.latex = file.equations("latex", lang)
        """A document of LaTeX."""
        self._formulas = file.equations("formulas", lang)

    def __str__(self) -> str:
        return self.text

    def _repr_latex_(self) -> str:
        return self._formulas


class Mechanism(FileBuilder):
    """A mechanism file, or a problem without joints.

    `kinegraph.load()` reads one. In code it is written section by section with the keys of the file, a space or a
    hyphen as an underscore: `Mechanism().units(length="mm").point("O", 0, 0).link("2", "O", "A").revolute("O", 1, 2)`.
    """

    def __init__(self, data: Mapping[str, Any] | None = None, *, name: str = "mechanism") -> None:
        self.name = name
        """What title blocks and messages call the file."""
        self._data: dict[str, Any] | None = copy.deepcopy(dict(data)) if data is not None else {"kinegraph": 1}
        self._text = ""
        self._set: dict[str, str] = {}
        self._file: _core.MechanismFile | None = None

    @classmethod
    def _of_text(cls, text: str, name: str) -> Self:
        made = cls(name=name)
        made._data, made._text = None, text
        return made

    def _contents(self) -> dict[str, Any]:
        """What the builder writes into; the file is read anew afterwards."""
        if self._data is None:
            self._parsed()  # a file with faults is refused with their places
            self._data = parsed(self._text.removeprefix("\ufeff"))
        self._file = None
        return self._data

    def _parsed(self) -> _core.MechanismFile:
        file = self._file
        if file is None:
            file = _core.MechanismFile.parse(self.text, self.name, list(self._set.items()))
            self._file = file
        return file

    @property
    def text(self) -> str:
        """The mechanism file, as it was loaded or as JSON of what was built."""
        return self._text if self._data is None else text_of(self._data)

    def to_dict(self) -> dict[str, Any]:
        """The file as a dict; its decimals are of the type Decimal where they have a fraction."""
        contents: dict[str, Any] = parsed(self.text.removeprefix("\ufeff"))
        return contents

    def save(self, path: PathLike) -> list[Path]:
        """Writes the mechanism file."""
        Path(path).write_text(self.text, encoding="utf-8")
        return [Path(path)]

    def copy(self) -> Self:
        """An independent copy, to be built on."""
        return copy.deepcopy(self)

    def __deepcopy__(self, memo: dict[int, Any]) -> Self:
        other = type(self)(self._data, name=self.name) if self._data is not None else self._of_text(
            self._text, self.name)
        other._set = dict(self._set)
        return other

    def with_parameters(self, values: Mapping[str, Any] | None = None, **more: Any) -> Self:
        """A copy with other values of its parameters: `with_parameters(r="45 mm", k=3)`. A text is read as in a file,
        with its unit or as a formula, "= 2*r"."""
        other = self.copy()
        other._set |= {name: quantity(value) for name, value in {**(values or {}), **more}.items()}
        return other

    def title_in(self, lang: str) -> str:
        """The title in a language; empty if the file has none."""
        return self._parsed().title(lang)

    def check(self, lang: str = "en") -> list[str]:
        """Likely mistakes: points shared without a joint, unsupported bodies, conditions that do not hold. Raises
        kinegraph.Error for faults."""
        return self._parsed().check(lang)

    def solve(self, at: str | None = None, *, driver: str = "", branch: int = 0, equations: bool = False,
              virtual_work: bool = False) -> Solution:
        """Solves it as drawn, or with a driver moved: `at="30°"`, `at="20 mm"`.

        driver: its body, joint or point; the first of the file if empty. branch: at a change point the branch to take,
        from 1. equations, virtual_work: adds the closure equations, or the principle of virtual work, to the sheet.
        Raises kinegraph.Error for faults and where curves do not meet. Other threads run meanwhile.
        """
        if at is None:
            return Solution(self._parsed().solve(equations, virtual_work, True))
        found = self.solve_at(at, driver=driver, branch=branch, equations=equations, virtual_work=virtual_work)
        if len(found) != 1:
            raise ValueError(f"{at!r} gives {len(found)} positions; solve_at() returns them all")
        return found[0]

    def solve_at(self, *at: str, driver: str = "", branch: int = 0, equations: bool = False,
                 virtual_work: bool = False) -> list[Solution]:
        """Solves it in several positions of a driver: `solve_at("0°", "30°")`, `solve_at("every 30°")`."""
        found = self._parsed().solve_at(list(at), driver, branch, equations, virtual_work)
        return [Solution(each) for each in found]

    def sweep(self, steps: int = 360, *, driver: str = "", start: str = "", stop: str = "",
              along: Mapping[str, str] | None = None, branch: int = 0, over: str = "", step: str = "",
              plots: list[str] | None = None, traces: list[str] | None = None, centrodes: list[str] | None = None,
              poses: int = 0) -> Sweep:
        """The results over a whole turn, from limit to limit, or from `start` to `stop` of a driver, in `steps` + 1
        rows.

        start, stop: the driver's coordinate ("30°", "20 mm") or a time of its law ("0.2 s"). along: drivers that move
        with it and their steps, {"5": "2°"}. over: a parameter to vary instead of a driver, by `step`. plots, traces,
        centrodes, poses: what is drawn: columns, paths of points ("P", "P,on BODY"), pairs of bodies ("1,3"), the
        number of positions behind the mechanism.
        """
        options = {"driver": driver, "along": list((along or {}).items()), "branch": branch, "over": over,
                   "start": start, "stop": stop, "step": step, "steps": steps, "plots": plots or [],
                   "traces": traces or [], "centrodes": centrodes or [], "poses": poses}
        return Sweep(self._parsed(), options)

    def variants(self, seed: int = 1, **options: Unpack[DrawingOptions]) -> Variants:
        """The variants of an exercise, a file with "vary": an iterator, the same for the same seed. `options` give the
        paper on which a condition on readable polygons must hold."""
        return variants_of(self.text, self.name, seed, list(self._set.items()), dict(options))

    def pairs(self, form: str = "plain", lang: str = "en") -> str:
        """Its pairs and degrees of freedom, as "plain", "markdown" or "json"."""
        return self._parsed().pairs(form, lang)

    def equations(self, lang: str = "en") -> Equations:
        """Its closure equations as vector loops, or the derivatives of a point's laws."""
        return Equations(self._parsed(), lang)

    def __repr__(self) -> str:
        return f"<Mechanism {self.name!r}>"


def _read(path: Path) -> str:
    contents = path.read_bytes()
    try:
        return contents.decode("utf-8")
    except UnicodeDecodeError:
        _core.MechanismFile.parse(contents, path.name, [])  # raises kinegraph.Error with the place
        raise


def parse(text: str, *, name: str = "mechanism") -> Mechanism:
    """A mechanism from the text of its file. Raises kinegraph.Error with all faults at once."""
    made = Mechanism._of_text(text, name)
    made._parsed()
    return made


def load(source: PathLike | Mapping[str, Any], *, set: Mapping[str, Any] | None = None) -> Mechanism:
    """A mechanism from the path of its file, or from a dict like one.

    set: other values of its parameters, {"r": "45 mm"}. Raises kinegraph.Error with all faults at once, OSError if the
    file cannot be read.
    """
    if isinstance(source, Mapping):
        made = Mechanism(source)
    else:
        made = Mechanism._of_text(_read(Path(source)), Path(source).name)
    if set:
        made = made.with_parameters(set)
    made._parsed()
    return made
