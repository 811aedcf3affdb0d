# SPDX-License-Identifier: MIT
"""Files of entries."""
from __future__ import annotations

import builtins
import os
from collections.abc import Iterator, Sequence
from typing import Union, overload

from . import _core
from .entry import Entry


class ParseError(ValueError):
    """Why a text, or an entry of it, cannot be read: `line` and `column` count from 1, the column in bytes."""

    def __init__(self, sentence: str, line: int, column: int, name: str = ""):
        super().__init__(f"line {line}, column {column}: {sentence}")
        self.line = line
        self.column = column
        self.name = name

    def __reduce__(self):
        sentence = str(self).split(": ", 1)[1]
        return ParseError, (sentence, self.line, self.column, self.name)


class Collection(Sequence):
    """The entries of a file in their order: by index, or by name as in Fractint, whatever the case.

    An entry that cannot be read raises its ParseError only when it is asked for.
    """

    def __init__(self, parts: Sequence[Union[Entry, ParseError]]):
        self._parts = tuple(parts)

    @property
    def names(self) -> list[str]:
        """All names, those of entries that cannot be read included."""
        return [part.name for part in self._parts]

    @property
    def errors(self) -> list[ParseError]:
        """Of the entries that cannot be read."""
        return [part for part in self._parts if isinstance(part, ParseError)]

    def __len__(self) -> int:
        return len(self._parts)

    @overload
    def __getitem__(self, key: Union[int, str]) -> Entry: ...
    @overload
    def __getitem__(self, key: slice) -> Collection: ...
    def __getitem__(self, key):
        if isinstance(key, slice):
            return Collection(self._parts[key])
        if isinstance(key, str):
            found = [part for part in self._parts if part.name == key]
            found += [part for part in self._parts if part.name.lower() == key.lower()]
            if not found:
                raise KeyError(key)
            part = found[0]
        else:
            part = self._parts[key]
        if isinstance(part, ParseError):
            raise part
        return part

    def __contains__(self, key: object) -> bool:
        if isinstance(key, str):
            return any(name.lower() == key.lower() for name in self.names)
        return any(part == key for part in self._parts)

    def __iter__(self) -> Iterator[Entry]:
        return (self[index] for index in range(len(self)))

    def __repr__(self) -> str:
        return f"<Collection of {', '.join(self.names)}>"


def _collection(text: bytes, bare_name: str) -> Collection:
    parts: list[Union[Entry, ParseError]] = []
    for part in _core.parse(text, bare_name):
        if isinstance(part, _core.Flaw):
            raise ParseError(part.sentence, part.line, part.column)
        if isinstance(part, tuple):
            name, flaw = part
            parts.append(ParseError(flaw.sentence, flaw.line, flaw.column, name))
        else:
            parts.append(Entry._of(part))
    return Collection(parts)


def open(path: Union[str, os.PathLike]) -> Collection:
    """The entries of an .ifs file, or of the ifs: entries of a .par file.

    Raises OSError where the file cannot be opened, and ParseError where it holds no entries.
    """
    with builtins.open(path, "rb") as file:
        text = file.read()
    return _collection(text, os.path.splitext(os.path.basename(os.fspath(path)))[0])


def parse(text: Union[str, bytes]) -> Collection:
    """The entries of a text. Raises ParseError where one of them cannot be read, or there are none.

    >>> dust = parse("dust { ; of Cantor\\n 1e0 0 0 1 0 0 .5\\n}")[0]
    >>> dust.classify().verdict
    'none'
    >>> parse("dust {\\n .5 0 0 .5 0 0 1\\n .5 0 x .5 0 0 1\\n}")
    Traceback (most recent call last):
        ...
    barycage.collection.ParseError: line 3, column 7: “x” is not a number.
    """
    read = _collection(text.encode() if isinstance(text, str) else bytes(text), "unnamed")
    for error in read.errors:
        raise error
    return read
