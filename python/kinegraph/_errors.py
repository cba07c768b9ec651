"""Faults of a file or of its geometry."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import NamedTuple

_Raw = tuple[str, str, Mapping[str, str], Mapping[str, str], Mapping[str, str]]


class Fault(NamedTuple):
    """One fault: where it is, what is wrong, what to do."""

    place: str
    """JSON pointer into the file ("/joints/2/bodies/1"); empty: the whole file."""
    message: str
    """What is wrong."""
    remedy: str
    """What to do, or what is wanted; empty where the message says it all."""
    kind: str = "bad input"
    """"bad input", "cannot meet" (curves), "no unique answer" (a dead point, a locked mechanism) or "output"."""


class Error(Exception):
    """A file, an argument or a position that cannot be worked with.

    `faults` has every fault at once, in the file's order and in English; `faults_in("it")` in another language.
    """

    def __init__(self, raw: Sequence[_Raw]) -> None:
        super().__init__(raw)
        self._raw = raw

    def faults_in(self, lang: str) -> list[Fault]:
        """The faults in a language: "en", "it", "fr", "de" or "es"."""
        return [Fault(place, fault[lang], remedy[lang], kind) for kind, place, _, fault, remedy in self._raw]

    @property
    def faults(self) -> list[Fault]:
        """The faults in English."""
        return self.faults_in("en")

    def __str__(self) -> str:
        return "\n".join((place + ": " if place else "") + text["en"] for _, place, text, _, _ in self._raw)
