"""Variants of an exercise: the same problem with different numbers, their key, and questions for platforms."""

from __future__ import annotations

import io
from collections.abc import Iterator
from pathlib import Path
from typing import TYPE_CHECKING, Any, Unpack

from . import _core
from ._drawing import Drawing, DrawingOptions, PathLike, for_core
from ._solution import Quantity, Solution

if TYPE_CHECKING:
    import pandas

    from ._mechanism import Mechanism


class Variant:
    """One variant of an exercise."""

    def __init__(self, core: _core.ExerciseVariant, number: str) -> None:
        self._core = core
        self.number = number
        """"001", "002" …"""
        self.values: dict[str, str] = dict(core.values)
        """The parameters that vary, as the file writes them: {"r": "45 mm"}."""
        self.solution = Solution(core.solved)
        """From which both sheets are drawn: `solution.draw(sheet="question")`."""
        self.text: str = core.file
        """The mechanism file of this variant alone."""

    @property
    def asked(self) -> dict[str, Quantity]:
        """The results asked for, in the units of the file."""
        return {each.name: Quantity(each.in_file_unit, each.unit, each.value) for each in self._core.asked}

    @property
    def mechanism(self) -> Mechanism:
        """The mechanism of this variant alone."""
        from ._mechanism import parse

        return parse(self.text, name=f"{self.number}.json")

    def __repr__(self) -> str:
        return f"<Variant {self.number}: {', '.join(f'{k} = {v}' for k, v in self.values.items())}>"


class Variants(Iterator[Variant]):
    """The variants of a file with "vary", in an order that depends on the seed only. No two are the same mechanism,
    and each fulfils the conditions of the file. The iterator ends when none is left. For one thread at a time."""

    def __init__(self, core: _core.ExerciseVariants) -> None:
        self._core = core
        self._count = 0

    def __next__(self) -> Variant:
        number = f"{self._count + 1:03}"
        found = self._core.next(f"{number}.json")
        if found is None:
            raise StopIteration
        self._count += 1
        return Variant(found, number)

    def title(self, lang: str = "en") -> str:
        """The title of the exercise."""
        return self._core.title(lang)

    @property
    def parameters(self) -> list[str]:
        """The parameters that vary."""
        return self._core.parameters()

    @property
    def combinations(self) -> int:
        """How many combinations the file has."""
        return self._core.combinations()

    @property
    def looked_at(self) -> int:
        """How many of them were tried so far."""
        return self._core.looked_at()

    def rejections(self, lang: str = "en") -> dict[str, int]:
        """Why combinations were rejected, and how many for each reason."""
        return dict(self._core.rejections(lang))


class Key:
    """The answer key of a class: a row for each variant, results in the units of the file."""

    def __init__(self) -> None:
        self._core = _core.AnswerKey()

    def add(self, variant: Variant, name: str = "", number: str = "") -> None:
        """Adds a row with the name of the student."""
        self._core.add(number or variant.number, name, variant._core)

    def __len__(self) -> int:
        return self._core.size()

    def csv(self) -> str:
        """As CSV: "variant,name,r,omega 3 [rad/s]"."""
        return self._core.csv()

    def to_frame(self) -> pandas.DataFrame:
        """As a DataFrame of pandas, its index the numbers of the variants."""
        import pandas

        return pandas.read_csv(io.StringIO(self.csv()), dtype={"variant": str}, index_col="variant")

    def draw(self, title: str = "", **options: Unpack[DrawingOptions]) -> Drawing:
        """The key as a table on as many pages as it needs."""
        return Drawing(self._core.drawing(title, for_core(options)))

    def save(self, path: PathLike, title: str = "", **options: Unpack[DrawingOptions]) -> list[Path]:
        """Writes .csv, or a drawing as .pdf, .svg, .png or .tex."""
        if Path(path).suffix.lower() == ".csv":
            Path(path).write_text(self.csv(), encoding="utf-8", newline="")
            return [Path(path)]
        return self.draw(title, **options).save(path)


class QuestionBank:
    """Variants as questions for Moodle and other platforms, each with its figure, a blank for each result with the
    tolerance of a careful drawing, and the steps of the solution."""

    def __init__(self, title: str, seed: int = 1, *, dpi: float = 150, **options: Unpack[DrawingOptions]) -> None:
        self._core = _core.QuestionBank(title, seed, for_core(options), dpi)

    def add(self, variant: Variant, name: str = "", number: str = "") -> list[str]:
        """Adds a question. Returns the results that cannot be told from zero at the scales of its figures."""
        return self._core.add(number or variant.number, name, variant._core)

    def moodle(self) -> str:
        """Cloze questions as Moodle XML."""
        return self._core.moodle()

    def qti(self) -> bytes:
        """An IMS package (ZIP) of QTI 2.1 items."""
        return self._core.qti()

    def csv(self) -> str:
        """A row for each variant, with values, units and tolerances."""
        return self._core.csv()


def variants_of(text: str, name: str, seed: int, set_: list[tuple[str, str]], options: dict[str, Any]) -> Variants:
    """The variants of a file's text."""
    return Variants(_core.ExerciseVariants.parse(text, name, seed, set_, for_core(options)))
