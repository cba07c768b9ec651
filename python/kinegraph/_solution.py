"""The solution of a file."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from fractions import Fraction
from functools import cached_property
from pathlib import Path
from typing import TYPE_CHECKING, Any, NamedTuple, Unpack

from . import _core
from ._drawing import Drawing, DrawingOptions, LivePage, PathLike, Text, for_core

if TYPE_CHECKING:
    import numpy
    import numpy.typing


class Quantity(NamedTuple):
    """A result with its unit."""

    value: float
    """In the unit that the file uses for it."""
    unit: str
    """That unit, "rad/s"; empty for a bare number."""
    si: float
    """In SI units."""


class Check(NamedTuple):
    """A result of the construction and of the independent numeric check, SI."""

    name: str
    graphical: float
    numeric: float
    difference: float


class Missing(NamedTuple):
    """A result that the mechanism does not determine."""

    what: str
    reason: str


class Solution(Mapping[str, float]):
    """A solved position: results by name in SI units, sentences, drawings.

    `solution["omega 3"]` is the angular velocity of body 3 in rad/s, counter-clockwise positive; `"vx B"` a component
    in m/s, `"Fx A 3 on 2"` a force in N. Angles are in radians. Expressions of results are understood, too:
    `solution["omega 4 / omega 2"]`, `solution["|v B|"]`. A result that is not determined is no error of the whole:
    `unsolved` has the reasons. Values do not change; several threads may use one solution.
    """

    def __init__(self, core: _core.Solved) -> None:
        self._core = core

    @cached_property
    def _values(self) -> dict[str, _core.ResultValue]:
        return {each.name: each for each in self._core.values()}

    def _value(self, name: str) -> _core.ResultValue:
        return self._values.get(name) or self._core.evaluate(name)

    def __getitem__(self, name: str) -> float:
        """A result or an expression of results, SI. Raises kinegraph.Error for an unknown name."""
        return self._value(name).value

    def get(self, name: str, default: Any = None) -> Any:
        """The result of that name, SI; `default` if there is none."""
        return self._values[name].value if name in self._values else default

    def __contains__(self, name: object) -> bool:
        return name in self._values

    def __iter__(self) -> Iterator[str]:
        return iter(self._values)

    def __len__(self) -> int:
        return len(self._values)

    def __repr__(self) -> str:
        title = self.title()
        return f"<Solution{' of ' + repr(title) if title else ''}, {len(self)} results>"

    @property
    def names(self) -> list[str]:
        """The names of all results, in the order of the results file (docs/results.md)."""
        return list(self._values)

    def exact(self, name: str) -> Fraction:
        """A result as a fraction, SI. Raises ValueError for a root, such as a length or an angle, for a result of a
        rounded drawing, and for an expression."""
        text = self._value(name).exact
        if text is None:
            raise ValueError(f"{name!r} has no exact value: it is a root, an expression, or of a rounded drawing")
        return Fraction(text)

    def vector(self, name: str) -> numpy.typing.NDArray[numpy.float64]:
        """A vector, "v B", "a B" or "F A 3 on 2": x and y in SI units."""
        import numpy

        found = self._core.vector(name)
        if found is None:
            found = self[f"{name[:1]}x{name[1:]}"], self[f"{name[:1]}y{name[1:]}"]
        return numpy.array(found)

    def quantity(self, name: str) -> Quantity:
        """A result in the unit of the file: `quantity("v B")` may be 12.5 "mm/s"."""
        found = self._value(name)
        return Quantity(found.in_file_unit, found.unit, found.value)

    def title(self, lang: str = "en") -> str:
        """The title of the file, in another position than the drawn one followed by the position; or what a file
        without joints is about."""
        return self._core.title(lang) or self._core.subject(lang)

    @property
    def statements(self) -> list[str]:
        """The sentences of the worked solution, in English."""
        return self.statements_in("en")

    def statements_in(self, lang: str) -> list[str]:
        """The sentences of the worked solution in a language."""
        return self._core.statements(lang)

    def unsolved(self, lang: str = "en") -> list[Missing]:
        """What is not determined, with the reasons."""
        return [Missing(*each) for each in self._core.unsolved(lang)]

    def remarks(self, lang: str = "en") -> list[str]:
        """Remarks: redundant constraints, points that were moved onto curves, bodies that separate."""
        return self._core.remarks(lang)

    def checks(self) -> list[Check]:
        """Each result beside that of the numeric check, which shares only the file with the construction."""
        return [Check(c.name, c.graphical, c.numeric, c.difference) for c in self._core.checks()]

    def json(self, *, exact: bool = False) -> str:
        """The results file; `exact` adds fractions."""
        return self._core.json(exact)

    def table(self, lang: str = "en") -> str:
        """The table that the command line prints."""
        return self._core.table(lang)

    @property
    def figures(self) -> list[str]:
        """The names of the figures that can be drawn alone."""
        return self._core.figure_names({})

    def draw(self, **options: Unpack[DrawingOptions]) -> Drawing:
        """The sheet, or one figure of it."""
        return Drawing(self._core.draw(for_core(options)))

    def svg(self, page: int = 0, *, text: Text = "outlines", **options: Unpack[DrawingOptions]) -> str:
        """A page of the sheet, or one figure, as SVG: `svg(figure="velocity", lang="it")`."""
        return self.draw(**options).svg(page, text=text)

    def page(self, **options: Unpack[DrawingOptions]) -> LivePage:
        """The page that moves in a browser, and in a notebook."""
        return LivePage(self._core.live_page(for_core(options)))

    def save(self, path: PathLike, *, dpi: float = 150, text: Text = "outlines", exact: bool = False,
             **options: Unpack[DrawingOptions]) -> list[Path]:
        """Writes a file by its ending: .svg, .png, .pdf, .tex and .dxf the sheet or a figure, .json the results
        (`exact` with fractions), .html the live page. Returns the paths: further pages are x-2.svg, x-3.svg …"""
        ending = Path(path).suffix.lower()
        if ending == ".html":
            return self.page(**options).save(path)
        if ending == ".json":
            Path(path).write_text(self.json(exact=exact), encoding="utf-8")
            return [Path(path)]
        if ending not in (".svg", ".png", ".pdf", ".tex", ".dxf"):
            raise ValueError(f"{path}: a solution is saved as .svg, .png, .pdf, .tex, .dxf, .json or .html")
        return self.draw(**options).save(path, dpi=dpi, text=text)

    def _repr_svg_(self) -> str:
        return self.draw().svg()

    def _repr_html_(self) -> str:
        return self.draw()._repr_html_()


def draw_all(solutions: Sequence[Solution], **options: Unpack[DrawingOptions]) -> Drawing:
    """Several solutions in one document, for example positions of one mechanism."""
    return Drawing(_core.draw_all([each._core for each in solutions], for_core(options)))
