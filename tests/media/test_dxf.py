"""DXF as ezdxf reads it: sound, and with what the SVG of the same page has."""
from __future__ import annotations

import math
import xml.etree.ElementTree as xml
from pathlib import Path

import ezdxf
import pytest
from ezdxf.addons.drawing import Frontend, RenderContext
from ezdxf.addons.drawing.matplotlib import MatplotlibBackend
from matplotlib.figure import Figure

SVG = "{http://www.w3.org/2000/svg}"
CASES = [
    ("four_bar", ()),
    ("slider_crank", ("--figure", "acceleration")),
    ("planetary_train", ("--theme", "print")),
    ("gas_force", ("--lang", "it")),
    ("gerber_beam", ("--theme", "dark")),
    ("contact/ball_on_plane", ()),
]


def opened(path: Path) -> ezdxf.document.Drawing:
    drawing = ezdxf.readfile(path)
    audit = drawing.audit()
    assert not audit.errors, [error.message for error in audit.errors]
    assert not audit.fixes, [fix.message for fix in audit.fixes]
    return drawing


def is_among(axis: tuple[float, ...], axes: list[tuple[float, ...]]) -> bool:
    """Both files round their coordinates, mm."""
    rounding = 2e-5
    return any(all(abs(a - b) <= rounding for a, b in zip(axis, other)) for other in axes)


def axes_of_svg(root: xml.Element, height: float) -> list[tuple[float, ...]]:
    """Vectors from tail to tip, y upwards."""
    found = []
    for line in root.iter(f"{SVG}line"):
        if line.get("class") == "axis":
            x1, y1, x2, y2 = (float(line.get(name, "nan")) for name in ("x1", "y1", "x2", "y2"))
            found.append((x1, height - y1, x2, height - y2))
    return found


def words_of_svg(root: xml.Element) -> str:
    parts = []
    for text in root.iter(f"{SVG}text"):
        parts += [text.text or ""]
        for span in text:
            # Marks of indices and combining dots are not drawn as letters.
            parts += ["" if span.get("fill") == "none" else "".join(span.itertext()), span.tail or ""]
    return "".join(parts)


def letters(text: str) -> list[str]:
    """Those of ASCII; signs that usual fonts lack are drawn."""
    return sorted(each for each in text if " " < each < "\x7f")


@pytest.mark.parametrize("example, options", CASES, ids=[case[0].replace("/", "_") for case in CASES])
def test_read_back(folder, example, options):
    folder.kinegraph("solve", example, "-o", "a.dxf", "-o", "a.svg", "--text", "live", *options)
    pages = folder.files("*.dxf")
    assert len(pages) == len(folder.files("*.svg"))
    for page in pages:
        drawing, root = opened(page), xml.parse(page.with_suffix(".svg")).getroot()
        space, height = drawing.modelspace(), float(root.get("height", "").removesuffix("mm"))
        assert drawing.units == ezdxf.units.MM
        axes = [(*line.dxf.start.vec2, *line.dxf.end.vec2) for line in space.query("LINE[layer=='axes']")]
        expected = axes_of_svg(root, height)
        assert len(axes) == len(expected)
        assert all(is_among(axis, expected) for axis in axes) and all(is_among(axis, axes) for axis in expected)
        assert drawing.layers.get("axes").is_off() if axes else True
        written = "".join(text.plain_text() for text in space.query("TEXT"))
        assert letters(written) == letters(words_of_svg(root))
        styles = {text.dxf.style for text in space.query("TEXT")}
        assert "KG-REGULAR" in styles and "KG-ITALIC" in styles
        for arc in space.query("ARC CIRCLE"):
            assert arc.dxf.radius > 0
        for each in space:
            assert drawing.layers.has_entry(each.dxf.layer)
            assert drawing.linetypes.has_entry(each.dxf.linetype)


def test_a_joint_is_where_it_is_in_the_svg(folder):
    folder.kinegraph("solve", "four_bar", "-o", "a.dxf", "-o", "a.svg", "--figure", "mechanism")
    root = xml.parse(folder.path / "a.svg").getroot()
    height = float(root.get("height", "").removesuffix("mm"))
    circles = opened(folder.path / "a.dxf").modelspace().query("CIRCLE[layer=='joints']")
    for name in ("O2", "A", "B", "O4"):
        group = next(each for each in root.iter(f"{SVG}g") if each.get("id") == f"joint-{name}")
        # A circle of the SVG begins at its right end: "M x y A r r …".
        course = next(iter(group.iter(f"{SVG}path"))).get("d", "")
        x, y, _, radius, *_ = course.replace("M", "").replace("A", " A ").split()
        centre = (float(x) - float(radius), height - float(y), float(radius))
        found = [(*circle.dxf.center.vec2, circle.dxf.radius) for circle in circles
                 if circle.has_xdata("KINEGRAPH") and circle.get_xdata("KINEGRAPH")[0].value == f"joint-{name}"]
        assert any(math.dist(each, centre) < 1e-4 for each in found), name


def test_it_is_drawn(folder):
    folder.kinegraph("solve", "four_bar", "-o", "a.dxf")
    drawing = opened(folder.path / "a.dxf")
    figure = Figure()
    axes = figure.add_axes((0, 0, 1, 1))
    Frontend(RenderContext(drawing), MatplotlibBackend(axes)).draw_layout(drawing.modelspace())
    left, right = axes.get_xlim()
    assert right - left > 250
