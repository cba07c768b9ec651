"""Sheets, figures and live pages."""

from __future__ import annotations

import base64
import html
import os
from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import Any, Literal, TypedDict, Unpack

from . import _core

PathLike = str | os.PathLike[str]
Text = Literal["outlines", "live", "office"]


class DrawingOptions(TypedDict, total=False):
    """How something is drawn; all may be left out."""

    figure: str
    """Only this figure, a name from `Solution.figures`: "mechanism", "velocity", "forces" …"""
    lang: str
    """Language: "en", "it", "fr", "de" or "es"."""
    paper: str
    """"A4", "A3" or "letter"."""
    orientation: str
    """"landscape" or "portrait"."""
    dimensions: str
    """Lengths and angles on the mechanism: "auto", "on" or "off"."""
    detail: str
    """"full", or "brief": what one would write on the board."""
    sheet: str
    """"solution", "question" or "answers"."""
    steps: bool
    """A page for each sentence instead of the sheet."""
    slides: bool
    """The steps on pages of 16:9 for a projector, without title block."""
    grid: bool
    """A question gets rooms with pole and grid for its polygons."""
    lever: bool
    """Joukowsky's lever besides."""
    author: str
    """A name in the title block."""
    date: str
    """A date in the title block, as it is to be printed."""
    theme: str
    """"colour", "print", "dark", or the path of a theme file."""


def for_core(options: Mapping[str, Any]) -> dict[str, Any]:
    """The options with the text of a theme file in place of its path."""
    wanted = dict(options)
    theme = wanted.get("theme")
    if theme is not None and theme not in _core.theme_names() and Path(theme).exists():
        del wanted["theme"]
        wanted["theme_file"] = Path(theme).read_text(encoding="utf-8")
    return wanted


def numbered(path: Path, page: int) -> Path:
    """x.svg, x-2.svg, x-3.svg …"""
    return path if page == 0 else path.with_name(f"{path.stem}-{page + 1}{path.suffix}")


class Drawing:
    """Finished pages, to scale in millimetres. The same solution and options give the same bytes everywhere."""

    def __init__(self, core: _core.Drawing) -> None:
        self._core = core

    @property
    def pages(self) -> int:
        """How many there are, at least one."""
        return self._core.pages

    def svg(self, page: int = 0, *, text: Text = "outlines") -> str:
        """One page as SVG 1.1. `text`: "outlines" of the letters, or "live" text that can be searched."""
        return self._core.svg(text)[page]

    def png(self, page: int = 0, *, dpi: float = 150) -> bytes:
        """One page as PNG, at `dpi` dots per inch (20 to 1200)."""
        return self._core.png(page, dpi)

    def pdf(self, *, text: Text = "outlines") -> bytes:
        """All pages as PDF."""
        return self._core.pdf(text)

    def tex(self) -> str:
        """All pages as TikZ pictures in a document for pdflatex."""
        return self._core.tex()

    def beamer(self) -> str:
        """Slides (`steps=True, slides=True`) as LaTeX for the class beamer: a frame for each figure, an overlay for
        each step."""
        return self._core.beamer()

    def dxf(self, page: int = 0) -> str:
        """One page as a DXF drawing (AutoCAD 2007), mm."""
        return self._core.dxf()[page]

    def sentences(self, page: int = 0) -> str:
        """What a page of steps says; empty for other pages."""
        return self._core.sentences(page)

    def remarks(self, lang: str = "en") -> list[str]:
        """Warnings: characters that the font lacks, answers that the drawing does not show."""
        return self._core.remarks(lang)

    def save(self, path: PathLike, *, dpi: float = 150, text: Text = "outlines") -> list[Path]:
        """Writes .svg, .png, .dxf (further pages as x-2.svg …), .pdf or .tex; returns the paths."""
        whole = Path(path)
        ending = whole.suffix.lower()
        if ending == ".svg":
            contents = [each.encode() for each in self._core.svg(text)]
        elif ending == ".png":
            contents = [self.png(page, dpi=dpi) for page in range(self.pages)]
        elif ending == ".pdf":
            contents = [self.pdf(text=text)]
        elif ending == ".tex":
            contents = [self.tex().encode()]
        elif ending == ".dxf":
            contents = [each.encode() for each in self._core.dxf()]
        else:
            raise ValueError(f"{path}: a drawing ends in .svg, .png, .pdf, .tex or .dxf")
        paths = [numbered(whole, page) for page in range(len(contents))]
        for each, content in zip(paths, contents):
            each.write_bytes(content)
        return paths

    def _repr_svg_(self) -> str:
        return self.svg()

    def _repr_html_(self) -> str:
        """All pages as pictures: an SVG in the page itself would be rewritten by the filters of notebooks."""
        pages = (base64.b64encode(each.encode()).decode() for each in self._core.svg("outlines"))
        return "".join(f'<img src="data:image/svg+xml;base64,{page}" alt="page {number}" style="max-width:100%">'
                       for number, page in enumerate(pages, start=1))


class LivePage:
    """A page that moves in a browser: the mechanism is dragged and the construction follows."""

    def __init__(self, text: str) -> None:
        self.html = text
        """One file of HTML with all that it needs."""

    def save(self, path: PathLike) -> list[Path]:
        """Writes the page; returns its path in a list."""
        Path(path).write_text(self.html, encoding="utf-8")
        return [Path(path)]

    def _repr_html_(self) -> str:
        return (f'<iframe srcdoc="{html.escape(self.html)}" sandbox="allow-scripts" '
                'style="width:100%;height:42em;border:0" title="Kinegraph"></iframe>')


def joined(drawings: Sequence[Drawing]) -> Drawing:
    """The pages of several drawings in one document, for example the questions of a class."""
    return Drawing(_core.joined([each._core for each in drawings]))


def draw_pairs(**options: Unpack[DrawingOptions]) -> Drawing:
    """The illustrated catalogue of pairs."""
    return Drawing(_core.draw_pair_catalogue(for_core(options)))
