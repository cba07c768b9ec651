"""Kinegraph: planar mechanisms solved as at the drawing board, exactly.

    import kinegraph
    m = kinegraph.load("four_bar.json")
    s = m.solve()
    s["omega 3"]             # rad/s
    s.exact("omega 3")       # a Fraction, where the drawing is exact
    s.save("four_bar.pdf")   # the worked solution, to scale

All values are in SI units, angles in radians, rotations counter-clockwise positive. docs/python.md is the manual.
"""

from __future__ import annotations

from ._builder import circle, line, schema
from ._core import __version__, languages, pair_catalogue
from ._drawing import Drawing, DrawingOptions, LivePage, draw_pairs, joined
from ._errors import Error, Fault
from ._mechanism import Equations, Mechanism, load, parse
from ._motion import Cam, CamCycle, Pole, Separation, Sweep, load_cam
from ._solution import Check, Missing, Quantity, Solution, draw_all
from ._variants import Key, QuestionBank, Variant, Variants

__all__ = [
    "Cam", "CamCycle", "Check", "Drawing", "DrawingOptions", "Equations", "Error", "Fault", "Key", "LivePage",
    "Mechanism", "Missing", "Pole", "Quantity", "QuestionBank", "Separation", "Solution", "Sweep", "Variant",
    "Variants", "__version__", "circle", "draw_all", "draw_pairs", "joined", "languages", "line", "load", "load_cam",
    "pair_catalogue", "parse", "schema",
]
