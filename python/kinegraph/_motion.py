"""Sweeps and cams."""

from __future__ import annotations

import threading
from collections.abc import Mapping
from pathlib import Path
from typing import TYPE_CHECKING, Any, NamedTuple, Unpack

from . import _core
from ._drawing import Drawing, DrawingOptions, PathLike, Text, for_core
from ._json import text_of

if TYPE_CHECKING:
    import numpy
    import numpy.typing
    import pandas

    Array = numpy.typing.NDArray[numpy.float64]


def _array(cells: bytes, columns: int) -> Array:
    import numpy

    return numpy.frombuffer(cells).reshape(-1, columns)


class Pole(NamedTuple):
    """Where a column grows without limit."""

    column: str
    at: float
    """Of the driver's coordinate, rad or m, or of its law, s."""


class Separation(NamedTuple):
    """A contact that would have to pull, between two positions."""

    joint: str
    start: float
    stop: float


class Sweep:
    """The results of a mechanism in one position after another.

    `sweep["omega 3"]` is a NumPy array with a value for each row, SI; NaN where the quantity grows without limit.
    Expressions are understood: `sweep["omega 4 / omega 2"]`. The first column, `"turn"` or `"slide"`, is the driver's
    coordinate from the drawn position (rad or m). Rows are computed when first asked for.
    """

    def __init__(self, file: _core.MechanismFile, options: dict[str, Any]) -> None:
        self._file = file
        self._options = options
        self._core = _core.Sweep.of(file, options)
        self._lock = threading.Lock()
        self._rows: Array | None = None
        self._more: dict[str, Array] = {}

    def _all_rows(self) -> Array:
        with self._lock:
            if self._rows is None:
                self._rows = _array(self._core.rows(), len(self._core.columns()))
            return self._rows

    @property
    def units(self) -> dict[str, str]:
        """The columns and their SI units: {"turn": "rad", "omega 3": "rad/s", …}; "" for a bare number."""
        self._all_rows()
        return dict(self._core.columns())

    @property
    def names(self) -> list[str]:
        """The names of the columns."""
        return list(self.units)

    def __len__(self) -> int:
        """The number of rows."""
        return len(self._all_rows())

    def __getitem__(self, name: str) -> Array:
        """A column, or an expression of columns, as an array, SI."""
        rows, names = self._all_rows(), self.names
        if name in names:
            return rows[:, names.index(name)]
        if name not in self._more:
            one = _core.Sweep.of(self._file, {**self._options, "columns": name})
            cells = one.rows()
            if len(one.columns()) != 2:
                raise ValueError(f"{name!r} is more than one column")
            self._more[name] = _array(cells, 2)[:, 1]
        return self._more[name]

    def to_frame(self) -> pandas.DataFrame:
        """All columns as a DataFrame of pandas; its `attrs["units"]` has their units."""
        import pandas

        frame = pandas.DataFrame(self._all_rows(), columns=self.names)
        frame.attrs["units"] = self.units
        return frame

    def limits(self) -> tuple[float | None, float | None]:
        """Where the driver stops at the beginning and at the end (rad or m); None where it could go on."""
        first, last = self._core.limits()
        return first, last

    def change_points(self) -> list[float]:
        """Change points within the travel, in the driver's coordinate (rad or m)."""
        return self._core.change_points()

    def poles(self) -> list[Pole]:
        """Where forces and couples grow without limit, found to 1e-9 of the travel."""
        self._all_rows()
        return [Pole(*each) for each in self._core.poles()]

    def separations(self) -> list[Separation]:
        """Where contacts would have to pull."""
        self._all_rows()
        return [Separation(*each) for each in self._core.separations()]

    def summary(self, lang: str = "en") -> list[str]:
        """The travel, extremes of input forces, rows left out, the largest difference from the numeric check."""
        self._all_rows()
        return self._core.summary(lang)

    def remarks(self, lang: str = "en") -> list[str]:
        """What of the options has no effect."""
        return self._core.remarks(lang)

    def largest_difference(self) -> float:
        """From the numeric check, relative to the largest value of its kind."""
        self._all_rows()
        return self._core.largest_difference()

    def csv(self) -> str:
        """The rows as CSV, SI."""
        return _core.Sweep.of(self._file, self._options).csv()

    def json(self) -> str:
        """The rows as JSON, with the travel and the centrodes."""
        return _core.Sweep.of(self._file, self._options).json()

    def draw(self, **options: Unpack[DrawingOptions]) -> Drawing:
        """The mechanism with its paths, the table of extremes and the plots."""
        with self._lock:
            return Drawing(self._core.draw(for_core(options)))

    def save(self, path: PathLike, *, dpi: float = 150, text: Text = "outlines",
             **options: Unpack[DrawingOptions]) -> list[Path]:
        """Writes a file by its ending: .csv and .json the rows, .svg, .png, .pdf and .tex the drawing."""
        ending = Path(path).suffix.lower()
        if ending in (".csv", ".json"):
            Path(path).write_text(self.csv() if ending == ".csv" else self.json(), encoding="utf-8")
            return [Path(path)]
        return self.draw(**options).save(path, dpi=dpi, text=text)

    def _repr_svg_(self) -> str:
        return self.draw().svg()

    def _repr_html_(self) -> str:
        return self.draw()._repr_html_()


class Cam:
    """A disc cam for a given law of its follower. A value; several threads may use it."""

    def __init__(self, core: _core.CamFile) -> None:
        self._core = core

    def at(self, turn: float) -> _core.CamPosition:
        """The cam at a turn from 0 to 2π: rise (m, or rad), contact (m), pressure angle (rad), curvature (1/m)."""
        return self._core.at(turn)

    def profile(self, positions: int = 360) -> Array:
        """The closed profile in the cam's own frame: rows of x and y in m."""
        return _array(self._core.profile(positions), 2)

    def mechanism_text(self, turn: float) -> str:
        """The mechanism file of the position at a turn (rad), with the circle of curvature for the profile."""
        return self._core.mechanism_at(turn)

    def cycle(self, at: str = "", steps: int = 360) -> CamCycle:
        """The whole turn, solved as a mechanism in every row. `at`: the position that is drawn, "30°"."""
        return CamCycle(_core.CamCycle.of(self._core, at, steps))


class CamCycle:
    """The whole turn of a cam."""

    def __init__(self, core: _core.CamCycle) -> None:
        self._core = core

    def csv(self) -> str:
        """The rows, SI: motion of the follower, profile, pressure angle, curvature."""
        return self._core.csv()

    def facts(self, lang: str = "en") -> list[str]:
        """The largest pressure angle, the least radii of curvature, undercuts."""
        return self._core.facts(lang)

    def remarks(self, lang: str = "en") -> list[str]:
        """Shocks: where the speed of the follower jumps."""
        return self._core.remarks(lang)

    def keeps_law(self) -> bool:
        """Whether the follower keeps its law: no undercut, and a unique answer in every row."""
        return self._core.keeps_law()

    def draw(self, **options: Unpack[DrawingOptions]) -> Drawing:
        """The construction of the profile, its data, and plots of the motion."""
        return Drawing(self._core.draw(for_core(options)))

    def _repr_svg_(self) -> str:
        return self.draw().svg()

    def _repr_html_(self) -> str:
        return self.draw()._repr_html_()


def load_cam(source: PathLike | Mapping[str, Any]) -> Cam:
    """A cam file by its path, or as a dict."""
    if isinstance(source, Mapping):
        return Cam(_core.CamFile.parse(text_of(source), "cam"))
    return Cam(_core.CamFile.parse(Path(source).read_bytes(), Path(source).name))
