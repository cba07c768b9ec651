"""Prints the type stub of the builder, kinegraph/_builder.pyi, from the JSON Schema of the file."""

from __future__ import annotations

import textwrap

from ._builder import Method, Schema, alternatives, documentation, methods, python_name

_HEAD = '''# Made by `python3 -m kinegraph._stub` from the JSON Schema of the mechanism file.
from collections.abc import Iterator, Mapping, Sequence
from decimal import Decimal
from fractions import Fraction
from typing import Any, Literal, NamedTuple, Self

Schema = Mapping[str, Any]
Quantity = float | str | Decimal | Fraction

def schema() -> Schema: ...
def python_name(key: str) -> str: ...
def resolved(value: Schema) -> Schema: ...
def alternatives(value: Schema) -> Iterator[Schema]: ...
def forms(value: Schema) -> list[Schema]: ...
def leading_key(form: Schema) -> str: ...
def methods() -> tuple[Method, ...]: ...
def documentation(method: Method) -> str: ...
def circle(centre: str | Sequence[Any], radius: Quantity) -> dict[str, Any]: ...
def line(through: str | Sequence[Any], *, angle: Quantity = ..., to: str = ..., parallel: Any = ...,
         perpendicular: Any = ...) -> dict[str, Any]: ...

class Method(NamedTuple):
    name: str
    section: str
    holds: str
    entry: Schema
    leading: str = ...
    @property
    def forms(self) -> list[Schema]: ...
    @property
    def keys(self) -> dict[str, Schema]: ...
    @property
    def says(self) -> str: ...

class FileBuilder:
    def _contents(self) -> dict[str, Any]: ...
'''


def _one(value: Schema) -> set[str]:
    if "enum" in value:
        return {f"Literal[{', '.join(repr(each) for each in value['enum'])}]"}
    kinds = value.get("type", "any")
    kinds = [kinds] if isinstance(kinds, str) else kinds
    if "number" in kinds:
        return {"Quantity"}
    by_kind = {"string": "str", "boolean": "bool", "array": "Sequence[Any]", "object": "Mapping[str, Any]",
               "integer": "int", "any": "Any"}
    return {by_kind[kind] for kind in kinds}


def _one_of(value: Schema) -> set[str]:
    found: set[str] = set()
    for each in alternatives(value):
        found |= _one(each)
    return {"Any"} if "Any" in found else found


def _type(value: Schema) -> str:
    found = _one_of(value)
    return " | ".join(sorted(found - {"str", "int"} if "Quantity" in found else found))


def _signature(method: Method, name: str) -> str:
    before = {"map": "name: str | int, *value: Any", "list": "*entries: Any", "value": "*value: Any"}[method.holds]
    if method.leading:
        before = f"{python_name(method.leading)}: Any, *more: Any"
    keys = [f"{python_name(key)}: {_type(value)} = ..." for key, value in method.keys.items()]
    whole = " ".join(each.replace(" ", "\0") if len(each) < 90 else each for each in ", \n".join(["self", before, *keys]).split(" \n"))
    inner = textwrap.fill(whole + ")\0->\0Self:", 112, break_on_hyphens=False, break_long_words=False,
                          initial_indent=f"    def {name}(", subsequent_indent=" " * 12).replace("\0", " ")
    says = "\n".join(textwrap.fill(line, 112, initial_indent=" " * 8, subsequent_indent=" " * 12 if place else " " * 8)
                     for place, line in enumerate(documentation(method).split("\n")))
    return f'{inner}\n        """{says.strip()}"""\n'


def stub() -> str:
    """The text of kinegraph/_builder.pyi."""
    all_methods = [(each, each.name) for each in methods()]
    body = next(each for each in methods() if each.name == "body")
    return _HEAD + "".join(_signature(each, name) for each, name in [*all_methods, (body, "link")])


if __name__ == "__main__":
    print(stub(), end="")
