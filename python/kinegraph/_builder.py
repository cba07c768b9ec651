"""Mechanism files written in code. The methods are made from the JSON Schema of the file, so a key that the file has
is a key here too: `python3 -m kinegraph._stub` prints their signatures.
"""

from __future__ import annotations

import json
import keyword
import re
from collections.abc import Callable, Iterator, Mapping, Sequence
from functools import cache
from typing import Any, NamedTuple

from . import _core

Schema = Mapping[str, Any]


@cache
def schema() -> Schema:
    """The JSON Schema of the mechanism file."""
    parsed: Schema = json.loads(_core.schema())
    return parsed


def python_name(key: str) -> str:
    """A key of the file as a name in Python: "pin-slot" is pin_slot, "from" is from_."""
    name = re.sub(r"[ -]", "_", key)
    return name + "_" if keyword.iskeyword(name) else name


def resolved(value: Schema) -> Schema:
    """Without its reference."""
    if "$ref" not in value:
        return value
    definition: Schema = schema()["definitions"][value["$ref"].rsplit("/", 1)[1]]
    return resolved(definition)


def alternatives(value: Schema) -> Iterator[Schema]:
    """What may stand in a place."""
    value = resolved(value)
    if "anyOf" in value:
        for each in value["anyOf"]:
            yield from alternatives(each)
    elif "allOf" in value:
        yield from alternatives(value["allOf"][0])
    else:
        yield value


def forms(value: Schema) -> list[Schema]:
    """The objects with keys of their own that may stand in a place."""
    return [each for each in alternatives(value) if "properties" in each]


def leading_key(form: Schema) -> str:
    """The key that tells a form from the others of its place."""
    required = form.get("required", [])
    return next(key for key in form["properties"] if key in required or not required)


class Method(NamedTuple):
    """A method of the builder: one for each section of the file, and one for each kind of entry with a name of its
    own."""

    name: str
    section: str
    holds: str  # "map", "list" or "value"
    entry: Schema  # of the entries, or of the value
    leading: str = ""  # the key of the first argument, of a kind of entry

    @property
    def forms(self) -> list[Schema]:
        all_forms = forms(self.entry)
        return [form for form in all_forms if leading_key(form) == self.leading] if self.leading else all_forms

    @property
    def keys(self) -> dict[str, Schema]:
        """The keys of its forms, without the leading one."""
        found: dict[str, Schema] = {}
        for form in self.forms:
            for key, value in form["properties"].items():
                if key != self.leading:
                    found.setdefault(key, value)
        return found

    @property
    def says(self) -> str:
        own = [form.get("description", "") for form in self.forms] if self.leading else []
        section = schema()["properties"][self.section]
        entry = "" if self.holds == "value" else resolved(self.entry).get("description", "")
        return " ".join(dict.fromkeys(filter(None, own))) or entry or section.get("description", "")


def _singular(section: str) -> str:
    for ending, one in (("ies", "y"), ("sses", "ss"), ("s", "")):
        if section.endswith(ending):
            return section[: -len(ending)] + one
    return section


def _section(key: str, value: Schema) -> Method:
    for each in alternatives(value):
        if "items" in each and "maxItems" not in each:
            return Method(_singular(key), key, "list", each["items"])
        if "additionalProperties" in each and "properties" not in each:
            return Method(_singular(key), key, "map", each["additionalProperties"])
    return Method(key, key, "value", value)


@cache
def methods() -> tuple[Method, ...]:
    """All methods, in the order of the file."""
    sections = [_section(key, value) for key, value in schema()["properties"].items() if key != "$schema"]
    kinds = [Method(leading, each.section, "list", each.entry, leading)
             for each in sections if each.holds == "list"
             for leading in dict.fromkeys(leading_key(form) for form in forms(each.entry))]
    names = [each.name for each in sections + kinds]
    own = [each for each in kinds if names.count(each.name) == 1]
    return tuple(each._replace(name=python_name(each.name)) for each in sections + own)


