"""Values of Python as the text of a mechanism file, without loss of digits."""

from __future__ import annotations

import json
import math
from collections.abc import Iterable, Mapping
from decimal import Decimal
from fractions import Fraction
from typing import Any


def parsed(text: str) -> Any:
    """JSON whose decimals keep all their digits."""
    return json.loads(text, parse_float=Decimal)


def _number(value: float) -> str:
    if not math.isfinite(value):
        raise ValueError(f"{value} is no number of a mechanism file")
    return repr(value)


def _parts(value: Any, within: str) -> Iterable[str]:
    if hasattr(value, "tolist"):  # of NumPy: a number or an array
        value = value.tolist()
    if isinstance(value, bool) or value is None or isinstance(value, str):
        yield json.dumps(value, ensure_ascii=False)
    elif isinstance(value, int):
        yield str(value)
    elif isinstance(value, Decimal):
        if not value.is_finite():
            raise ValueError(f"{value} is no number of a mechanism file")
        yield str(value)
    elif isinstance(value, Fraction):
        yield json.dumps(f"= {value}") if value.denominator != 1 else str(value)
    elif isinstance(value, float):
        yield _number(value)
    elif isinstance(value, Mapping) and within and not any(isinstance(each, Mapping) for each in value.values()):
        yield "{" + ", ".join(f"{json.dumps(str(k), ensure_ascii=False)}: {''.join(_parts(v, within))}"
                              for k, v in value.items()) + "}"
    elif isinstance(value, Mapping):
        deeper = within + "  "
        inner = (f"{deeper}{json.dumps(str(k), ensure_ascii=False)}: {''.join(_parts(v, deeper))}"
                 for k, v in value.items())
        yield "{\n" + ",\n".join(inner) + "\n" + within + "}" if value else "{}"
    elif isinstance(value, Iterable):
        deeper = within + "  "
        parts = ["".join(_parts(each, deeper)) for each in value]
        is_long = sum(map(len, parts)) > 90
        yield "[\n" + ",\n".join(deeper + each for each in parts) + "\n" + within + "]" if is_long else (
            "[" + ", ".join(parts) + "]")
    else:
        raise TypeError(f"{type(value).__name__} has no place in a mechanism file")


def text_of(value: Any) -> str:
    """A mechanism file.

    A float is written by the shortest decimal that gives it again, which is what the source code of the caller says:
    0.1 is one tenth. A Decimal keeps all its digits; a Fraction becomes a formula, "= 1/3". Arrays and numbers of
    NumPy are written like those of Python.
    """
    return "".join(_parts(value, "")) + "\n"


def quantity(value: Any) -> str:
    """A value of a parameter, as a file writes it: 3, "45 mm", "= 2*r"."""
    if isinstance(value, str):
        return value
    if isinstance(value, Fraction):
        return f"= {value}" if value.denominator != 1 else str(value)
    return "".join(_parts(value, ""))
