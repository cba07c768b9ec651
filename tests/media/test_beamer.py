"""Slides for LaTeX beamer, made by both engines."""
from __future__ import annotations

import re

import pytest

from conftest import PROGRAM


def pages_of(folder, name: str) -> int:
    return int(re.search(r"^Pages: *(\d+)$", folder.run("pdfinfo", name), re.MULTILINE).group(1))


@pytest.mark.parametrize("example, engine, options", [
    ("four_bar", "pdflatex", ()),
    ("gas_force", "lualatex", ("--lang", "it")),
    ("contact/ball_against_wall", "pdflatex", ("--theme", "dark")),
])
def test_the_same_slides(folder, example, engine, options):
    folder.kinegraph("solve", example, "--steps", "--beamer", "-o", "a.tex", *options)
    folder.kinegraph("solve", example, "--steps", "--slides", "-o", "ours.png", "--dpi", "160", *options)
    for _ in range(2):
        folder.run(engine, "-interaction=nonstopmode", "-halt-on-error", "a.tex")
    slides = folder.files("ours*.png")
    assert pages_of(folder, "a.pdf") == len(slides)
    folder.run("pdftoppm", "-png", "-scale-to-x", "1280", "-scale-to-y", "720", "a.pdf", "theirs")
    for ours, theirs in zip(slides, folder.files("theirs*.png")):
        # The sentences are TeX's, and so are the letters: little else differs.
        folder.run(str(PROGRAM), "diff", str(ours), str(theirs), "--threshold", "4%", "--tolerance", "0.2")
    source = (folder.path / "a.tex").read_text()
    assert source.count("\\begin{frame}") < len(slides)
    assert "\\only<" in source and "\\kgsays{" in source