def _by_key(method: Method, given: Mapping[str, Any]) -> dict[str, Any]:
    known = {python_name(key): key for key in method.keys}
    for name in given:
        if name not in known:
            raise TypeError(f"{method.name}() has no key {name!r}; there are {', '.join(known) or 'none'}")
    return {known[name]: value for name, value in given.items()}


def _kind_of_entry(method: Method, given: tuple[Any, ...], keys: Mapping[str, Any]) -> dict[str, Any]:
    """An entry by its leading key: revolute("A", 2, 3), prismatic("B", 4, 1, along=0)."""
    if not given:
        raise TypeError(f"{method.name}() wants what stands under {method.leading!r}")
    entry = {method.leading: given[0]}
    rest: Any = given[1:]
    if rest:
        second = next(key for key in method.keys if key in method.forms[0].get("required", []))
        entry[second] = rest[0] if len(rest) == 1 and "items" not in resolved(method.keys[second]) else list(rest)
        if len(rest) == 1 and isinstance(rest[0], (list, tuple)):
            entry[second] = list(rest[0])
    return {**entry, **_by_key(method, keys)}


def _value(method: Method, given: tuple[Any, ...], keys: Mapping[str, Any]) -> Any:
    """An entry or a value: its keys, one value as it is, or several as an array."""
    if keys:
        whole = dict(given[0]) if given and isinstance(given[0], Mapping) else {}
        return {**whole, **_by_key(method, keys)}
    if not given:
        raise TypeError(f"{method.name}() wants a value")
    is_array = any("items" in each for each in alternatives(method.entry))
    if len(given) == 1 and not (is_array and isinstance(given[0], (str, int, float))):
        return given[0]
    return list(given)


def _add(data: dict[str, Any], method: Method, given: tuple[Any, ...], keys: Mapping[str, Any]) -> None:
    if method.holds == "value":
        value = _value(method, given, keys)
        before = data.get(method.section)
        data[method.section] = {**before, **value} if keys and isinstance(before, Mapping) else value
    elif method.holds == "map":
        if not given:
            raise TypeError(f"{method.name}() wants a name")
        data.setdefault(method.section, {})[str(given[0])] = _value(method, given[1:], keys)
    elif method.leading:
        data.setdefault(method.section, []).append(_kind_of_entry(method, given, keys))
    elif keys:
        data.setdefault(method.section, []).append(_value(method, given, keys))
    else:
        data.setdefault(method.section, []).extend(given)


def documentation(method: Method) -> str:
    """The text that help() shows."""
    first = {"list": f"Adds to {method.section!r}.", "map": f"Adds to {method.section!r}, under a name.",
             "value": f"Sets {method.section!r}."}[method.holds]
    lines = [f"{first} {method.says}".rstrip(), ""]
    for key, value in method.keys.items():
        says = value.get("description") or resolved(value).get("description", "")
        for part in value.get("allOf", ()) if not says else ():
            says = says or resolved(part).get("description", "")
        lines.append(f"{python_name(key)}: {says}".rstrip().rstrip(":"))
    return "\n".join(lines).strip()


class FileBuilder:
    """A mechanism file in the making. Every method returns the builder, so calls can be chained."""

    def _contents(self) -> dict[str, Any]:
        raise NotImplementedError


def _method(made_of: Method) -> Callable[..., Any]:
    def method(self: FileBuilder, *given: Any, **keys: Any) -> FileBuilder:
        _add(self._contents(), made_of, given, keys)
        return self

    method.__name__ = made_of.name
    method.__qualname__ = f"Mechanism.{made_of.name}"
    method.__doc__ = documentation(made_of)
    return method


for _each in methods():
    setattr(FileBuilder, _each.name, _method(_each))
# The word of the textbooks for a body.
setattr(FileBuilder, "link", getattr(FileBuilder, "body"))


def circle(centre: str | Sequence[Any], radius: Any) -> dict[str, Any]:
    """A curve on which a point lies: the circle about a point or a place [x, y]."""
    return {"circle": centre, "radius": radius}


def line(through: str | Sequence[Any], **direction: Any) -> dict[str, Any]:
    """A curve on which a point lies: the line through a point or a place [x, y], with one of `angle`, `to`,
    `parallel` and `perpendicular`."""
    return {"line": through, **direction}
