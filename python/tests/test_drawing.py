"""Drawings have the bytes that the program writes."""

import base64
import math
import re
import struct

import pytest

import kinegraph


@pytest.fixture(scope="module")
def solution(examples):
    return kinegraph.load(examples / "four_bar.json").solve()


@pytest.mark.parametrize("ending", ["svg", "pdf", "png", "tex", "json", "html"])
def test_files_are_the_programs(solution, examples, program, tmp_path, ending):
    program("solve", examples / "four_bar.json", "-o", tmp_path / f"theirs.{ending}")
    (path,) = solution.save(tmp_path / f"ours.{ending}")
    assert path.read_bytes() == (tmp_path / f"theirs.{ending}").read_bytes()


def test_options_are_the_programs(solution, examples, program, tmp_path):
    program("solve", examples / "four_bar.json", "-o", tmp_path / "a.svg", "--figure", "velocity", "--lang", "it",
            "--theme", "print", "--text", "live")
    assert solution.svg(figure="velocity", lang="it", theme="print", text="live") == (tmp_path / "a.svg").read_text()
    program("solve", examples / "four_bar.json", "-o", tmp_path / "q.svg", "--sheet", "question", "--grid", "--paper",
            "A3", "--orientation", "portrait", "--author", "N. N.", "--date", "today")
    assert solution.svg(sheet="question", grid=True, paper="A3", orientation="portrait", author="N. N.",
                        date="today") == (tmp_path / "q.svg").read_text()


def test_every_figure_can_be_drawn_alone(solution):
    assert len(solution.figures) >= 3
    for figure in solution.figures:
        assert solution.draw(figure=figure).pages == 1


def test_wrong_options_are_refused(solution, tmp_path):
    with pytest.raises(TypeError, match="no option of a drawing is named"):
        solution.svg(colour="red")
    with pytest.raises(ValueError, match="there are A4, A3, letter"):
        solution.svg(paper="A5")
    with pytest.raises(kinegraph.Error) as caught:
        solution.svg(figure="velocty")
    assert "velocity" in caught.value.faults[0].remedy
    with pytest.raises(kinegraph.Error):
        solution.draw().png(dpi=5)
    with pytest.raises(ValueError, match="saved as"):
        solution.save(tmp_path / "x.doc")
    assert not (tmp_path / "x.doc").exists()


def test_further_pages_are_numbered(solution, tmp_path):
    paths = solution.save(tmp_path / "step.svg", steps=True)
    assert len(paths) > 3 and paths[1].name == "step-2.svg" and all(path.exists() for path in paths)


def test_png_has_its_resolution(solution):
    png = solution.draw().png(dpi=100)
    width, height = struct.unpack(">II", png[16:24])
    assert (width, height) == (math.ceil(297 / 25.4 * 100), math.ceil(210 / 25.4 * 100))


def test_theme_files(solution, tmp_path):
    theme = tmp_path / "theme.json"
    theme.write_text('{"based on": "print", "text": "#ff00ff"}')
    assert "ff00ff" in solution.svg(theme=str(theme)).lower() and "ff00ff" not in solution.svg(theme="print")
    theme.write_text('{"base": "print"}')
    with pytest.raises(kinegraph.Error) as caught:
        solution.svg(theme=str(theme))
    assert caught.value.faults[0].place == "/base"


def test_notebooks_show_them(solution, examples):
    assert solution._repr_svg_() == solution.svg()
    pictures = re.findall('src="data:image/svg.xml;base64,([^"]*)"', solution.draw(steps=True)._repr_html_())
    assert len(pictures) == solution.draw(steps=True).pages > 1
    assert base64.b64decode(pictures[1]).decode() == solution.svg(1, steps=True)
    page = solution.page()._repr_html_()
    assert page.startswith("<iframe srcdoc=") and "<script" not in page  # escaped within the attribute
    assert kinegraph.load(examples / "four_bar.json").sweep(steps=12)._repr_svg_()


def test_documents_are_joined(solution):
    both = kinegraph.joined([solution.draw(), solution.draw(sheet="question")])
    assert both.pages == solution.draw().pages + solution.draw(sheet="question").pages
    assert kinegraph.draw_pairs(lang="de").pages >= 1
    assert kinegraph.draw_all([solution, solution]).pages >= 2
